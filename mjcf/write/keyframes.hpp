// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/text_edits.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// What a keyframe may give for its feet to stay where they stood.
enum class KeyframeEffort {
  angles,  // trunk height and the angles of each leg: every foot keeps its height
  height,  // trunk height only: the lowest foot keeps its height
  none,    // nothing: keyframes stay as they are
};

/// A keyframe in which the robot stands, as it is to be for another design.
struct StandingKey {
  int key = 0;                          // id in the compiled model
  const XmlElement* element = nullptr;  // of the file, with a qpos of its own
  Eigen::VectorXd qpos;                 // new numbers, as many as the model has
  Eigen::VectorXd ctrl;  // the same; follows the angles where an actuator is a position servo
  std::vector<double> foot_height;  // lowest point of each foot above the ground, before [m]
  bool every_foot = true;           // all keep their height; else the lowest of them does
};

/// The keyframes in which a foot stands near the ground, the trunk upright and clear of it, solved
/// anew for design s. The trunk keeps its orientation and its place from above; each foot keeps its
/// height, a flat one its tilt, and, as far as its joints allow, its place from above relative to
/// where its leg hangs on the trunk; joints stay in their ranges and near the angles that they had.
/// Keyframes that already fit are among them, with their numbers. All to 1e-10 m and rad.
/// @param model of the file as it is, at the initial design.
std::vector<StandingKey> solve_keyframes(const RobotModel& robot, const XmlFile& xml,
                                         const mjModel& model, const Eigen::VectorXd& s,
                                         KeyframeEffort effort);

/// A robot's files, and by how much the keyframe in them that was deepest in the ground rose [m].
struct LiftedKeyframes {
  RobotFiles files;
  double lifted = 0.0;
};

/// The robot as it is, but with its feet on the ground in keyframes in which it stands and its
/// lowest foot is deeper in the ground than 1 % of a leg's length, however deep: the trunk rises,
/// angles stay.
/// Where the file has ground of its own that is no plane at height zero, nothing changes.
LiftedKeyframes with_lifted_keyframes(const RobotModel& robot);

/// Writes the numbers that changed into qpos, and into ctrl where the keyframe has that.
void edit_keyframes(const mjModel& model, const std::vector<StandingKey>& keys, TextEdits& edits);

/// The first foot that stands at another height than wanted in the rewritten model, where MuJoCo
/// has it, in words; empty if there is none.
/// @param structure the feet. @param xml, model of the rewritten robot. @param tolerance [m]
std::string find_lifted_foot(const Structure& structure, const std::vector<StandingKey>& keys,
                             const XmlFile& xml, const mjModel& model, double tolerance = 1e-9);

}  // namespace legwright
