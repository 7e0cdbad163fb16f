// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace legwright::test {

/// A biped with box feet without names, built from one side's text. On its trunk ride an arm (a
/// hinge that is bent at home, a ball, two fingers that slide and are coupled by an equality
/// constraint, a fixed tendon that drives both), and a lidar without actuator, in a frame.
std::string armed_biped();

/// A quadruped built as public ones are: a tree of classes, legs mirrored by sign, drawn meshes in
/// group 2, unnamed foot balls whose place and size their class holds, torque motors with the
/// class's ctrlrange, a keyframe.
std::string classed_quadruped();

/// A quadruped of position servos with `inheritrange` whose arm of six hinges is folded on its
/// back.
std::string quadruped_with_arm();

/// One leg under a trunk; `foot` is the content of its shank, 0.2 m below the knee; at home the
/// shank leans by `knee` [rad]. A mesh `shoe` is there to be used.
/// @param weighed_by_foot whether the shank has no <inertial>
std::string hopper_with(const std::string& foot, double knee = 0.0, bool weighed_by_foot = false);

/// The robot with the parameters that `legwright init` proposes.
std::string declared(const std::string& xml);
/// Why a robot is refused; empty if it is not.
std::string error_message(const std::string& xml);
bool holds(const std::string& text, const std::string& part);

}  // namespace legwright::test
