// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/initial_guess.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "optimizer/motion/margins.hpp"
#include "optimizer/motion/motion.hpp"
#include "optimizer/objective/objective.hpp"
#include "tests/support/puppy.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kKnots = 24;

class InitialGuess : public testing::TestWithParam<double> {  // turn rate [rad/s]
 protected:
  static Task task() {
    Task task = test::make_sideways_task(false, kKnots);
    task.velocity = {0.06, 0.02};
    task.turn_rate = GetParam();
    return task;
  }

  const test::Puppy puppy_ = test::make_puppy(true);
  const Objective objective_{puppy_.morphology, puppy_.space, task()};
  const Layout& layout_ = objective_.layout();
  const VectorXd s_ = puppy_.space.initial();
  const VectorXd m_ = initial_guess(objective_, s_);
  const MotionView motion_{layout_, m_};
};

TEST_P(InitialGuess, PlantedFeetStandStillOnTheGroundAndOthersAreLifted) {
  const Gait& gait = objective_.task().gait;
  int lifted = 0;
  for (int i = 0; i < kKnots; ++i)
    for (int j = 0; j < 4; ++j) {
      const bool planted = gait.planted(i, j, layout_.planted_margin());
      const Vector3d foot = motion_.foot_W(i, j), next = motion_.foot_W(i + 1, j);
      if (!planted) {
        EXPECT_GT(foot.z(), 0.0121);
        ++lifted;
        continue;
      }
      EXPECT_NEAR(foot.z(), 0.012, 1e-12);
      if (gait.planted(i + 1, j, layout_.planted_margin())) {
        EXPECT_LT((next - foot).norm(), 1e-12) << "knot " << i << " foot " << j;
      }
    }
  EXPECT_GT(lifted, 4);
}

TEST_P(InitialGuess, StanceFeetCarryTheWeight) {
  const double least = objective_.task().min_normal;
  for (int i = 0; i <= kKnots; ++i) {
    double force = 0.0;
    for (int j = 0; j < 4; ++j) {
      if (layout_.force(i, j) < 0) continue;
      const Vector3d f = motion_.force_W(i, j);
      EXPECT_GT(f.z(), least * puppy_.morphology.total_mass() * kGravity * 0.9);
      EXPECT_EQ(f.head<2>().norm(), 0.0);
      force += f.z();
    }
    EXPECT_NEAR(force, puppy_.morphology.total_mass() * kGravity, 1e-9);
  }
}

TEST_P(InitialGuess, RepeatsOneCycleLater) {
  const WantedPath& path = objective_.path();
  EXPECT_LT((motion_.com_W(kKnots) - (path.turn() * motion_.com_W(0) + path.travel())).norm(),
            1e-12);
  for (int j = 0; j < 4; ++j)
    EXPECT_LT(
        (motion_.foot_W(kKnots, j) - (path.turn() * motion_.foot_W(0, j) + path.travel())).norm(),
        1e-12);
  EXPECT_LT((motion_.pose(kKnots).tail(12) - motion_.pose(0).tail(12)).norm(), 1e-12);
  EXPECT_NEAR(motion_.pose(kKnots)[5] - motion_.pose(0)[5], path.turn_angle(), 1e-12);
}

// What it is for: far nearer to a motion than a robot that stands in its home pose and slides.
TEST_P(InitialGuess, BeatsStandingStill) {
  VectorXd standing = m_;
  for (int i = 0; i <= kKnots; ++i)
    standing.segment(layout_.pose(i) - layout_.design_size() + 6, 12) =
        puppy_.morphology.nominal_joints();
  const double guess = objective_.evaluate(s_, m_, Order::value).value;
  EXPECT_LT(3.0 * guess, objective_.evaluate(s_, standing, Order::value).value);
}

INSTANTIATE_TEST_SUITE_P(StraightAndTurning, InitialGuess, testing::Values(0.0, 0.2));

TEST(InitialGuessOfAFootThatNeverLifts, Ends) {
  const test::Puppy puppy = test::make_puppy(true);
  Task task = test::make_sideways_task(false, 12);
  task.gait = Gait({"stand", {0, 0, 0, 0}, 1.0}, 1.0, 12, {0, 1, 2, 3});
  task.velocity = {0.0, 0.0};
  const Objective objective(puppy.morphology, puppy.space, task);
  EXPECT_TRUE(initial_guess(objective, puppy.space.initial()).allFinite());
}

/// Where the task gives no height of swings, guess and term agree on it, also of a robot that
/// crouches.
TEST(InitialGuessOfACrouchingRobot, LiftsFeetAsHighAsTheTermWants) {
  test::Puppy puppy = test::make_puppy(true);
  for (std::size_t l = 1; l < puppy.morphology.links.size(); ++l)
    puppy.morphology.links[l].joint.nominal = l % 3 == 1 ? 1.3 : l % 3 == 2 ? -2.6 : 2.6;
  const VectorXd s = puppy.space.initial();
  ASSERT_LT(standing_leg(puppy.morphology, s), 0.9 * puppy.morphology.leg_length);
  Task task = test::make_sideways_task(false, kKnots);
  task.swing_height.reset();
  const Objective objective(puppy.morphology, puppy.space, task);
  const VectorXd m = initial_guess(objective, s);
  bool seen = false;
  for (const TermValue& term : objective.terms(s, m)) {
    if (term.name != "swing_height") continue;
    seen = true;
    EXPECT_LT(term.value, 1e-20);
  }
  EXPECT_TRUE(seen);
  const MotionView motion(objective.layout(), m);
  double top = 0.0;
  for (int i = 0; i <= kKnots; ++i)
    top = std::max(top, motion.foot_W(i, 0).z() - puppy.morphology.feet[0].radius);
  EXPECT_NEAR(top, swing_height(task, standing_leg(puppy.morphology, s)), 1e-3);
}

}  // namespace
}  // namespace legwright
