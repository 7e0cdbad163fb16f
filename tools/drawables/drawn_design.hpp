// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/mujoco_pointers.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {

/// The model of a robot at a design as it is drawn: what plans hold is fixed in the home pose.
/// Throws InputError where MuJoCo refuses it.
ModelPointer drawn_model(const RobotModel& robot, const Eigen::VectorXd& s);

/// Meshes that were told of, by what they are: one that comes again is not sent again. Any thread
/// may call.
class MeshStore {
 public:
  /// @param share of the triangles of each mesh that is kept
  explicit MeshStore(double share = 1.0) : share_(share) {}
  /// @return its id @param mesh of the model
  std::string add(const mjModel& model, int mesh);
  /// Vertices, normals and faces as JSON; null where there is none of this id.
  std::shared_ptr<const std::string> find(const std::string& id) const;

 private:
  double share_;
  mutable std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const std::string>> meshes_;
};

/// Bodies and what of them is seen, as a page draws it: {bodies, geoms}. Numbers of bodies are
/// those of the model.
Json drawables_json(const mjModel& model, MeshStore& meshes);
/// The same with the poses that `data` holds: {bodies, geoms, poses}, of each body place and unit
/// quaternion (wxyz) in the world, base64 of float32.
Json posed_drawables_json(const mjModel& model, const mjData& data, MeshStore& meshes);

}  // namespace legwright
