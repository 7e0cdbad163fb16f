// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace legwright {

/// [v]×, so that skew(v)·w = v × w.
inline Eigen::Matrix3d skew(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return m;
}

/// The vector of a skew-symmetric matrix: unskew(skew(v)) = v.
inline Eigen::Vector3d unskew(const Eigen::Matrix3d& m) {
  return 0.5 * Eigen::Vector3d(m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1));
}

/// A rotation as a function of up to three numbers c, with its derivatives written as rotations:
/// ∂R/∂c_a = [turn_a]× R and ∂²R/∂c_a∂c_b = second_ab R. All in the frame in which R acts from the
/// left.
struct RotationDerivatives {
  Eigen::Matrix3d rotation;
  std::array<Eigen::Vector3d, 3> turn;                   // spatial rate per unit of c_a
  std::array<std::array<Eigen::Matrix3d, 3>, 3> second;  // symmetric in a, b
};

/// R(o) of a rotation vector o [rad] (Rodrigues), with exact first and second derivatives; smooth
/// at o = 0.
/// @param order of the derivatives that are wanted, 0 to 2; the others are left alone.
void rotation_of_vector(const Eigen::Vector3d& o, int order, RotationDerivatives& out);

/// R = cos q I + sin q [a]× + (1 − cos q) a aᵀ about the unit axis a by the angle q.
inline Eigen::Matrix3d rotation_about(const Eigen::Vector3d& axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const double x = axis[0], y = axis[1], z = axis[2];
  const double kx = (1 - c) * x, ky = (1 - c) * y, kz = (1 - c) * z;
  Eigen::Matrix3d R;
  R << c + kx * x, -s * z + kx * y, s * y + kx * z,  //
      s * z + ky * x, c + ky * y, -s * x + ky * z,   //
      -s * y + kz * x, s * x + kz * y, c + kz * z;
  return R;
}

/// The smallest rotation that takes one direction to another, of any lengths but zero. From a
/// cosine of 1e-12 above −1 on it is a half turn, about the first coordinate axis to which `from`
/// is most perpendicular: about x for `from` = z, as MuJoCo has it for `zaxis`. Eigen's
/// FromTwoVectors gives the same bits but for half turns, and compiles for seconds.
Eigen::Quaterniond smallest_rotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace legwright
