// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "tools/choose/physics_trial.hpp"
#include "tools/task/problem.hpp"

namespace legwright {

/// What the search asks of a plan beyond the task once MuJoCo did not pass it. F does not know
/// servos that lag or saturate; each lever tightens or eases what stands for that in F.
enum class Lever {
  margins,         // torque margin, least normal force and friction farther from their edges
  smooth_forces,   // weight of force_smoothness
  quick_legs,      // less weight of smoothness: feet are where they should be when they land
  smooth_legs,     // more weight of smoothness
  long_stance,     // feet planted one knot longer before and after they carry load
  short_stance,    // one knot shorter
  low_swing,       // lower steps
  narrow,          // feet nearer to the line of travel
  wide,            // feet farther from it
  aim,             // a speed and a turn that make up for what MuJoCo loses of them
  near_given_body  // weight of design_tether: a body nearer to the one that was given
};
inline constexpr int kLeverCount = 11;

/// How often each lever is pulled.
struct Tightening {
  std::array<int, kLeverCount> pulls{};
  double speed = 1.0;  // factor on the planned speed, by Lever::aim
  double turn = 0.0;   // added to the planned turn, by the same [rad a cycle]

  bool any() const;
  /// @param seen what MuJoCo made of the plan so far
  Tightening with(Lever lever, const GaitTrial& seen) const;
  /// "margins x2, smoother forces": for people; empty where nothing is pulled.
  std::string words() const;
};

/// The keys of task k of a problem as tightened. Throws InputError where there is no such task.
TaskFile tightened_file(const CodesignProblem& problem, int k, const Tightening& tightening);
/// The task that they make. Throws InputError where there is no such task.
Task tightened_task(const CodesignProblem& problem, int k, const Tightening& tightening);

}  // namespace legwright
