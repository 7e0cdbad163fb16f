// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

namespace legwright {

/// Something that two models have differently.
struct Difference {
  std::string element;   // "body 'FL_thigh'"
  std::string quantity;  // "mass"; "only in A" or "only in B" for a whole element
  std::string unit;      // m, rad, kg, kg m², N m, …; empty for counts
  std::vector<double> before, after;
  double size = 0.0;  // of the difference, in the unit: its largest entry, or an angle

  bool whole() const { return before.empty(); }
};

/// What differs between two compiled models, element by element, matched by name (unnamed ones by
/// their order on a body of the same name). Bodies: mass, inertia, place, parent. Joints: type,
/// axis, anchor, range, limits, stiffness, damping, armature. Geoms: type, place, size, friction,
/// what they collide with. Sites, tendons, actuators (force range, gear, gain, bias), keyframes.
/// Declared design parameters: value, bounds, unit and binding. Lengths in m, angles in rad.
/// Materials, assets and options are not compared.
/// @param tolerance differences up to it, in units of each quantity, are none.
std::vector<Difference> model_differences(const mjModel& before, const mjModel& after,
                                          double tolerance = 1e-9);

/// Whether a difference is what rounding and the digits of a file leave: no more than `tolerance`
/// of the quantity's largest number, or of 1 m, 1 rad, 1 kg, … (of 1e-6 kg m²) where that is less.
bool is_dust(const Difference& difference, double tolerance);

}  // namespace legwright
