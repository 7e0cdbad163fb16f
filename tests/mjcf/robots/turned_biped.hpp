// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace legwright::test {

/// How the right leg of turned_biped() is drawn; the robot is mirrored in its home pose with each.
struct TurnedBiped {
  double turn = 0.0;   // of the right leg's first body about z [rad], taken back by what it carries
  double zero = 0.0;   // so far the right yaw hinge is drawn from where its mirror image is [rad]
  bool waist = false;  // both legs hang on a hinge below the trunk
};

/// A biped of three hinges a leg (yaw, pitch, knee), bent and with its toes out at home.
std::string turned_biped(const TurnedBiped& how);

}  // namespace legwright::test
