// SPDX-License-Identifier: Apache-2.0
#include "tools/modules/slide_table.hpp"

#include <fmt/format.h>

#include "tools/modules/table_values.hpp"

namespace legwright {
namespace {

void check_forces(TaskTable& in, Problems& problems, const ModuleSlide& slide) {
  if (!in.has("max_force")) return;
  const auto refuse = [&](const char* key, double value, const char* relation, const char* wanted) {
    problems.add(in.line_of(key), in.full(key),
                 fmt::format("is {}, {} max_force, {}; expected {}", value, relation,
                             slide.most_force, wanted));
  };
  if (slide.stall_force && *slide.stall_force < slide.most_force)
    refuse("stall_force", *slide.stall_force, "below", "as much or more");
  if (slide.continuous_force && *slide.continuous_force > slide.most_force)
    refuse("continuous_force", *slide.continuous_force, "above", "no more");
}

}  // namespace

ModuleSlide read_slide_table(TaskTable& in, Problems& problems, bool needed) {
  ModuleSlide slide;
  const auto position = in.numbers("position");
  in.require(position || !needed, "position", "position = [0.0, 0.0, -0.05]");
  if (position) slide.position = vector_of(*position);
  slide.axis = direction_in(in, "axis", problems).value_or(Eigen::Vector3d::UnitZ());
  const auto needed_number = [&](std::string_view key, const char* example) {
    const auto value = in.number(key);
    in.require(value || !needed, key, example);
    return value.value_or(1.0);
  };
  slide.retracted = needed_number("retracted_length", "retracted_length = 0.118");
  slide.stroke = needed_number("stroke", "stroke = 0.05");
  slide.most_force = needed_number("max_force", "max_force = 50.0");
  slide.stall_force = in.number("stall_force");
  slide.continuous_force = in.number("continuous_force");
  slide.no_load_speed = in.number("no_load_speed");
  slide.backdrive_force = in.number("backdrive_force");
  slide.gear_ratio = in.number("gear_ratio");
  slide.reflected_mass = in.number("reflected_mass");
  slide.kp = in.number("kp");
  slide.kd = in.number("kd");
  check_forces(in, problems, slide);
  in.finish();
  return slide;
}

}  // namespace legwright
