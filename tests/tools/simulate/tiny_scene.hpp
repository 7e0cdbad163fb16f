// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace legwright {

/// A table on four ball feet with a tail that a servo wags: the smallest thing that can be played
/// and measured.
struct TinyScene {
  static constexpr double kPeriod = 0.4;      // of the plan [s]
  static constexpr double kTimeStep = 0.001;  // of the physics [s]

  std::string start_qpos = "0 0 0.1 1 0 0 0 0";  // root, tail
  std::string start_qvel = "0 0 0 0 0 0 0";
  double friction = 0.8;       // 0: none
  double torque_limit = 1.0;   // of the tail's servo [N m]
  double wag = 0.2;            // amplitude of the tail [rad]
  bool swinging_foot = false;  // the plan lifts foot FL in the second half of its period

  std::string xml() const;
};

}  // namespace legwright
