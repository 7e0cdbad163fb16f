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

/// A quaternion in MuJoCo's order, w x y z, made a unit one.
inline Eigen::Quaterniond quaternion_of(const mjtNum* wxyz) {
  return Eigen::Quaterniond(wxyz[0], wxyz[1], wxyz[2], wxyz[3]).normalized();
}

/// The rotation of such a quaternion.
inline Eigen::Matrix3d rotation_of(const mjtNum* wxyz) {
  return quaternion_of(wxyz).toRotationMatrix();
}

/// Rotation of an object by an array of mjModel that holds a quaternion for each.
inline Eigen::Matrix3d rotation_at(const mjtNum* array, int id) {
  return rotation_of(array + static_cast<std::ptrdiff_t>(4) * id);
}

/// Rotation of an object by an array of mjData that holds a matrix for each.
inline auto matrix_at(const mjtNum* array, int id) {
  return Eigen::Matrix<double, 3, 3, Eigen::RowMajor>::Map(array +
                                                           static_cast<std::ptrdiff_t>(9) * id);
}

}  // namespace legwright
