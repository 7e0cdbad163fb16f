// SPDX-License-Identifier: Apache-2.0
// Torques of a robot that stands, against the work that they do when a joint gives way.
#include "optimizer/motion/standing.hpp"

#include <gtest/gtest.h>

#include "optimizer/design/kinematics.hpp"
#include "tests/support/puppy.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

struct Stand {
  Vector3d com;
  std::vector<Vector3d> feet;
};

Stand stand(const Morphology& morphology, const VectorXd& s, const VectorXd& joints) {
  const GeometryAtDesign geometry(morphology, s);
  VectorXd q = VectorXd::Zero(morphology.pose_size());
  q.tail(morphology.joint_count()) = joints;
  PoseKinematics pose;
  pose.compute(morphology, geometry, q, PoseDetail::place);
  Stand out{pose.first_moment(0) / geometry.total_mass, {}};
  for (int j = 0; j < morphology.foot_count(); ++j)
    out.feet.push_back(foot_place(morphology, geometry, pose, j));
  return out;
}

TEST(StandingTorques, DoTheWorkThatLiftsTheWeight) {
  const test::Puppy puppy = test::make_puppy(true);
  const Morphology& m = puppy.morphology;
  const VectorXd s = puppy.space.initial(), torques = standing_torques(m, s);
  const double weight = m.total_mass() * kGravity;
  const Stand home = stand(m, s, m.nominal_joints());
  const std::vector<double> shares =
      shares_of_weight(home.com, home.feet, weight, m.leg_length, 0.0);
  ASSERT_EQ(torques.size(), m.joint_count());
  const double step = 1e-6;
  for (int a = 0; a < m.joint_count(); ++a) {
    VectorXd bent = m.nominal_joints();
    bent[a] += step;
    const Stand there = stand(m, s, bent);
    // A turn raises masses against gravity and lowers feet that push; the force on a ball is
    // vertical, so it does not matter how far below its centre it acts.
    double work = weight * (there.com - home.com).z();
    for (int j = 0; j < m.foot_count(); ++j) work -= shares[j] * (there.feet[j] - home.feet[j]).z();
    EXPECT_NEAR(torques[a], work / step, 1e-5 * weight) << a;
  }
  EXPECT_GT(torques.cwiseAbs().maxCoeff(), 0.01 * weight * m.leg_length) << "knees are bent";
}

TEST(StandingTorques, FeetUnderTheCentreShareTheWeightEvenly) {
  const std::vector<Vector3d> feet = {{1, 1, 0}, {1, -1, 0}, {-1, 1, 0}, {-1, -1, 0}};
  for (const double share : shares_of_weight({0, 0, 1}, feet, 8.0, 1.0, 0.0))
    EXPECT_NEAR(share, 2.0, 1e-3);
  const std::vector<double> ahead = shares_of_weight({0.5, 0, 1}, feet, 8.0, 1.0, 0.0);
  EXPECT_NEAR(ahead[0], 3.0, 1e-2);
  EXPECT_NEAR(ahead[2], 1.0, 1e-2);
}

}  // namespace
}  // namespace legwright
