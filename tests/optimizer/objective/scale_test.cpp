// SPDX-License-Identifier: Apache-2.0
// One set of weights and defaults serves robots of any size: a robot twice as large, of eight times
// the mass, slower by √2 and with sixteen times the torque has the same F, term by term, and the
// same plan twice as large.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "optimizer/design/design.hpp"
#include "optimizer/objective/objective.hpp"
#include "optimizer/solve/newton.hpp"
#include "tests/support/puppy.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

struct Setting {
  test::Puppy puppy;
  Task task;
};

void grow(AffineVector& vector, double by) { vector.constant *= by; }

/// Lengths × by, masses × by³, times × √by, all else as gravity then wants it.
Setting grown(double by) {
  Setting out{test::make_puppy(true), test::make_sideways_task(true, 12, 2)};
  test::add_pistons(out.puppy);
  test::print_bodies(out.puppy);
  test::add_capsules(out.puppy);
  Morphology& robot = out.puppy.morphology;
  robot.leg_length *= by;
  for (Link& link : robot.links) {
    grow(link.origin, by);
    link.joint.lower = -1.5;
    link.joint.upper = 1.5;
    link.joint.torque_limit = 0.9 * std::pow(by, 4);
    link.joint.armature = 2e-4 * std::pow(by, 5);
    link.joint.damping = 0.02 * std::pow(by, 4.5);
    link.joint.stiffness = 0.3 * std::pow(by, 4);
    link.joint.slack_angle = -0.2;
    link.joint.friction_loss = 0.1 * std::pow(by, 4);
    for (PointMass& point : link.masses) {
      grow(point.position, by);
      point.mass *= std::pow(by, 3);
      point.volume *= std::pow(by, 3);
      for (PointMass::Growth& growth : point.growth) growth.initial *= by;
    }
  }
  for (Foot& foot : robot.feet) {
    grow(foot.position, by);
    foot.radius *= by;
  }
  for (Capsule& capsule : robot.capsules) {
    grow(capsule.from, by);
    grow(capsule.to, by);
    capsule.radius *= by;
  }
  for (LinearActuator& actuator : robot.linear_actuators) {
    grow(actuator.upper, by);
    grow(actuator.lower, by);
    actuator.shortest *= by;
    actuator.longest *= by;
    actuator.force_limit *= std::pow(by, 3);
  }
  for (DesignParameter& parameter : out.puppy.space.parameters)
    if (parameter.kind != ParameterKind::axis_angle)
      for (double* value : {&parameter.initial, &parameter.lower, &parameter.upper}) *value *= by;
  Task& task = out.task;
  task.gait = Gait({"trot", {0, 0.5, 0.5, 0}, 0.5}, 0.4 * std::sqrt(by), 12, {0, 1, 2, 3});
  task.velocity = {0.05 * std::sqrt(by), 0.1 * std::sqrt(by)};
  task.turn_rate = 0.4 / std::sqrt(by);
  task.com_height.reset();  // what is not given follows the size
  task.footprint.reset();
  task.swing_height.reset();
  task.weights = {{"mechanical_work", 1.0}, {"peak_torque", 1.0}, {"printed_volume", 1.0}};
  return out;
}

struct Placed {
  explicit Placed(const Setting& setting)
      : objective(setting.puppy.morphology, setting.puppy.space, setting.task),
        s(setting.puppy.space.initial()),
        m(initial_guess(objective, s)) {}
  Objective objective;
  VectorXd s, m;
};

/// The same disturbance of design and motion in their own units, so that every term has something
/// to say.
void disturb(Placed& at) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const VectorXd unit = at.objective.space().scale();
  for (int k = 0; k < at.s.size(); ++k) at.s[k] += 0.02 * unit[k] * normal(random);
  for (int k = 0; k < at.m.size(); ++k)
    at.m[k] += 0.03 * at.objective.motion_units()[k] * normal(random);
}

TEST(Scale, EveryTermIsTheSameForARobotTwiceAsLarge) {
  Placed small(grown(1.0)), large(grown(2.0));
  disturb(small);
  disturb(large);
  const Evaluation a = small.objective.evaluate(small.s, small.m, Order::design);
  const Evaluation b = large.objective.evaluate(large.s, large.m, Order::design);
  const auto names = small.objective.term_names();
  for (std::size_t k = 0; k < names.size(); ++k) {
    EXPECT_NEAR(b.term_values[k], a.term_values[k], 1e-9 * std::abs(a.term_values[k]) + 1e-15)
        << names[k];
  }
  EXPECT_NEAR(b.value, a.value, 1e-9 * a.value);
  const VectorXd share_a = a.partial_s.cwiseProduct(small.objective.space().scale());
  const VectorXd share_b = b.partial_s.cwiseProduct(large.objective.space().scale());
  EXPECT_LT((share_a - share_b).norm(), 1e-8 * share_a.norm());
}

TEST(Scale, ThePlanOfARobotTwiceAsLargeIsTwiceAsLarge) {
  Placed small(grown(1.0)), large(grown(2.0));
  const VectorXd in_units = small.m.cwiseQuotient(small.objective.motion_units());
  EXPECT_LT((large.m.cwiseQuotient(large.objective.motion_units()) - in_units).norm(),
            1e-6 * in_units.norm())
      << "the first guess";
  NewtonOptions options;
  ASSERT_EQ(newton(small.objective, small.s, small.m, options).status, SolveStatus::converged);
  ASSERT_EQ(newton(large.objective, large.s, large.m, options).status, SolveStatus::converged);
  const VectorXd plan = small.m.cwiseQuotient(small.objective.motion_units());
  EXPECT_LT((large.m.cwiseQuotient(large.objective.motion_units()) - plan).norm(),
            1e-4 * plan.norm());
}

TEST(Scale, ATargetInMetresDoesNotScale) {  // the twin: these tests can fail
  Setting small = grown(1.0), large = grown(2.0);
  small.task.swing_height = large.task.swing_height = 0.025;
  Placed a(small), b(large);
  disturb(a);
  disturb(b);
  const double f = a.objective.evaluate(a.s, a.m, Order::value).value;
  EXPECT_GT(std::abs(b.objective.evaluate(b.s, b.m, Order::value).value - f), 1e-6 * f);
}

}  // namespace
}  // namespace legwright
