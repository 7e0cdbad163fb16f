// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/inertia.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "optimizer/design/rotation.hpp"

namespace legwright {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::Vector4d;

/// ∂v/√m of a point by one parameter: [u_k; 0] + a_k [u; 1] with a_k = ∂ log √m/∂s_k.
struct Slope {
  int parameter;
  Vector4d slope = Vector4d::Zero();  // [u_k; 0]
  double growth = 0.0;                // a_k
};

std::vector<Slope> slopes_of(const PointMass& point, const AxisAtDesign& arm,
                             const Eigen::VectorXd& s) {
  std::vector<Slope> slopes;
  const auto at = [&slopes](int parameter) -> Slope& {
    for (Slope& slope : slopes)
      if (slope.parameter == parameter) return slope;
    return slopes.emplace_back(Slope{parameter});
  };
  for (const AffineVector::Slope& slope : point.position.slopes)
    at(slope.parameter).slope.head<3>() += slope.slope;
  for (std::size_t k = 0; k < arm.parameters.size(); ++k)
    at(arm.parameters[k]).slope.head<3>() += arm.first[k];
  for (const PointMass::Growth& growth : point.growth)
    at(growth.parameter).growth += 0.5 / s[growth.parameter];
  return slopes;
}

/// Adds what an arm that turns has of second derivatives, and nothing else: Σ m [u_kl; 0] [u; 1]ᵀ.
void add_bends(const AxisAtDesign& arm, double mass, const Vector4d& u,
               std::vector<InnerMotion>& inner) {
  const auto index = [&inner](int parameter) {
    const auto found = std::find_if(inner.begin(), inner.end(),
                                    [&](const InnerMotion& i) { return i.parameter == parameter; });
    return static_cast<std::size_t>(found - inner.begin());
  };
  for (std::size_t k = 0; k < arm.parameters.size(); ++k)
    for (std::size_t l = 0; l < arm.parameters.size(); ++l)
      inner[index(arm.parameters[k])].seconds[index(arm.parameters[l])].topRows<3>() +=
          mass * arm.second[k][l] * u.transpose();
}

/// Σ over point masses of what parameter k does to them.
std::vector<InnerMotion> inner_motion(const Link& link, const Eigen::VectorXd& s) {
  std::vector<InnerMotion> inner;
  const auto find = [&inner](int parameter) {
    return std::find_if(inner.begin(), inner.end(),
                        [&](const InnerMotion& i) { return i.parameter == parameter; });
  };
  for (const PointMass& point : link.masses)
    for (const Slope& slope : slopes_of(point, axis_at(point.arm, s), s))
      if (find(slope.parameter) == inner.end())
        inner.push_back({slope.parameter, Vector4d::Zero(), Matrix4d::Zero(), {}, {}});
  for (InnerMotion& k : inner) {
    k.products.assign(inner.size(), Matrix4d::Zero());
    k.seconds.assign(inner.size(), Matrix4d::Zero());
  }
  for (const PointMass& point : link.masses) {
    const Vector4d u = point.at(s).homogeneous();
    const double mass = point.mass * point.growth_at(s);
    const AxisAtDesign arm = axis_at(point.arm, s);
    const std::vector<Slope> slopes = slopes_of(point, arm, s);
    add_bends(arm, mass, u, inner);
    for (const Slope& own : slopes) {
      InnerMotion& k = *find(own.parameter);
      const Vector4d first = own.slope + own.growth * u;
      k.moments += mass * first * u.transpose();
      for (const Slope& other : slopes) {
        const std::size_t l = find(other.parameter) - inner.begin();
        k.products[l] += mass * first * (other.slope + other.growth * u).transpose();
        if (point.growth.empty()) continue;
        const double bend =
            own.growth * other.growth - (&own == &other ? own.growth / s[own.parameter] : 0.0);
        k.seconds[l] +=
            mass * (other.growth * own.slope + own.growth * other.slope + bend * u) * u.transpose();
      }
    }
  }
  for (InnerMotion& k : inner) k.first = (k.moments + k.moments.transpose()).col(3);
  return inner;
}

}  // namespace

AxisAtDesign axis_at(const JointAxis& joint_axis, const Eigen::VectorXd& s) {
  const int n = static_cast<int>(joint_axis.turns.size());
  // a = R₁ R₂ … R_n reference; each derivative multiplies the part from its turn on by [about]×.
  const auto product = [&](int k, int l) {
    Vector3d v = joint_axis.reference;
    for (int i = n - 1; i >= 0; --i) {
      const JointAxis::Turn& turn = joint_axis.turns[i];
      v = rotation_about(turn.about, turn.factor * s[turn.parameter]) * v;
      if (i == k) v = turn.factor * turn.about.cross(v);
      if (i == l) v = turn.factor * turn.about.cross(v);
    }
    return v;
  };
  AxisAtDesign out{product(-1, -1), {}, {}, {}};
  for (int k = 0; k < n; ++k) {
    out.parameters.push_back(joint_axis.turns[k].parameter);
    out.first.push_back(product(k, -1));
    out.second.emplace_back();
    for (int l = 0; l < n; ++l) out.second[k].push_back(product(k, l));
  }
  return out;
}

GeometryAtDesign::GeometryAtDesign(const Morphology& morphology, const Eigen::VectorXd& s) {
  for (const Link& link : morphology.links) {
    LinkAtDesign at{link.origin.at(s), axis_at(link.joint.axis, s), Eigen::Matrix4d::Zero(),
                    inner_motion(link, s)};
    for (const PointMass& point : link.masses) {
      const Vector4d u = point.at(s).homogeneous();
      at.moments += point.mass * point.growth_at(s) * u * u.transpose();
      at.grows |= !point.growth.empty();
      at.bends |= at.grows || !point.arm.turns.empty();
    }
    grows |= at.grows;
    total_mass += at.moments(3, 3);
    mass_below.push_back(at.moments(3, 3));
    links.push_back(std::move(at));
  }
  for (std::size_t l = morphology.links.size() - 1; l > 0; --l)
    mass_below[morphology.links[l].parent] += mass_below[l];
  for (const Foot& foot : morphology.feet) feet.push_back(foot.position.at(s));
  for (const Capsule& capsule : morphology.capsules)
    for (const AffineVector* end : {&capsule.from, &capsule.to}) capsule_ends.push_back(end->at(s));
}

}  // namespace legwright
