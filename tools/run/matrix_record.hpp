// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tools/run/metrics_record.hpp"
#include "tools/run/run_record.hpp"

namespace legwright {

struct MatrixDesignRecord {
  std::string name, start;
};
void fields(Fields& f, MatrixDesignRecord& design);

/// A design in a task.
struct MatrixCellRecord {
  double F = 0.0;
  bool pass = false;
  std::string line;           // of the verdict
  ByName<GainMetrics> gains;  // as metrics.json tells them
};
void fields(Fields& f, MatrixCellRecord& cell);

/// result/matrix.json of a joint run: every design in every task.
struct MatrixRecord {
  static constexpr RecordKind kKind{"legwright/matrix", 1, "validate"};
  std::vector<MatrixDesignRecord> designs;
  ByName<std::vector<MatrixCellRecord>> cells;  // by task, in the order of the designs
  bool pass = false;
  std::optional<JudgedSums> of = {};
  std::optional<JudgedSums> with = {};  // SHA-256 of the tasks' verdicts, by their paths
};
void fields(Fields& f, MatrixRecord& matrix);

/// result/front.json of a joint run of two tasks.
struct FrontRecord {
  static constexpr RecordKind kKind{"legwright/front", 1, "optimize"};
  std::string weight_of;
  std::vector<FrontPointRecord> points;
};
void fields(Fields& f, FrontRecord& front);

}  // namespace legwright
