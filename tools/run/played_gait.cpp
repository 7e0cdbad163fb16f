// SPDX-License-Identifier: Apache-2.0
#include "tools/run/played_gait.hpp"

namespace legwright {

void fields(Fields& f, PlayedGait& gait) {
  f("merit", gait.merit, "distance from the task; null where it fell");
  f("pass", gait.pass);
  f("line", gait.line, "of the verdict");
}

}  // namespace legwright
