// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

#include "mjcf/read/robot_model.hpp"

namespace legwright {

/// A mesh beside a URDF.
struct UrdfMesh {
  std::string file, obj;  // name, text
};

/// A robot as URDF.
struct UrdfRobot {
  std::string text;
  std::vector<UrdfMesh> meshes;
  std::vector<std::string> joints;  // that move, in the order of the text
  std::vector<std::string> lost;    // what URDF cannot say, or says otherwise, a sentence each
};

/// The robot of a compiled model in URDF: its tree from the trunk on. A link's frame has the anchor
/// of its joint as origin and stands as the MJCF body does, so masses, inertias, axes and ranges
/// are those of the model. A body with several joints becomes a chain of links BODY__JOINT of 1e-12
/// kg and BODY itself. Each foot is a link NAME_foot_centre, fixed where the plan has its centre.
/// Angles are those of the MJCF, also where `ref` shifts them. Throws InputError for joints that
/// URDF has not.
/// @param mesh_prefix before the names of meshes: "meshes/", "package://mine/meshes/"
UrdfRobot urdf_of(const RobotModel& robot, const mjModel& model, const std::string& mesh_prefix);

}  // namespace legwright
