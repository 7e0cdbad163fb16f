// SPDX-License-Identifier: Apache-2.0
// What each term means: zero where its promise is kept, growing where it is broken, in the unit it
// claims.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <memory>
#include <set>

#include "optimizer/objective/objective.hpp"
#include "optimizer/terms/registry.hpp"
#include "tests/support/puppy.hpp"
#include "tests/support/standing.hpp"
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
    m_ = test::standing_motion(objective_, s_);
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

TEST_F(TermMeaning, ForceBalanceOnASlopeWantsForcesThatPointUp) {
  for (const bool printed : {false, true}) {  // masses that grow have a term of their own
    test::Puppy puppy = test::make_puppy(true);
    if (printed) test::print_bodies(puppy);
    Task oblique = task();
    oblique.up = up_on_slope(oblique.velocity, 0.3, -0.2);
    const Objective on_slope(puppy.morphology, puppy.space, oblique);
    VectorXd m = test::standing_motion(on_slope, s_);
    const auto misfit = [&] {
      for (const TermValue& term : on_slope.terms(s_, m))
        if (term.name == "force_balance") return term.value;
      return -1.0;
    };
    EXPECT_GT(misfit(), 1e-2) << printed;  // forces along z
    const double weight = puppy.morphology.total_mass() * kGravity;
    for (int i = 0; i < layout().knot_count(); ++i) {
      std::vector<int> slots;
      for (int foot = 0; foot < 4; ++foot)
        if (const int slot = on_slope.layout().force(i, foot); slot >= 0)
          slots.push_back(slot - on_slope.layout().design_size());
      for (const int slot : slots)
        m.segment<3>(slot) = weight / static_cast<double>(slots.size()) * oblique.up;
    }
    EXPECT_LT(misfit(), 1e-20) << printed;
  }
}

TEST_F(TermMeaning, TorqueBalanceVanishesForFreeFall) {
  // A robot that translates rigidly with no forces at all has a constant angular momentum about its
  // COM.
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

TEST_F(TermMeaning, TorqueBalanceTakesForcesWhereTheBallsTouchTheGround) {
  at(layout().force(0, 0)) +=
      5.0;  // along the ground: its torque knows the height at which it acts
  const double before = value("torque_balance");
  test::Puppy larger = puppy_;
  for (Foot& foot : larger.morphology.feet) foot.radius += 0.05;
  const Objective on_larger(larger.morphology, larger.space, task());
  const auto of_larger = [&] {
    for (const TermValue& term : on_larger.terms(s_, m_))
      if (term.name == "torque_balance") return term.value;
    return -1.0;
  };
  EXPECT_GT(std::abs(of_larger() - before), 1e-4);  // the same centres touch the ground lower down
  for (int i = 0; i <= layout().knot_count(); ++i)
    for (int j = 0; j < layout().foot_count(); ++j) at(layout().foot(i, j) + 2) += 0.05;
  EXPECT_NEAR(of_larger(), before, 1e-12);
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

TEST_F(TermMeaning, PeriodicUpToTheTurn) {
  // Gliding along a curve with a level trunk: knot T is knot 0 one cycle's rigid motion later.
  Task curve = task();
  curve.velocity = {0.08, 0.02};
  curve.turn_rate = 0.5;
  const Objective objective(puppy_.morphology, puppy_.space, curve);
  const Layout& slots = objective.layout();
  VectorXd m = test::standing_motion(objective, s_);
  const auto value_at = [&](const char* name) {
    for (const TermValue& term : objective.terms(s_, m))
      if (term.name == name) return term.value;
    return -1.0;
  };
  const int last = slots.knot_count();
  for (const char* name : {"periodicity", "travel", "turning", "smoothness"})
    EXPECT_LT(value_at(name), 1e-20) << name;
  ASSERT_GE(slots.force(0, 0), 0);
  const auto force = [&](int knot) {
    return m.segment<3>(slots.force(knot, 0) - slots.design_size());
  };
  force(0).x() = 1.0;  // a force turns with the robot
  force(last) = objective.path().turn() * force(0);
  EXPECT_LT(value_at("periodicity"), 1e-20);
  force(last) = force(0);
  EXPECT_GT(value_at("periodicity"), 1e-6);
  force(last) = objective.path().turn() * force(0);
  // As if the robot had walked straight on: feet and heading are not where they repeat.
  for (int j = 0; j < 4; ++j)
    m.segment<3>(slots.foot(last, j) - slots.design_size()) =
        m.segment<3>(slots.foot(0, j) - slots.design_size()) + objective.path().travel();
  EXPECT_GT(value_at("periodicity"), 0.01);
  m[slots.pose(last) + 5 - slots.design_size()] = 0.0;
  EXPECT_NEAR(value_at("turning"), 0.5 * 0.25, 1e-12) << "half the square of 0.5 rad";
}

/// One term of a task at weight one.
double value_of(const std::string& name, const Objective& objective, const VectorXd& s,
                const VectorXd& m) {
  for (const TermValue& term : objective.terms(s, m))
    if (term.name == name) return term.value;
  return -1.0;
}

TEST_F(TermMeaning, StyleListsAreMetByTheMotionThatTheyDescribe) {
  // A walk on a curve whose task says over the cycle where COM and a foot shall be: the motion put
  // there by hand has no residual, and each list by itself does.
  Task curve = task();
  curve.velocity = {0.08, 0.02};
  curve.turn_rate = 0.5;
  curve.com_heights = {0.17, 0.18, 0.19};
  curve.com_path = {{0.0, 0.01}, {0.005, -0.01}};
  curve.foot_targets = {{}, {{0.1, 0.1}, {0.05, 0.12}, {0.0, 0.1}, {0.05, 0.08}}};
  const Objective objective(puppy_.morphology, puppy_.space, curve);
  const Layout& slots = objective.layout();
  VectorXd m = test::standing_motion(objective, s_);
  for (int i = 0; i <= slots.knot_count(); ++i) {
    const double time = i * curve.gait.time_step(), cycle = static_cast<double>(i % 12) / 12;
    const Vector3d base = objective.path().position(time);
    const Eigen::Rotation2Dd heading(0.5 * time);
    const double wave = 2 * std::abs(cycle - 0.5);  // one at the start, zero half a cycle later
    VectorXd com(3);
    com << base.head<2>() + heading * Eigen::Vector2d(0.005 * (1 - wave), 0.02 * wave - 0.01),
        cycle < 2.0 / 3 ? 0.17 + 0.03 * cycle : 0.19 - 0.06 * (cycle - 2.0 / 3);
    m.segment(slots.com(i) - slots.design_size(), 3) = com;
    for (int j = 0; j < 4; ++j) {
      Eigen::Vector2d place = (*curve.footprint)[j];
      if (j == 1)
        place = {0.1 * wave, 0.1 + (cycle < 0.5 ? 1 : -1) * 0.02 *
                                       (1 - std::abs(4 * std::fmod(cycle, 0.5) - 1))};
      m.segment<2>(slots.foot(i, j) - slots.design_size()) = base.head<2>() + heading * place;
    }
  }
  EXPECT_LT(value_of("style_com", objective, s_, m), 1e-20);
  EXPECT_LT(value_of("style_foot", objective, s_, m), 1e-20);
  const auto without = [&](auto change) {
    Task other = curve;
    change(other);
    return Objective(puppy_.morphology, puppy_.space, other);
  };
  const Objective flat = without([](Task& t) { t.com_heights.clear(); });
  const Objective straight = without([](Task& t) { t.com_path.clear(); });
  const Objective print = without([](Task& t) { t.foot_targets.clear(); });
  EXPECT_GT(value_of("style_com", flat, s_, m), 1e-5);
  EXPECT_GT(value_of("style_com", straight, s_, m), 1e-5);
  EXPECT_GT(value_of("style_foot", print, s_, m), 1e-5);
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
  // 12 segments make 66 pairs; 8 within limbs share a hinge, 4 more are across a link of 8 cm:
  // those stay.
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
