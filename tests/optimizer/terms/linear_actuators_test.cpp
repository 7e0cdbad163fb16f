// SPDX-License-Identifier: Apache-2.0
// What the terms of linear actuators mean: zero slack at the ends of the stroke and at the limit of
// the force.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "optimizer/design/actuator_length.hpp"
#include "optimizer/terms/registry.hpp"
#include "tests/support/term_context.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

class LinearActuatorTerms : public testing::Test {
 protected:
  std::unique_ptr<Term> make(std::string_view name) const {
    for (const TermEntry& entry : term_registry())
      if (entry.name == name) return entry.make(setting_.context());
    return nullptr;
  }
  /// Local variables of an actuator at the initial design.
  VectorXd at(int actuator, double angle, int size) const {
    const Morphology& robot = setting_.puppy.morphology;
    VectorXd z = VectorXd::Zero(size);
    z.head<3>() =
        actuator_shape(robot, robot.linear_actuators[actuator], setting_.puppy.space.initial())
            .value;
    z[3] = angle;
    return z;
  }
  static VectorXd residual(const Term& term, const VectorXd& z) {
    VectorXd r(2);
    term.residual(0, z, r);
    return r;
  }
  test::TermSetting setting_;
};

TEST_F(LinearActuatorTerms, StrokeHasNoSlackAtItsEnds) {
  const std::unique_ptr<Term> term = make("stroke_limits");
  const LinearActuator& piston = setting_.puppy.morphology.linear_actuators[0];
  const double leg = setting_.puppy.morphology.leg_length;
  const auto length = [&](double q) { return leg * actuator_length(at(0, q, 4).head<3>(), q); };
  // The knee bends back: the piston in front of it grows with the angle.
  double low = -2.0, high = 0.0;
  for (int k = 0; k < 60; ++k)
    (length(0.5 * (low + high)) < piston.longest ? low : high) = 0.5 * (low + high);
  const VectorXd r = residual(*term, at(0, low, 4));
  EXPECT_NEAR(r[1], 0.0, 1e-9);
  EXPECT_NEAR(r[0], 2.0, 1e-9);
  EXPECT_NEAR(term->unit(0, 0).size, 0.5 * (piston.longest - piston.shortest), 1e-12);
  EXPECT_LT(residual(*term, at(0, low + 0.1, 4))[1], -0.05);
  EXPECT_EQ(term->subject(0, 0), "piston_0");
}

TEST_F(LinearActuatorTerms, ForceHasNoSlackAtItsLimit) {
  const std::unique_ptr<Term> term = make("actuator_force");
  const Morphology& robot = setting_.puppy.morphology;
  const double allowed =
      (1.0 - setting_.task.torque_margin) * robot.linear_actuators[0].force_limit;
  VectorXd z = at(0, -0.7, 5);
  z[4] = allowed * robot.leg_length * moment_arm(z.head<3>(), z[3]);
  VectorXd r = residual(*term, z);
  EXPECT_NEAR(std::min(r[0], r[1]), 0.0, 1e-9);
  z[4] *= -1.0;  // pulling is as strong as pushing
  EXPECT_NEAR(residual(*term, z).minCoeff(), 0.0, 1e-9);
  z[4] *= 1.1;
  EXPECT_LT(residual(*term, z).minCoeff(), -0.1);
  z[4] = 0.0;
  EXPECT_GT(residual(*term, z).minCoeff(), 1.0);  // beyond the reach of the barrier
}

/// Force and speed of the rod share what the motor has, as on the straight line between them.
TEST_F(LinearActuatorTerms, ForceAtASpeedHasNoSlackOnItsLine) {
  const std::unique_ptr<Term> term = make("actuator_force");
  const Morphology& robot = setting_.puppy.morphology;
  const MotorLine& motor = *robot.links[robot.linear_actuators[2].joint + 1].joint.line;
  int own = 0;
  while (term->subject(own, 0) != "piston_2 at its speed") ++own;
  VectorXd z = at(2, -0.7, 7), r(2);
  const double arm = robot.leg_length * moment_arm(z.head<3>(), z[3]), share = 0.4,
               step = setting_.task.gait.time_step();
  const double rod_speed = share * motor.no_load_speed,
               force = (1.0 - share) * (1.0 - setting_.task.torque_margin) * motor.stall_torque;
  z[4] = force * arm;
  z[5] = -0.7 - rod_speed / arm * step;
  z[6] = -0.7 + rod_speed / arm * step;
  term->residual(own, z, r);
  EXPECT_NEAR(r.minCoeff(), 0.0, 1e-9) << "all that it has left";
  std::swap(z[5], z[6]);  // pulled out against its force: it brakes
  term->residual(own, z, r);
  EXPECT_GT(r.minCoeff(), 0.5);
  z[4] *= -1.0;
  term->residual(own, z, r);
  EXPECT_NEAR(r.minCoeff(), 0.0, 1e-9) << "and the other way round";
  z[5] = z[6] = -0.7;
  term->residual(own, z, r);
  EXPECT_GT(r.minCoeff(), 0.5) << "at rest";
}

/// Elements that are left out would have cost nothing.
TEST_F(LinearActuatorTerms, OnlyThoseNearTheirLimitAreActive) {
  const std::unique_ptr<Term> term = make("actuator_force");
  std::mt19937 random(2);
  VectorXd extended = VectorXd::Zero(setting_.layout.extended_size());
  const auto& elements = term->elements();
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const VectorXd z = term->sample(static_cast<int>(e), random);
    for (std::size_t k = 0; k < elements[e].slots.size(); ++k)
      extended[elements[e].slots[k]] = z[static_cast<Eigen::Index>(k)];
  }
  std::vector<int> active;
  ASSERT_TRUE(term->select_active(extended, active));
  std::size_t next = 0, idle = 0;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    VectorXd z(elements[e].slots.size()), r(2);
    for (std::size_t k = 0; k < elements[e].slots.size(); ++k)
      z[static_cast<Eigen::Index>(k)] = extended[elements[e].slots[k]];
    term->residual(static_cast<int>(e), z, r);
    const bool listed = next < active.size() && active[next] == static_cast<int>(e);
    next += listed ? 1 : 0;
    EXPECT_EQ(listed, r.minCoeff() < 1.0) << e;
    idle += listed ? 0 : 1;
  }
  EXPECT_GT(idle, 0u);
  EXPECT_GT(active.size(), 0u);
}

}  // namespace
}  // namespace legwright
