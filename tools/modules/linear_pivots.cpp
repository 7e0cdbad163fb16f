// SPDX-License-Identifier: Apache-2.0
#include "tools/modules/linear_pivots.hpp"

#include <fmt/format.h>

#include "mjcf/assembly/linear_joint.hpp"
#include "tools/modules/table_values.hpp"

namespace legwright {

void read_linear_pivots(TaskTable& in, Problems& problems, bool first, AssemblyJoint& joint) {
  const auto refuse = [&](std::string_view key, const std::string& message) {
    problems.add(in.line_of(key), in.full(key), message);
  };
  if (const auto lever = in.numbers("lever")) joint.lever = vector_of(*lever);
  if (const auto mount = in.numbers("mount")) joint.mount = vector_of(*mount);
  if (!joint.is_linear()) {
    for (const char* const key : {"lever", "mount"})
      if (in.has(key))
        refuse(key,
               "is of linear actuators, and a servo turns this joint; take it out, or name a "
               "linear actuator by servo");
    return;
  }
  if (first)
    return refuse("servo",
                  fmt::format("names {}, a linear actuator, for the first joint of a limb; "
                              "expected a servo there: linear actuators push from the "
                              "link above, at joints below it",
                              joint.servo.name));
  const std::string why = why_not_turned(joint);
  if (why.empty()) return;
  const char* const key = in.has("lever") ? "lever" : in.has("mount") ? "mount" : "servo";
  refuse(key, why);
}

}  // namespace legwright
