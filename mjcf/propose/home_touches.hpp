// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <filesystem>
#include <string>
#include <vector>

#include "mjcf/read/robot_model.hpp"

namespace legwright {

/// Two geoms of a robot that are inside each other in its home pose, as MuJoCo's collision
/// detection finds them, or two modules of its assembly.
struct HomeTouch {
  std::string first, second;  // "geom 'knee' of 'FL_shank'", "a capsule of 'FL_shank'",
                              // "module 'FL_knee_servo'"
  double depth = 0.0;         // [m]
  bool is_of_modules = false;
};

/// Touches of a design that the robot it comes from does not have: knees that were turned inwards,
/// hips that came too close, servos in each other. The deepest first. Both models are of one file,
/// so that geoms have the same ids.
/// @param file for messages; throws InputError there where the engine fails
std::vector<HomeTouch> new_home_touches(const mjModel& before, const mjModel& after,
                                        const std::filesystem::path& file);
/// The same of two robots' files, with all that they include. Throws InputError where one is no
/// model.
std::vector<HomeTouch> new_home_touches(const std::filesystem::path& before,
                                        const std::filesystem::path& after);

/// Two bodies whose geoms are inside each other in the home pose.
struct BodyTouch {
  std::string first, second;
  double depth = 0.0;  // [m], of the deepest pair of geoms
};
/// Those of a model, the deepest first; bodies without names are left out. Throws as above.
std::vector<BodyTouch> touching_bodies(const mjModel& model, const std::filesystem::path& file);

/// Links of a robot that overlap in its home pose, as MuJoCo would collide them when it is played:
/// a sentence with names, depths and the cure; none where there are none. Modules that stand inside
/// each other are for overlapping_modules() to tell. Throws as above.
std::vector<std::string> overlapping_links(const RobotModel& robot);

/// Links of a robot of which one hangs on the other by at most three hinges, with a link between,
/// and that overlap so in the home pose and wherever these hinges turn in their ranges: no gait
/// takes them apart. In the order of the file; without modules, and bodies without names.
std::vector<BodyTouch> lasting_overlaps(const RobotModel& robot);
/// What is done about them: "'thigh' in 'trunk' … overlap in every pose: <exclude> …".
std::string excluded_words(const std::vector<BodyTouch>& touches);

/// What there is to say of them, in a sentence with the cure; empty where there are none.
std::string describe(const std::vector<HomeTouch>& touches);

}  // namespace legwright
