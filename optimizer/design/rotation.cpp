// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/rotation.hpp"

#include <cmath>

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// R(o) = I + A [o]× + B [o]×²; A = sin t / t, B = (1 − cos t)/t², t = ‖o‖, and their derivatives:
/// A1 = A′/t, A2 = A1′/t, likewise B, all of them even functions of t, hence smooth in o.
struct Coefficients {
  double A, B, A1, B1, A2, B2;
};

/// As far as derivatives of the order need them.
Coefficients coefficients(double t2, int order) {
  Coefficients c{};
  // Each quotient cancels more digits than the one before it; series below the angle where that
  // would show.
  if (t2 < 0.05) {
    c.A = 1 - t2 / 6 * (1 - t2 / 20 * (1 - t2 / 42 * (1 - t2 / 72 * (1 - t2 / 110))));
    c.B = 0.5 * (1 - t2 / 12 * (1 - t2 / 30 * (1 - t2 / 56 * (1 - t2 / 90 * (1 - t2 / 132)))));
    if (order == 0) return c;
    // A1 = Σ (−1)^n 2n t^(2n−2)/(2n+1)!, A2 = Σ (−1)^n 2n(2n−2) t^(2n−4)/(2n+1)!; B with (2n+2)!.
    double power1 = 1.0, power2 = 1.0, odd = 6.0, even = 24.0;
    for (int n = 1; n <= 8; ++n) {
      const double sign = n % 2 ? -1.0 : 1.0;
      c.A1 += sign * 2 * n * power1 / odd;
      c.B1 += sign * 2 * n * power1 / even;
      if (n >= 2 && order >= 2) {
        c.A2 += sign * 2 * n * (2 * n - 2) * power2 / odd;
        c.B2 += sign * 2 * n * (2 * n - 2) * power2 / even;
        power2 *= t2;
      }
      power1 *= t2;
      odd *= (2.0 * n + 2) * (2.0 * n + 3);
      even *= (2.0 * n + 3) * (2.0 * n + 4);
    }
  } else {
    const double t = std::sqrt(t2), cos_t = std::cos(t);
    c.A = std::sin(t) / t;
    c.B = (1 - cos_t) / t2;
    if (order == 0) return c;
    c.A1 = (cos_t - c.A) / t2;
    c.B1 = (c.A - 2 * c.B) / t2;
    c.A2 = (-c.A - 3 * c.A1) / t2;
    c.B2 = (c.A1 - 4 * c.B1) / t2;
  }
  return c;
}

}  // namespace

void rotation_of_vector(const Vector3d& o, int order, RotationDerivatives& out) {
  const Coefficients c = coefficients(o.squaredNorm(), order);
  const Matrix3d S = skew(o), S2 = S * S;
  out.rotation = Matrix3d::Identity() + c.A * S + c.B * S2;
  if (order == 0) return;
  const Matrix3d inverse = out.rotation.transpose();
  std::array<Matrix3d, 3> E, Q;  // ∂S/∂o_a and ∂S²/∂o_a
  for (int a = 0; a < 3; ++a) {
    E[a] = skew(Vector3d::Unit(a));
    Q[a] = E[a] * S + S * E[a];
    const Matrix3d first = c.A1 * o[a] * S + c.A * E[a] + c.B1 * o[a] * S2 + c.B * Q[a];
    out.turn[a] = unskew(first * inverse);
  }
  if (order == 1) return;
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b) {
      const double product = o[a] * o[b], same = a == b ? 1.0 : 0.0;
      const Matrix3d Qab = E[a] * E[b] + E[b] * E[a];
      const Matrix3d second =
          (c.A2 * product + c.A1 * same) * S + c.A1 * (o[a] * E[b] + o[b] * E[a]) +
          (c.B2 * product + c.B1 * same) * S2 + c.B1 * (o[a] * Q[b] + o[b] * Q[a]) + c.B * Qab;
      out.second[a][b] = out.second[b][a] = second * inverse;
    }
}

Eigen::Quaterniond smallest_rotation(const Vector3d& from, const Vector3d& to) {
  const Vector3d a = from.normalized(), b = to.normalized();
  const double cosine = b.dot(a);
  if (cosine < -1.0 + 1e-12) {
    Eigen::Index least = 0;
    a.cwiseAbs().minCoeff(&least);
    const Vector3d axis = (Vector3d::Unit(least) - a[least] * a).normalized();
    return {0.0, axis.x(), axis.y(), axis.z()};
  }
  const double s = std::sqrt((1.0 + cosine) * 2.0);
  Eigen::Quaterniond out;
  out.vec() = a.cross(b) * (1.0 / s);
  out.w() = s * 0.5;
  return out;
}

}  // namespace legwright
