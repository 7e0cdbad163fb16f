// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/home_stance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer/motion/initial_guess.hpp"
#include "optimizer/motion/motion.hpp"
#include "optimizer/objective/objective.hpp"
#include "tests/support/puppy.hpp"

namespace legwright {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

class Footprint : public testing::Test {
 protected:
  /// The design of another width and length, and other legs.
  VectorXd change(double width, double length, double leg) const {
    VectorXd out = VectorXd::Zero(puppy_.space.size());
    out[puppy_.space.find("body_width")] = width;
    out[puppy_.space.find("body_length")] = length;
    out[puppy_.space.find("length_0_1")] = leg;
    return out;
  }

  test::Puppy puppy_ = test::make_puppy(false);
  VectorXd initial_ = puppy_.space.initial();
  Task task_ = test::make_sideways_task(false, 12);
};

TEST_F(Footprint, FollowsTheHipsOfTheDesignAndNothingElse) {
  task_.footprint.reset();
  const StyleTargets home = style_targets(puppy_.morphology, initial_, task_);
  const StyleTargets other = at_design(home, change(0.04, -0.06, 0.02));
  for (std::size_t foot = 0; foot < 4; ++foot) {
    const Vector2d side(foot < 2 ? 1.0 : -1.0, foot % 2 == 0 ? 1.0 : -1.0);
    const Vector2d moved = other.footprint[foot] - home.footprint[foot];
    EXPECT_NEAR(moved.x(), -0.03 * side.x(), 1e-15);
    EXPECT_NEAR(moved.y(), 0.02 * side.y(), 1e-15);
  }
}

TEST_F(Footprint, StaysWhereTheTaskSaysUnlessItSaysToFollow) {
  EXPECT_TRUE(style_targets(puppy_.morphology, initial_, task_).footprint_slopes.empty());
  task_.follow_hips = true;
  const StyleTargets style = style_targets(puppy_.morphology, initial_, task_);
  EXPECT_EQ(style.footprint, *task_.footprint);
  const Vector2d moved = at_design(style, change(0.04, 0.0, 0.0)).footprint[1] - style.footprint[1];
  EXPECT_NEAR(moved.y(), -0.02, 1e-15);
  task_.footprint.reset();
  task_.follow_hips = false;
  EXPECT_TRUE(style_targets(puppy_.morphology, initial_, task_).footprint_slopes.empty());
}

TEST_F(Footprint, DoesNotMoveWhenAllHipsDo) {  // the body moves, not the feet below its COM
  const int length = puppy_.space.find("body_length");
  for (Link& link : puppy_.morphology.links)
    if (link.parent == 0)
      for (AffineVector::Slope& slope : link.origin.slopes)
        if (slope.parameter == length) slope.slope = Vector3d::UnitX();
  for (const Eigen::Matrix2Xd& slopes : hip_slopes(puppy_.morphology, initial_))
    EXPECT_LT(slopes.col(length).norm(), 1e-15);
}

TEST_F(Footprint, CountsWhatStretchesAboveAJointThatFeetShare) {
  // A girdle that both hind legs hang on, a quarter turn about the vertical at home.
  Morphology& robot = puppy_.morphology;
  const int width = puppy_.space.find("body_width");
  Link girdle;
  girdle.name = "girdle";
  girdle.parent = 0;
  girdle.origin = {Vector3d::Zero(), {{width, -Vector3d::UnitX()}}};
  girdle.joint.axis.reference = Vector3d::UnitZ();
  girdle.joint.nominal = std::acos(0.0);
  robot.links.insert(robot.links.begin() + 7, girdle);
  for (std::size_t l = 8; l < robot.links.size(); ++l)
    robot.links[l].parent = robot.links[l].parent == 0 ? 7 : robot.links[l].parent + 1;
  for (std::size_t foot = 2; foot < 4; ++foot) ++robot.feet[foot].link;
  const auto slopes = hip_slopes(robot, initial_);
  // Hips, by width: front ±y/2; hind ±y/2 turned to ∓x/2, and all of the girdle's −x.
  const Vector2d middle(-0.5, 0.0);
  const Vector2d expected[] = {{0.0, 0.5}, {0.0, -0.5}, {-1.5, 0.0}, {-0.5, 0.0}};
  for (std::size_t foot = 0; foot < 4; ++foot)
    EXPECT_LT((slopes[foot].col(width) - (expected[foot] - middle)).norm(), 1e-12) << foot;
}

TEST_F(Footprint, OfAWiderBodyIsWhereItsFirstMotionStandsAndCostsNothingThere) {
  task_.footprint.reset();
  task_.velocity.setZero();
  const Objective objective(puppy_.morphology, puppy_.space, task_);
  const auto width_at = [&](const VectorXd& s) {
    const VectorXd m = initial_guess(objective, s);
    const MotionView motion(objective.layout(), m);
    for (const TermValue& term : objective.terms(s, m))
      if (term.name == "style_foot") {
        EXPECT_LT(term.value, 1e-3);
      }
    return motion.foot_W(0, 0).y() - motion.foot_W(0, 1).y();
  };
  EXPECT_NEAR(width_at(initial_ + change(0.06, 0.0, 0.0)) - width_at(initial_), 0.06, 0.002);
}

}  // namespace
}  // namespace legwright
