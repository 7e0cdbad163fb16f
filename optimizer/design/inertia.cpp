// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/inertia.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "optimizer/design/rotation.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

/// Σ over point masses of what parameter k does to them.
std::vector<InnerMotion> inner_motion(const Link& link, const Eigen::VectorXd& s) {
  std::vector<InnerMotion> inner;
  const auto find = [&inner](int parameter) {
    return std::find_if(inner.begin(), inner.end(),
                        [&](const InnerMotion& i) { return i.parameter == parameter; });
  };
  for (const PointMass& point : link.masses)
    for (const AffineVector::Slope& slope : point.position.slopes)
      if (find(slope.parameter) == inner.end())
        inner.push_back(
            {slope.parameter, Vector3d::Zero(), Eigen::Matrix<double, 3, 4>::Zero(), {}});
  for (InnerMotion& k : inner)
    for (std::size_t l = 0; l < inner.size(); ++l)
      k.products.push_back({static_cast<int>(l), Eigen::Matrix3d::Zero()});
  for (const PointMass& point : link.masses) {
    const Vector4d u = point.position.at(s).homogeneous();
    for (const AffineVector::Slope& slope : point.position.slopes) {
      InnerMotion& k = *find(slope.parameter);
      k.first += point.mass * slope.slope;
      k.moments += point.mass * slope.slope * u.transpose();
      for (const AffineVector::Slope& other : point.position.slopes) {
        const std::size_t l = find(other.parameter) - inner.begin();
        k.products[l].second += point.mass * slope.slope * other.slope.transpose();
      }
    }
  }
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
      const Vector4d u = point.position.at(s).homogeneous();
      at.moments += point.mass * u * u.transpose();
    }
    total_mass += at.moments(3, 3);
    mass_below.push_back(at.moments(3, 3));
    links.push_back(std::move(at));
  }
  for (std::size_t l = morphology.links.size() - 1; l > 0; --l)
    mass_below[morphology.links[l].parent] += mass_below[l];
  for (const Foot& foot : morphology.feet) feet.push_back(foot.position.at(s));
}

}  // namespace legwright
