// SPDX-License-Identifier: Apache-2.0
// A joint's torque against the sum over point masses of d'Alembert's principle, with differences
// for ∂p/∂q. (Derivatives: objective/derivatives_test; against MuJoCo's inverse dynamics:
// tests/mjcf.)
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "optimizer/design/inertia.hpp"
#include "optimizer/design/kinematics.hpp"
#include "optimizer/motion/motion.hpp"
#include "optimizer/objective/derived.hpp"
#include "tests/support/puppy.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

class PuppyInMotion : public testing::Test {
 protected:
  PuppyInMotion() : puppy_(test::make_puppy(true)), task_(test::make_sideways_task(true, 8)) {
    for (Link& link : puppy_.morphology.links) link.joint.armature = 3e-4;
    task_.velocity = {0.05, 0.1};
    task_.turn_rate = 0.6;
    layout_ = Layout(puppy_.morphology, puppy_.space.size(), task_.gait, 1);
    path_ = WantedPath(task_.velocity, task_.turn_rate, task_.gait.period());
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    extended_ = VectorXd::Zero(layout_.extended_size());
    extended_.head(layout_.design_size()) = puppy_.space.initial();
    for (int k = layout_.design_size(); k < layout_.parameter_count(); ++k)
      extended_[k] = 0.3 * normal(random);
    geometry_ = GeometryAtDesign(puppy_.morphology, puppy_.space.initial());
  }
  VectorXd pose(int knot) const {
    return extended_.segment(layout_.pose(knot), layout_.pose_size());
  }
  /// Masses and world positions of all points; knot −1 is knot T − 1 moved back by one cycle.
  std::vector<std::pair<double, Vector3d>> points(const VectorXd& q, bool moved_back) const {
    PoseKinematics at;
    at.compute(puppy_.morphology, geometry_, q, PoseDetail::place);
    std::vector<std::pair<double, Vector3d>> out;
    for (int l = 0; l < static_cast<int>(puppy_.morphology.links.size()); ++l)
      for (const PointMass& point : puppy_.morphology.links[l].masses) {
        Vector3d p = at.origin(l) + at.rotation(l) * point.at(puppy_.space.initial());
        if (moved_back) p = path_.turn().transpose() * (p - path_.travel());
        out.emplace_back(point.mass, p);
      }
    return out;
  }
  double expected_torque(int knot, int joint) const {
    const double h = task_.gait.time_step(), step = 1e-6;
    const int before = knot > 0 ? knot - 1 : layout_.knot_count() - 1, slot = 6 + joint;
    const auto p0 = points(pose(before), knot == 0), p1 = points(pose(knot), false),
               p2 = points(pose(knot + 1), false);
    VectorXd up = pose(knot), down = pose(knot);
    up[slot] += step;
    down[slot] -= step;
    const auto pu = points(up, false), pd = points(down, false);
    double torque = 0.0;
    for (std::size_t k = 0; k < p1.size(); ++k) {
      const Vector3d a =
          (p0[k].second - 2 * p1[k].second + p2[k].second) / (h * h) + kGravity * Vector3d::UnitZ();
      torque += p1[k].first * (pu[k].second - pd[k].second).dot(a) / (2 * step);
    }
    PoseKinematics here;
    here.compute(puppy_.morphology, geometry_, pose(knot), PoseDetail::place);
    const Ancestry ancestry(puppy_.morphology);
    for (int j = 0; j < layout_.foot_count(); ++j) {
      const Foot& foot = puppy_.morphology.feet[j];
      if (layout_.force(knot, j) < 0 || !ancestry.contains(joint + 1, foot.link)) continue;
      const Vector3d contact =
          foot_place(puppy_.morphology, geometry_, here, j) - foot.radius * Vector3d::UnitZ();
      const Vector3d axis = here.before(joint + 1) * geometry_.links[joint + 1].axis.axis;
      torque -= axis.cross(contact - here.origin(joint + 1))
                    .dot(extended_.segment<3>(layout_.force(knot, j)));
    }
    const double bend = pose(before)[slot] - 2 * pose(knot)[slot] + pose(knot + 1)[slot];
    return torque + 3e-4 * bend / (h * h);
  }

  test::Puppy puppy_;
  Task task_;
  Layout layout_;
  WantedPath path_;
  GeometryAtDesign geometry_;
  VectorXd extended_;
};

TEST_F(PuppyInMotion, JointTorqueIsTheSumOverPoints) {
  const DerivedQuantities derived(puppy_.morphology, layout_, task_, path_,
                                  std::vector<char>(layout_.extended_size(), 1));
  DerivedQuantities::Workspace workspace;
  derived.evaluate(puppy_.morphology, layout_, PoseDetail::place, extended_, workspace);
  for (int knot : {0, 1, 4, layout_.knot_count() - 1})
    for (int joint = 0; joint < layout_.joint_count(); ++joint) {
      const double expected = expected_torque(knot, joint);
      EXPECT_NEAR(extended_[layout_.joint_torque(knot, joint)], expected,
                  1e-7 * (1.0 + std::abs(expected)))
          << knot << ' ' << joint;
    }
}

TEST_F(PuppyInMotion, OnlyWantedQuantitiesAreWorkedOut) {
  std::vector<char> wanted(layout_.extended_size(), 0);
  wanted[layout_.joint_torque(3, 2)] = 1;
  wanted[layout_.link_anchor(2, 5) + 1] = 1;
  const DerivedQuantities derived(puppy_.morphology, layout_, task_, path_, wanted);
  ASSERT_EQ(derived.blocks().size(), 2u);
  DerivedQuantities::Workspace workspace;
  derived.evaluate(puppy_.morphology, layout_, PoseDetail::motion, extended_, workspace);
  EXPECT_NE(extended_[layout_.joint_torque(3, 2)], 0.0);
  EXPECT_EQ(extended_[layout_.joint_torque(3, 1)], 0.0);
  EXPECT_EQ(workspace.ready, (std::vector<char>{0, 0})) << "no Jacobian before it is asked for";
}

}  // namespace
}  // namespace legwright
