// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <cstddef>

namespace legwright {

/// Entry of an array of mjModel that holds three numbers for each object.
inline Eigen::Vector3d vector_at(const mjtNum* array, int id) {
  return Eigen::Vector3d::Map(array + static_cast<std::ptrdiff_t>(3) * id);
}

/// Rotation of an object by an array of mjModel that holds a quaternion for each.
inline Eigen::Matrix3d rotation_at(const mjtNum* array, int id) {
  const mjtNum* const q = array + static_cast<std::ptrdiff_t>(4) * id;
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

}  // namespace legwright
