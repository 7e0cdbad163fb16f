// SPDX-License-Identifier: Apache-2.0
// What each term means: zero where its promise is kept, growing where it is broken, in the unit it claims.
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <set>

#include "optimizer/objective/objective.hpp"
#include "optimizer/terms/registry.hpp"
#include "tests/support/puppy.hpp"
#include "tests/support/term_context.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

/// The tied puppy walking sideways; terms by name at a motion.
class TermMeaning : public testing::Test {
 protected:
  TermMeaning() : puppy_(test::make_puppy(true)), objective_(robot(), puppy_.space, task()) {
    s_ = puppy_.space.initial();
    m_ = initial_guess(objective_, s_);
  }
  static Task task() {
    Task task = test::make_sideways_task(false, 12);
    for (const TermEntry& entry : term_registry()) task.weights[std::string(entry.name)] = 1.0;
    return task;
  }
  const Morphology& robot() {
    for (Link& link : puppy_.morphology.links) link.joint.torque_limit = 3.0;
    return puppy_.morphology;
  }
  double value(const std::string& name) const {
    for (const TermValue& term : objective_.terms(s_, m_))
      if (term.name == name) return term.value;
    ADD_FAILURE() << "no term " << name;
    return 0.0;
  }
  double& at(int slot) { return m_[slot - objective_.layout().design_size()]; }
  const Layout& layout() const { return objective_.layout(); }
  double leg() const { return puppy_.morphology.leg_length; }

  test::Puppy puppy_;
  Objective objective_;
  VectorXd s_, m_;
};

TEST_F(TermMeaning, SlidingGuessKeepsKinematicsAndTravel) {
  for (const char* name :
       {"travel", "turning", "com_position", "foot_position", "smoothness", "periodicity",
        "nominal_pose", "trunk_orientation", "ground_height", "design_tether", "force_balance"})
    EXPECT_LT(value(name), 1e-20) << name;
  EXPECT_GT(value("stance_foot"), 1e-6) << "the guess slides its feet";
  EXPECT_GT(value("swing_height"), 1e-6) << "the guess does not lift its feet";
}

TEST_F(TermMeaning, TravelIsHalfSquaredShareOfTheLeg) {
  at(layout().com(layout().knot_count())) += 0.1 * leg();
  EXPECT_NEAR(value("travel"), 0.5 * 0.01, 1e-12);
}

TEST_F(TermMeaning, TurningIsHalfSquaredAngle) {
  at(layout().pose(layout().knot_count()) + 5) += 0.2;
  EXPECT_NEAR(value("turning"), 0.02, 1e-12);
}

TEST_F(TermMeaning, KinematicsNoticeAMovedFootAndCom) {
  at(layout().foot(3, 1)) += 0.1 * leg();
  at(layout().com(3) + 1) += 0.1 * leg();
  EXPECT_NEAR(value("foot_position"), 0.005, 1e-12);
  EXPECT_NEAR(value("com_position"), 0.005, 1e-12);
}

TEST_F(TermMeaning, ForceBalanceNoticesMissingWeight) {
  for (int foot = 0; foot < 4; ++foot)
    if (const int slot = layout().force(5, foot); slot >= 0) at(slot + 2) = 0.0;
  EXPECT_NEAR(value("force_balance"), 0.5, 1e-9)
      << "one knot without any force misses the whole weight";
}

TEST_F(TermMeaning, TorqueBalanceVanishesForFreeFall) {
  // A robot that translates rigidly with no forces at all has a constant angular momentum about its COM.
  for (int i = 0; i <= layout().knot_count(); ++i)
    for (int foot = 0; foot < 4; ++foot)
      if (const int slot = layout().force(i, foot); slot >= 0) at(slot + 2) = 0.0;
  EXPECT_LT(value("torque_balance"), 1e-20);
}

TEST_F(TermMeaning, TorqueBalanceNoticesALoneForce) {
  const double before = value("torque_balance");
  at(layout().force(5, 0) + 1) += 5.0;
  EXPECT_GT(value("torque_balance"), before + 1e-4);
}

TEST_F(TermMeaning, StanceFootAllowsRollingOnly) {
  // A rigid robot that stands: feet at rest, no turn of their links, no residual.
  const Vector3d drift = objective_.path().travel() / layout().knot_count();
  for (int i = 0; i <= layout().knot_count(); ++i)
    for (int foot = 0; foot < 4; ++foot)
      for (int k = 0; k < 3; ++k) at(layout().foot(i, foot) + k) -= i * drift[k];
  EXPECT_LT(value("stance_foot"), 1e-20);
  // Shank swings forward about the lateral axis by θ: the centre of a rolling ball moves by r θ.
  const double theta = 0.02, r = puppy_.morphology.feet[0].radius;
  for (int i = 1; i <= layout().knot_count(); ++i) {
    at(layout().pose(i) + 8) += theta;
    at(layout().foot(i, 0)) += r * std::sin(theta);
  }
  EXPECT_LT(value("stance_foot"), 1e-12);
  for (int i = 1; i <= layout().knot_count(); ++i)
    at(layout().foot(i, 0)) -= 2 * r * std::sin(theta);
  EXPECT_GT(value("stance_foot"), 1e-7) << "rolling backwards is sliding";
}

TEST_F(TermMeaning, BarriersGrowTowardsTheWall) {
  const int slot = layout().force(5, 0);
  ASSERT_GE(slot, 0);
  const double cone = value("friction_cone"), normal = value("least_normal_force");
  at(slot) += 0.9 * 0.4 * at(slot + 2);
  EXPECT_GT(value("friction_cone"), cone);
  at(slot) = 0.0;
  at(slot + 2) *= 0.2;
  EXPECT_GT(value("least_normal_force"), normal);
}

TEST_F(TermMeaning, StyleTermsNoticeOffsets) {
  const double com = value("style_com"), foot = value("style_foot");
  at(layout().com(4) + 2) += 0.2 * leg();
  at(layout().foot(4, 2)) -= 0.2 * leg();
  EXPECT_NE(value("style_com"), com);
  EXPECT_GT(value("style_foot"), foot);
  at(layout().pose(4) + 3) += 0.1;
  EXPECT_NEAR(value("trunk_orientation"), 0.005, 1e-12);
  at(layout().pose(4) + 7) += 0.1;
  EXPECT_NEAR(value("nominal_pose"), 0.005, 1e-12);
  EXPECT_GT(value("smoothness"), 0.0);
}

TEST_F(TermMeaning, GroundAndPeriodicityNoticeOffsets) {
  at(layout().foot(0, 0) + 2) += 0.1 * leg();
  EXPECT_NEAR(value("ground_height"), 0.005, 1e-12);
  EXPECT_NEAR(value("periodicity"), 0.005, 1e-12);
}

TEST_F(TermMeaning, ForceRegularisersMeasureSharesOfTheWeight) {
  EXPECT_GT(value("force_size"), 0.0);
  const double before = value("force_smoothness");
  at(layout().force(5, 0)) += 1.0;
  EXPECT_GT(value("force_smoothness"), before);
}

TEST_F(TermMeaning, LimbClearanceIsZeroWhereLimbsAreFarApart) {
  EXPECT_EQ(value("limb_clearance"), 0.0);
  // Front left shank swings back, hind left shank forward: they meet between the hips.
  const auto swing = [&](double angle) {
    for (int k = 0; k < 3; ++k) {
      at(layout().pose(4) + 6 + k) = k == 0 ? angle : 0.0;
      at(layout().pose(4) + 12 + k) = k == 0 ? -angle : 0.0;
    }
    return value("limb_clearance");
  };
  EXPECT_EQ(swing(0.2), 0.0);
  const double near = swing(0.5), through = swing(0.8);
  EXPECT_GT(near, 0.0);
  EXPECT_GT(through, near);
}

TEST(TermMeaningOfLimbs, PairsAreThoseThatTheTaskNames) {
  Task task;
  const auto names_of = [&] {
    const test::TermSetting setting;
    TermContext context = setting.context();
    std::set<std::string> names;
    for (const TermEntry& entry : term_registry()) {
      if (entry.name != "limb_clearance") continue;
      Task local = setting.task;
      local.clearance = 0.02;
      local.limb_pairs = task.limb_pairs;
      const TermContext with_pairs{
          context.layout,     context.morphology, context.space, local,
          context.path,       context.length,     context.mass,  context.weight,
          context.com_height, context.footprint};
      const std::unique_ptr<Term> term = entry.make(with_pairs);
      for (std::size_t e = 0; e < term->elements().size(); ++e)
        names.insert(term->subject(static_cast<int>(e), 0));
    }
    return names;
  };
  // 12 segments make 66 pairs; 8 within limbs share a hinge, 4 more are across a link of 8 cm: those stay.
  EXPECT_EQ(names_of().size(), 58u);
  task.limb_pairs.emplace();
  task.limb_pairs->emplace_back("foot0", "link2_0");
  EXPECT_EQ(names_of(), std::set<std::string>{"foot0 - link2_0"});
  task.limb_pairs->clear();
  EXPECT_TRUE(names_of().empty());
  task.limb_pairs->emplace_back("foot0", "no such limb");
  EXPECT_THROW(names_of(), std::invalid_argument);
}

TEST_F(TermMeaning, TorqueLimitsBeginAtTheirRange) {
  EXPECT_EQ(value("torque_limits"), 0.0);
  const int slot = layout().force(5, 0);
  ASSERT_GE(slot, 0);
  at(slot) += 400.0;  // a push forward of twenty times the weight
  EXPECT_GT(value("torque_limits"), 0.0);
  EXPECT_GT(value("peak_torque"), 0.0);
}

TEST_F(TermMeaning, MechanicalWorkIsTorqueTimesAngle) {
  // Standing still, joints do no work; turning one joint by 0.2 rad while it holds torque does.
  EXPECT_LT(value("mechanical_work"), 1e-12);
  at(layout().pose(5) + 8) += 1e-3;
  EXPECT_GT(value("mechanical_work"), 0.0);
}

TEST(NearBarrier, IsTwiceDifferentiableAndZeroFarAway) {
  const double edge = 0.02, h = 1e-6;
  for (double r : {-0.5, 0.0, 0.0199, 0.02, 0.0201, 0.3, 0.9, 0.999, 1.0, 1.001, 7.0}) {
    const PenaltyValue at = near_barrier(r, edge), up = near_barrier(r + h, edge),
                       down = near_barrier(r - h, edge);
    const double scale = 1.0 + std::abs(at.second);
    EXPECT_NEAR((up.value - down.value) / (2 * h), at.first, 1e-6 * scale) << r;
    EXPECT_NEAR((up.first - down.first) / (2 * h), at.second, 5e-3 * scale) << r;
    EXPECT_GE(at.second, 0.0);
    EXPECT_LE(at.first, 0.0);
    if (r >= 1.0) {
      EXPECT_EQ(at.value, 0.0);
    }
  }
}

TEST_F(TermMeaning, DesignTetherCountsTiesOfALength) {
  s_[0] *= 1.1;  // tied to two legs
  EXPECT_NEAR(value("design_tether"), 2 * 0.5 * 0.01, 1e-12);
  s_ = puppy_.space.initial();
  s_[6] = 0.1;  // an axis angle of two joints: |a − a₀| = 2 sin(0.05)
  EXPECT_NEAR(value("design_tether"), 2 * 0.5 * std::pow(2 * std::sin(0.05), 2), 1e-12);
}

}  // namespace
}  // namespace legwright
