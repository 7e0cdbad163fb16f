// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace legwright {

/// A rotation that follows a rotation vector o(t), as MuJoCo's free joint wants it.
struct RootRotation {
  Eigen::Vector4d quaternion;    // world from trunk: w, x, y, z; w ≥ 0
  Eigen::Vector3d velocity;      // angular, trunk frame [rad/s]
  Eigen::Vector3d acceleration;  // its derivative [rad/s²]
};

/// ω = J(o)·ȯ in the turning frame with J = I − a[o]× + b[o]×², a = (1 − cos θ)/θ², b = (θ − sin
/// θ)/θ³, θ = |o|, and its exact derivative; smooth at o = 0.
/// @param o rotation vector [rad], with its first and second derivatives by time.
RootRotation root_rotation(const Eigen::Vector3d& o, const Eigen::Vector3d& rate,
                           const Eigen::Vector3d& second);

}  // namespace legwright
