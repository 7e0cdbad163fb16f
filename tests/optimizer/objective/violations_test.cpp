// SPDX-License-Identifier: Apache-2.0
// The worst place of each constraint: where it was broken, by how much, in which unit.
#include "optimizer/objective/violations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/puppy.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

class Violations : public testing::Test {
 protected:
  Violations() : puppy_(test::make_puppy(true)), objective_(make()) {
    s_ = puppy_.space.initial();
    m_ = initial_guess(objective_, s_);
  }
  Objective make() {
    for (Link& link : puppy_.morphology.links) {
      link.joint.lower = -1.5;
      link.joint.upper = 1.5;
      link.joint.torque_limit = 2.0;
    }
    return Objective(puppy_.morphology, puppy_.space, test::make_sideways_task(false, 12));
  }
  Violation of(const std::string& term) const {
    for (const Violation& violation : worst_violations(objective_, s_, m_))
      if (violation.term == term) return violation;
    ADD_FAILURE() << "no violation of " << term;
    return {};
  }
  double& at(int slot) { return m_[slot - objective_.layout().design_size()]; }
  const Layout& layout() const { return objective_.layout(); }

  test::Puppy puppy_;
  Objective objective_;
  VectorXd s_, m_;
};

TEST_F(Violations, NameFootKnotAndMetres) {
  at(layout().foot(7, 2)) += 0.03;
  at(layout().foot(7, 2) + 2) += 0.04;
  const Violation foot = of("foot_position");
  EXPECT_EQ(foot.knot, 7);
  EXPECT_EQ(foot.where, "foot2");
  EXPECT_EQ(foot.unit, "m");
  EXPECT_NEAR(foot.amount, 0.05, 1e-12);
}

TEST_F(Violations, OfForcesAreInNewtons) {
  const double weight = puppy_.morphology.total_mass() * kGravity;
  for (int foot = 0; foot < 4; ++foot)
    if (layout().force(5, foot) >= 0) at(layout().force(5, foot) + 2) = 0.0;
  const Violation balance = of("force_balance"), normal = of("least_normal_force");
  EXPECT_EQ(balance.knot, 5);
  EXPECT_EQ(balance.unit, "N");
  EXPECT_NEAR(balance.amount, weight, 1e-9);
  EXPECT_EQ(normal.knot, 5);
  EXPECT_NEAR(normal.amount, 0.1 * weight, 1e-9) << "min_normal is a tenth of the weight";
}

TEST_F(Violations, OfInequalitiesThatHoldAreNegative) {
  const Violation limits = of("joint_limits");
  EXPECT_NEAR(limits.amount, -0.5, 1e-12) << "nominal −1.0 against −1.5";
  EXPECT_EQ(limits.unit, "rad");
  EXPECT_EQ(limits.where.substr(0, 5), "joint");
  EXPECT_LT(of("limb_clearance").amount, 0.0);
  EXPECT_EQ(of("torque_limits").unit, "N m");
}

TEST_F(Violations, NameJointAndLimbs) {
  at(layout().pose(4) + 6 + 3) = 1.7;
  EXPECT_NEAR(of("joint_limits").amount, 0.2, 1e-12);
  EXPECT_EQ(of("joint_limits").where, "joint1_0");
  // Front left leg swings onto the hind left one.
  for (int k = 0; k < 3; ++k) at(layout().pose(4) + 6 + k) = k == 0 ? 1.1 : 0.0;
  for (int k = 0; k < 3; ++k) at(layout().pose(4) + 6 + 6 + k) = k == 0 ? -1.1 : 0.0;
  const Violation limbs = of("limb_clearance");
  EXPECT_EQ(limbs.knot, 4);
  EXPECT_NE(limbs.where.find(" - "), std::string::npos);
  EXPECT_GT(limbs.amount, 0.0);
  EXPECT_EQ(limbs.unit, "m");
}

TEST_F(Violations, AreSortedAndCoverConstraintsOnly) {
  at(layout().foot(7, 2)) += 0.03;
  const std::vector<Violation> all = worst_violations(objective_, s_, m_);
  for (std::size_t k = 1; k < all.size(); ++k) EXPECT_GE(all[k - 1].relative, all[k].relative);
  EXPECT_TRUE(std::none_of(all.begin(), all.end(), [](const Violation& violation) {
    return violation.term == "smoothness" || violation.term == "design_tether" ||
           violation.term == "mechanical_work";
  }));
}

TEST_F(Violations, ThatAreNoNumbersAreSeen) {
  at(layout().force(5, 0)) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(of("friction_cone").amount));
}

}  // namespace
}  // namespace legwright
