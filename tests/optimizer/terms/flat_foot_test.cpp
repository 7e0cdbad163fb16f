// SPDX-License-Identifier: Apache-2.0
// What flat_foot means: soles lie level always, and do not turn while they are planted.
#include <gtest/gtest.h>

#include <cmath>

#include "optimizer/objective/objective.hpp"
#include "optimizer/terms/registry.hpp"
#include "tests/support/flat_biped.hpp"
#include "tests/support/standing.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

constexpr int kYaw = 0, kAnklePitch = 4, kAnkleRoll = 5;  // hinges of a leg

/// A flat-footed biped at a motion; the term alone, at weight one.
class FlatFootMeaning : public testing::Test {
 protected:
  explicit FlatFootMeaning(double turn_rate = 0.0)
      : objective_(biped_.morphology, biped_.space, task(turn_rate)),
        s_(biped_.space.initial()),
        m_(test::standing_motion(objective_, s_)) {}
  static Task task(double turn_rate) {
    Task task = test::make_flat_walk();
    task.turn_rate = turn_rate;
    for (const TermEntry& entry : term_registry())
      task.weights[std::string(entry.name)] = entry.name == "flat_foot" ? 1.0 : 0.0;
    return task;
  }
  double value() const { return objective_.evaluate(s_, m_, Order::value).value; }
  double& pose(int knot, int entry) {
    return m_[objective_.layout().pose(knot) - objective_.layout().design_size() + entry];
  }
  double& hinge(int knot, int foot, int which) { return pose(knot, 6 + 6 * foot + which); }
  bool planted(int knot, int foot) const {
    return objective_.task().gait.planted(knot, foot, objective_.layout().planted_margin());
  }
  /// A knot at which a foot and its neighbours are planted, or none of them.
  int knot(int foot, bool stands) const {
    for (int i = 1; i < objective_.layout().knot_count(); ++i)
      if (planted(i - 1, foot) == stands && planted(i, foot) == stands &&
          planted(i + 1, foot) == stands)
        return i;
    ADD_FAILURE() << "no such knot";
    return 1;
  }

  const test::Puppy biped_ = test::make_flat_biped();
  const Objective objective_;
  VectorXd s_, m_;
};

class FlatFootOnACurve : public FlatFootMeaning {
 protected:
  FlatFootOnACurve() : FlatFootMeaning(0.5) {}
};

TEST_F(FlatFootMeaning, SolesThatLieStillCostNothing) { EXPECT_LT(value(), 1e-20); }

TEST_F(FlatFootMeaning, ATiltedSoleCostsInTheAirAndOnTheGround) {
  const double sine = std::sin(0.1);
  for (const int which : {kAnklePitch, kAnkleRoll})
    for (int foot = 0; foot < 2; ++foot) {
      const int swings = knot(foot, false), stands = knot(foot, true);
      hinge(swings, foot, which) += 0.1;
      EXPECT_NEAR(value(), 0.5 * sine * sine, 1e-9) << "half the square of the height";
      hinge(swings, foot, which) -= 0.1;
      hinge(stands, foot, which) += 0.1;
      EXPECT_GT(value(), 0.99 * 0.5 * sine * sine);
      hinge(stands, foot, which) -= 0.1;
      EXPECT_LT(value(), 1e-20);
    }
}

TEST_F(FlatFootMeaning, ATiltOfTheTrunkTiltsBothSoles) {
  const int i = knot(0, false);
  pose(i, 4) += 0.1;  // the other foot is planted: it also shifts
  EXPECT_GT(value(), std::sin(0.1) * std::sin(0.1) * 0.999);
}

TEST_F(FlatFootMeaning, ASoleMayTurnInTheAirOnly) {
  for (int foot = 0; foot < 2; ++foot) {
    const int swings = knot(foot, false), stands = knot(foot, true);
    hinge(swings, foot, kYaw) += 0.1;
    EXPECT_LT(value(), 1e-20);
    hinge(stands, foot, kYaw) += 0.1;  // it turns there and back
    EXPECT_NEAR(value(), std::pow(2.0 * std::sin(0.05), 2), 1e-9);
    hinge(stands, foot, kYaw) -= 0.1;
  }
}

TEST_F(FlatFootOnACurve, SolesThatGlideRoundTurnWhileTheyArePlanted) { EXPECT_GT(value(), 1e-3); }

TEST(FlatFootOfPoints, KnowsNoSoles) {
  test::Puppy biped = test::make_flat_biped();
  const auto value = [&] {
    const Objective objective(biped.morphology, biped.space, test::make_flat_walk());
    const VectorXd s = biped.space.initial();
    VectorXd m = test::standing_motion(objective, s);
    m[objective.layout().pose(3) - objective.layout().design_size() + 6 + kAnklePitch] += 0.1;
    for (const TermValue& term : objective.terms(s, m))
      if (term.name == "flat_foot") return term.value;
    return 0.0;
  };
  EXPECT_GT(value(), 1e-3);
  for (Foot& foot : biped.morphology.feet) foot.sole.reset();
  EXPECT_EQ(value(), 0.0);
}

}  // namespace
}  // namespace legwright
