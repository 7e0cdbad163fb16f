// SPDX-License-Identifier: Apache-2.0
#include "mjcf/write/verify.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

namespace legwright {
namespace {

/// Σ m p̂ p̂ᵀ with p̂ = (p, 1): second moments, mass times centre, mass.
Eigen::Matrix4d moments(const Link& link, const Eigen::VectorXd& s) {
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
  for (const PointMass& point : link.masses) {
    const Eigen::Vector4d p = point.at(s).homogeneous();
    sum += point.mass * point.growth_at(s) * p * p.transpose();
  }
  return sum;
}

}  // namespace

std::string find_difference(const Morphology& a, const Eigen::VectorXd& s_a, const Morphology& b,
                            const Eigen::VectorXd& s_b, double tolerance) {
  if (a.links.size() != b.links.size() || a.feet.size() != b.feet.size())
    return "number of links or feet";
  std::string found;
  // Written so that a NaN is a difference.
  const auto compare = [&](double error, double size, const std::string& what) {
    if (found.empty() && !(error <= tolerance * (1.0 + size)))
      found = fmt::format("{} differs by {}", what, error);
  };
  for (std::size_t l = 0; l < a.links.size(); ++l) {
    const Link &p = a.links[l], &q = b.links[l];
    if (p.name != q.name || p.parent != q.parent || p.joint.name != q.joint.name)
      return "link " + p.name;
    const Eigen::Vector3d origin = p.origin.at(s_a);
    compare((origin - q.origin.at(s_b)).norm(), origin.norm(), "origin of link " + p.name);
    compare((p.orientation - q.orientation).norm(), 0.0, "orientation of link " + p.name);
    if (l > 0)
      compare((p.joint.axis.at(s_a) - q.joint.axis.at(s_b)).norm(), 0.0,
              "axis of joint " + p.joint.name);
    const Eigen::Matrix4d mass_a = moments(p, s_a), mass_b = moments(q, s_b);
    const double mass = mass_a(3, 3), spread = mass_a.topLeftCorner<3, 3>().trace();
    compare(std::abs(mass - mass_b(3, 3)), mass, "mass of link " + p.name);
    // Relative to the link's own moments, else small links could change freely.
    if (mass > 0.0) {
      const Eigen::Vector3d first = mass_a.topRightCorner<3, 1>() - mass_b.topRightCorner<3, 1>();
      compare(first.norm() / mass, std::sqrt(spread / mass), "centre of mass of link " + p.name);
      compare((mass_a - mass_b).topLeftCorner<3, 3>().norm() / (spread + 1e-9 * mass), 0.0,
              "second moments of link " + p.name);
    }
  }
  for (std::size_t f = 0; f < a.feet.size(); ++f) {
    if (a.feet[f].name != b.feet[f].name || a.feet[f].link != b.feet[f].link)
      return "foot " + a.feet[f].name;
    compare((a.feet[f].position.at(s_a) - b.feet[f].position.at(s_b)).norm(), 0.0,
            "foot " + a.feet[f].name);
    compare(std::abs(a.feet[f].radius - b.feet[f].radius), 0.0, "radius of foot " + a.feet[f].name);
  }
  if (a.linear_actuators.size() != b.linear_actuators.size()) return "number of linear actuators";
  for (std::size_t k = 0; k < a.linear_actuators.size(); ++k) {
    const LinearActuator &p = a.linear_actuators[k], &q = b.linear_actuators[k];
    if (p.name != q.name || p.joint != q.joint) return "linear actuator " + p.name;
    const Eigen::Vector3d upper = p.upper.at(s_a), lower = p.lower.at(s_a);
    compare((upper - q.upper.at(s_b)).norm(), 0.0, "upper end of linear actuator " + p.name);
    compare((lower - q.lower.at(s_b)).norm(), 0.0, "lower end of linear actuator " + p.name);
  }
  return found;
}

}  // namespace legwright
