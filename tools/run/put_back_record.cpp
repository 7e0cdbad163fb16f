// SPDX-License-Identifier: Apache-2.0
#include "tools/run/put_back_record.hpp"

namespace legwright {

void fields(Fields& f, PutBackRecord& row) {
  f("parameter", row.parameter);
  f("F", row.F, "with it at its old value, less F of the result; null without a motion");
  f("J", row.J, "the same of the outer objective");
  f("terms", row.terms, "the same of each term of F");
  f("F_tasks", row.F_tasks, "of a joint run: the same of each task, where F is the weighted sum");
  f("status", row.status, "of the motion");
  f("played", row.played,
    "what MuJoCo says of that design within a few cycles; not where F changes by less than 1 %");
}

}  // namespace legwright
