// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace legwright {

// Sums and products in space, number by number. Eigen works on pairs: where a pair is read that was
// just written as two halves the processor waits, and the kinematics of a robot is nothing but
// that. To the bits of Eigen's own: where M v reads M by columns, the third row adds from
// the right.

/// Three numbers that stay in registers.
struct Scalars3 {
  double x, y, z;
};

template <class Vector>
[[gnu::always_inline]] inline Scalars3 scalars(const Vector& v) {
  return {v[0], v[1], v[2]};
}

[[gnu::always_inline]] inline Scalars3 cross(const Scalars3& a, const Scalars3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[gnu::always_inline]] inline Scalars3 operator+(const Scalars3& a, const Scalars3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[gnu::always_inline]] inline Scalars3 operator-(const Scalars3& a, const Scalars3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[gnu::always_inline]] inline Scalars3 operator-(const Scalars3& a) { return {-a.x, -a.y, -a.z}; }
[[gnu::always_inline]] inline Scalars3 operator*(double s, const Scalars3& a) {
  return {s * a.x, s * a.y, s * a.z};
}
[[gnu::always_inline]] inline double dot(const Scalars3& a, const Scalars3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// M v, M of 3 × 3.
template <class Matrix>
[[gnu::always_inline]] inline Scalars3 product(const Matrix& M, const Scalars3& v) {
  return {M(0, 0) * v.x + M(0, 1) * v.y + M(0, 2) * v.z,
          M(1, 0) * v.x + M(1, 1) * v.y + M(1, 2) * v.z,
          M(2, 0) * v.x + (M(2, 1) * v.y + M(2, 2) * v.z)};
}

/// Mᵀ v, M of 3 × 3.
template <class Matrix>
[[gnu::always_inline]] inline Scalars3 transposed_product(const Matrix& M, const Scalars3& v) {
  return {M(0, 0) * v.x + M(1, 0) * v.y + M(2, 0) * v.z,
          M(0, 1) * v.x + M(1, 1) * v.y + M(2, 1) * v.z,
          M(0, 2) * v.x + M(1, 2) * v.y + M(2, 2) * v.z};
}

template <class Target>
[[gnu::always_inline]] inline void store(const Scalars3& v, Target&& target) {
  target[0] = v.x;
  target[1] = v.y;
  target[2] = v.z;
}

}  // namespace legwright
