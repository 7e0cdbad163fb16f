// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "mjcf/read/read_robot.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {

/// How a design parameter is taken hold of on the robot.
enum class HandleKind {
  move,   // a point of a body goes along a direction
  turn,   // an axis turns about a direction
  scale,  // a face of a body goes along its normal
};
std::string_view to_string(HandleKind kind);

/// What a handle sits on, in a model: something whose place in its body is read from it.
struct HandleAnchor {
  enum class Kind { body, geom, site, joint, face } kind = Kind::body;
  int id = 0;    // of the body, geom, site or joint; of a face the body
  int body = 0;  // in whose frame place and direction are
  /// By how much the place goes with each unit of the parameter; of a turn the axis about which.
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
};

/// One parameter's handles: one for each mirrored or tied part of the robot.
struct Handle {
  HandleKind kind = HandleKind::move;
  std::vector<HandleAnchor> anchors;
};

/// Where an anchor is in its body [m], in this design.
Eigen::Vector3d place_of(const mjModel& model, const HandleAnchor& anchor);

/// Handles of all parameters, in their order; without anchors where nothing of the robot moves.
/// Found by differences between models of neighbouring designs, so whatever a file binds a
/// parameter to has one.
std::vector<Handle> find_handles(const RobotModel& robot, const Eigen::VectorXd& s);

/// {kind, body, at, direction, also: [{body, at, direction}]}, or null.
Json handle_json(const Handle& handle, const mjModel& model);
/// Places of all handles in this design: [[x, y, z], …] of each parameter.
Json places_json(const std::vector<Handle>& handles, const mjModel& model);

}  // namespace legwright
