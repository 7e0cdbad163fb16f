// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/unread_ranges.hpp"

#include <fmt/format.h>

#include "mjcf/text/angle_words.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/listed.hpp"

namespace legwright {

std::vector<std::string> unread_ranges(const RobotModel& robot) {
  const ModelPointer model = compile_mjcf(robot.xml, robot.file);
  std::vector<std::string> names;
  std::string first;
  for (int j = 0; j < static_cast<int>(model->njnt); ++j) {
    const mjtNum* range = model->jnt_range + std::ptrdiff_t{2} * j;
    const bool given = range[0] != 0.0 || range[1] != 0.0;
    if (!robot.structure.moves[static_cast<std::size_t>(j)] || model->jnt_limited[j] || !given ||
        range[0] < range[1])
      continue;
    names.push_back(name_of(*model, mjOBJ_JOINT, j));
    if (names.size() == 1) first = angle_range_text(range[0], range[1], robot.in_degrees);
  }
  if (names.empty()) return {};
  return {fmt::format(
      "the range of {} ({}) has an upper end that is not above the lower one, as {}: MuJoCo does "
      "not limit such a joint, so any angle is planned; write the lower end first, or leave the "
      "range out",
      names.size() == 1 ? "a joint" : fmt::format("{} joints", names.size()), listed(names),
      first)};
}

}  // namespace legwright
