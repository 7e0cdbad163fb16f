// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>
#include <tinyxml2.h>

#include <Eigen/Core>
#include <string>

#include "optimizer/design/morphology.hpp"

namespace legwright {

/// The surroundings of a robot in its DOM: what is looked at and what is walked on.
/// All lengths follow the robot's size, so that a palm-sized and a man-sized one look alike.
struct SceneView {
  double radius;                    // about the middle of the standing robot [m]
  double leg_length;                // [m]
  Eigen::Vector3d centre;           // of the view [m]
  Eigen::Vector3d right, up, back;  // camera axes, world
  double distance;                  // of the camera [m]
};

/// Looks at the robot so that the travel goes from left to right, a little from the front and
/// above. @param up in the picture: against gravity
SceneView scene_view(const Morphology& morphology, const Eigen::VectorXd& s,
                     const Eigen::Vector3d& travel, const Eigen::Vector3d& up);

/// Adds <option>, <visual>, <statistic>. An arrow of the robot's weight is 2.5 legs long. The head
/// light is the robot's where it brings a light. @param time_step [s]
void add_settings(tinyxml2::XMLElement& root, const mjModel& robot, const SceneView& view,
                  double time_step);
/// Adds floor and sky. The floor's contact settings hold against any of the robot's.
/// @return the floor's name: "floor" where the robot has no geom of this name
std::string add_floor(tinyxml2::XMLElement& root, const mjModel& robot, const SceneView& view,
                      double friction);
/// Adds the still camera "side".
void add_side_camera(tinyxml2::XMLElement& root, const SceneView& view,
                     const std::string& name = "side");
/// Adds to the trunk what follows it: camera "track" and, if the robot brings none, the light that
/// casts its shadow.
/// @param trunk_orientation world ← trunk in the file's reference pose.
/// @param lit whether the robot has a light: with one more the picture is overexposed
void add_followers(tinyxml2::XMLElement& trunk, const SceneView& view,
                   const Eigen::Matrix3d& trunk_orientation, bool lit);
/// Whether the robot brings a light of its own that is switched on.
bool has_light(const mjModel& robot);

/// The first child of this tag, made at the end if there is none.
tinyxml2::XMLElement& section(tinyxml2::XMLElement& root, const char* tag);
/// A new last child.
tinyxml2::XMLElement& add(tinyxml2::XMLElement& parent, const char* tag);

}  // namespace legwright
