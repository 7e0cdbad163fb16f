// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/root_motion.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace legwright {
namespace {

// The coefficients a and b and their derivatives by θ²/2, so that d/dt is (o·ȯ) times those.
struct Coefficients {
  double a, b, a_rate, b_rate;
};

Coefficients coefficients(double angle) {
  const double t2 = angle * angle;
  if (angle < 0.05) {  // Taylor: the closed forms lose all digits here
    return {1.0 / 2 - t2 / 24 + t2 * t2 / 720, 1.0 / 6 - t2 / 120 + t2 * t2 / 5040,
            -1.0 / 12 + t2 / 180 - t2 * t2 / 6720, -1.0 / 60 + t2 / 1260 - t2 * t2 / 60480};
  }
  const double sine = std::sin(angle), cosine = std::cos(angle);
  const double a = (1 - cosine) / t2, b = (angle - sine) / (t2 * angle);
  return {a, b, (sine / angle - 2 * a) / t2, ((1 - cosine) / t2 - 3 * b) / t2};
}

}  // namespace

RootRotation root_rotation(const Eigen::Vector3d& o, const Eigen::Vector3d& rate,
                           const Eigen::Vector3d& second) {
  const double angle = o.norm(), half = angle / 2;
  const Coefficients c = coefficients(angle);
  const double sine_over_angle = angle < 1e-4 ? 0.5 - angle * angle / 48 : std::sin(half) / angle;
  RootRotation out;
  out.quaternion << std::cos(half), sine_over_angle * o;
  if (out.quaternion[0] < 0) out.quaternion = -out.quaternion;
  const double growth = o.dot(rate);  // half the derivative of θ²
  const auto turn = [&](const Eigen::Vector3d& v) -> Eigen::Vector3d {
    return v - c.a * o.cross(v) + c.b * o.cross(o.cross(v));
  };
  out.velocity = turn(rate);
  // d/dt of J, applied to ȯ; [ȯ]×ȯ = 0 removes two of the product's terms.
  out.acceleration = turn(second) - growth * c.a_rate * o.cross(rate) +
                     growth * c.b_rate * o.cross(o.cross(rate)) + c.b * rate.cross(o.cross(rate));
  return out;
}

}  // namespace legwright
