// SPDX-License-Identifier: Apache-2.0
#include "tools/run/matrix_record.hpp"

namespace legwright {

void fields(Fields& f, MatrixDesignRecord& design) {
  f("name", design.name);
  f("start", design.start);
}

void fields(Fields& f, MatrixCellRecord& cell) {
  f("F", cell.F);
  f("pass", cell.pass, "by the roll-outs at the gains alone");
  f("line", cell.line, "of the verdict");
  f("gains", cell.gains, "what the roll-outs at each servo gain measured, as in metrics.json");
}

void fields(Fields& f, MatrixRecord& matrix) {
  f("designs", matrix.designs);
  f("cells", matrix.cells, "by task, in the order of the designs");
  f("pass", matrix.pass, "whether the common design passes in each task");
  of_field(f, matrix.of);
  f("with", matrix.with, "SHA-256 sums of the tasks' verdicts, by their paths in the run's folder");
}

void fields(Fields& f, FrontRecord& front) {
  f("weight_of", front.weight_of, "the task that the weights are of");
  f("points", front.points);
}

}  // namespace legwright
