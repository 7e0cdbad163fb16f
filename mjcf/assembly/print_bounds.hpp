// SPDX-License-Identifier: Apache-2.0
// What printing asks of a design, as bounds of its parameters: no search leaves them.
#pragma once

#include <string>
#include <vector>

#include "mjcf/assembly/robot_assembly.hpp"
#include "mjcf/propose/proposal.hpp"

namespace legwright {

struct PrintBounds {
  std::vector<Proposal> proposals;    // those that stay, some with narrower bounds
  std::vector<std::string> left_out;  // "front_hip_axis_yaw: why", one each
  std::vector<std::string> notes;     // what was narrowed
};

/// The design parameters of a printed robot, `Assembly::print`, within which its parts fit:
/// - Lengths of links: the far module and the part keep clear of the servo that turns the link and
///   of what carries that, at each sampled angle of the range at which they do as drawn; servos
///   that are too near at all of them come no nearer. No two points of a part are farther apart
///   than the shorter side of the bed.
/// - Length and width of the trunk: servos and parts on it keep the clearance where they do as
///   drawn; the tray with its cradles lies on the bed. The second at the least of the first.
/// Axes are no proposals of such a robot (printed_robot.hpp).
/// Of the bed counts what its margins leave; what is larger as drawn may not grow. Bounds are
/// sampled on the way from the drawn design, and found to 1e-5 of a length.
/// @param proposals of the robot as it was built
PrintBounds print_bounds(const Assembly& assembly, const std::vector<Proposal>& proposals);

}  // namespace legwright
