// SPDX-License-Identifier: Apache-2.0
#include "tools/modules/module_figures.hpp"

#include <algorithm>

namespace legwright {

const std::vector<std::string_view>& module_figures() {
  static const std::vector<std::string_view> figures{"mass",
                                                     "cable",
                                                     "voltage",
                                                     "outline",
                                                     "joint.position",
                                                     "joint.stall_torque",
                                                     "joint.continuous_torque",
                                                     "joint.no_load_speed",
                                                     "joint.gear_ratio",
                                                     "joint.reflected_inertia",
                                                     "joint.friction",
                                                     "joint.damping",
                                                     "joint.range",
                                                     "joint.kp",
                                                     "joint.kd",
                                                     "slide.position",
                                                     "slide.retracted_length",
                                                     "slide.stroke",
                                                     "slide.max_force",
                                                     "slide.stall_force",
                                                     "slide.continuous_force",
                                                     "slide.no_load_speed",
                                                     "slide.backdrive_force",
                                                     "slide.gear_ratio",
                                                     "slide.reflected_mass",
                                                     "slide.kp",
                                                     "slide.kd",
                                                     "foot.friction",
                                                     "attachment.screws"};
  return figures;
}

bool is_asked_for(ModuleKind kind, std::string_view figure) {
  static const std::vector<std::string_view> of_servos{
      "voltage",          "joint.continuous_torque", "joint.no_load_speed",
      "joint.gear_ratio", "joint.reflected_inertia", "joint.friction",
      "joint.range",      "attachment.screws"};
  static const std::vector<std::string_view> of_linear{"voltage",
                                                       "slide.stall_force",
                                                       "slide.continuous_force",
                                                       "slide.no_load_speed",
                                                       "slide.backdrive_force",
                                                       "slide.gear_ratio",
                                                       "slide.reflected_mass",
                                                       "attachment.screws"};
  const auto among = [&](const std::vector<std::string_view>& figures) {
    return std::find(figures.begin(), figures.end(), figure) != figures.end();
  };
  if (kind == ModuleKind::servo) return among(of_servos);
  return kind == ModuleKind::linear && among(of_linear);
}

}  // namespace legwright
