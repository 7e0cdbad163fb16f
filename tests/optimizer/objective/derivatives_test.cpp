// SPDX-License-Identifier: Apache-2.0
// Exact derivatives of the whole F, through kinematics, against central differences.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <stdexcept>

#include "optimizer/objective/objective.hpp"
#include "optimizer/terms/registry.hpp"
#include "tests/support/puppy.hpp"
#include "tests/support/standing.hpp"

namespace legwright {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::Masses;

struct Point {
  VectorXd s, m;
};

/// A turning trot of few knots, so that every wrap and every term is in play.
Objective make_objective(const std::string& only = "", Masses masses = Masses::plain,
                         Dynamics dynamics = Dynamics::full) {
  test::Puppy puppy = test::make_puppy(true);
  test::add_pistons(puppy);
  test::add_soles(puppy);
  test::make_masses(puppy, masses);
  Morphology morphology = puppy.morphology;
  for (Link& link : morphology.links) {  // so that limits of angles and torques have elements
    link.joint.lower = -1.2;
    link.joint.upper = 1.2;
    link.joint.torque_limit = 0.6;
    link.joint.armature = 2e-4;
    link.joint.damping = 0.01;
    link.joint.stiffness = 0.1;
    link.joint.slack_angle = 0.3;
  }
  Task task = test::make_sideways_task(true, 8);
  task.velocity = {0.05, 0.1};
  task.turn_rate = 0.6;
  task.dynamics = dynamics;
  task.foot_heights.resize(4);
  task.foot_heights[3] = {{0.1, 0.7}, {0.02, 0.06}, 2.0};
  task.joint_angles.resize(12);
  task.joint_angles[4] = {{}, {-0.9, -1.1, -1.0}, 0.5};
  task.follow_hips = true;  // so that the footprint depends on the design
  task.up =
      up_on_slope(task.velocity, 0.2, -0.1);  // no derivative may think that gravity is along z
  if (!only.empty())
    for (const TermEntry& entry : term_registry())
      task.weights[std::string(entry.name)] = entry.name == only ? 1.0 : 0.0;
  return Objective(morphology, puppy.space, task);
}

Point random_point(const Objective& objective, unsigned seed) {
  std::mt19937 random(seed), random_ends(seed + 1);
  std::normal_distribution<double> normal, normal_ends;
  Point at{objective.space().initial(), {}};
  for (int k = 0; k < at.s.size(); ++k)
    at.s[k] +=
        0.1 * objective.space().scale()[k] *
        (objective.space().parameters[k].kind == ParameterKind::position ? normal_ends(random_ends)
                                                                         : normal(random));
  at.m = test::standing_motion(objective, at.s);
  for (int k = 0; k < at.m.size(); ++k)
    at.m[k] += 0.1 * objective.motion_units()[k] * normal(random);
  return at;
}

/// Largest error of `exact` against `differences`, relative to the largest entry of either.
double error(const MatrixXd& exact, const MatrixXd& differences) {
  return (exact - differences).cwiseAbs().maxCoeff() /
         std::max({1e-12, exact.cwiseAbs().maxCoeff(), differences.cwiseAbs().maxCoeff()});
}

struct Errors {
  double gradient_m, gradient_s, mm, ms, ss;
};

/// @param stride compares every stride-th entry of m. @param s_scale poisons ∂F/∂s by this factor
/// before the comparison (1: as it is).
Errors check(const Objective& objective, const Point& at, int stride, double s_scale = 1.0) {
  const Evaluation exact = objective.evaluate(at.s, at.m, Order::design);
  const int n = static_cast<int>(at.m.size()), n_s = static_cast<int>(at.s.size());
  const MatrixXd lower = exact.hessian_mm;
  const MatrixXd exact_mm = lower.selfadjointView<Eigen::Lower>();
  VectorXd gradient_m = exact.stationarity, gradient_s(n_s);
  MatrixXd mm = exact_mm, ms(n, n_s), ss(n_s, n_s);
  for (int k = 0; k < n; k += stride) {
    const double step = 1e-5 * objective.motion_units()[k];
    Point up = at, down = at;
    up.m[k] += step;
    down.m[k] -= step;
    const Evaluation a = objective.evaluate(up.s, up.m, Order::gradient);
    const Evaluation b = objective.evaluate(down.s, down.m, Order::gradient);
    gradient_m[k] = (a.value - b.value) / (2 * step);
    mm.col(k) = (a.stationarity - b.stationarity) / (2 * step);
  }
  for (int k = 0; k < n_s; ++k) {
    const double step = 1e-5 * objective.space().scale()[k];
    Point up = at, down = at;
    up.s[k] += step;
    down.s[k] -= step;
    const Evaluation a = objective.evaluate(up.s, up.m, Order::design);
    const Evaluation b = objective.evaluate(down.s, down.m, Order::design);
    gradient_s[k] = (a.value - b.value) / (2 * step);
    ms.col(k) = (a.stationarity - b.stationarity) / (2 * step);
    ss.col(k) = (a.partial_s - b.partial_s) / (2 * step);
  }
  // Scaled by units, so that entries of different dimension compare.
  const VectorXd units = objective.motion_units(), scale = objective.space().scale();
  return {error(units.cwiseProduct(exact.stationarity), units.cwiseProduct(gradient_m)),
          error(s_scale * scale.cwiseProduct(exact.partial_s), scale.cwiseProduct(gradient_s)),
          error(units.asDiagonal() * exact_mm * units.asDiagonal(),
                units.asDiagonal() * mm * units.asDiagonal()),
          error(units.asDiagonal() * exact.hessian_ms * scale.asDiagonal(),
                units.asDiagonal() * ms * scale.asDiagonal()),
          error(scale.asDiagonal() * exact.hessian_ss * scale.asDiagonal(),
                scale.asDiagonal() * ss * scale.asDiagonal())};
}

class ObjectiveDerivatives : public testing::TestWithParam<std::string> {};

TEST_P(ObjectiveDerivatives, MatchCentralDifferences) {
  const Objective objective = make_objective(GetParam());
  const Errors errors = check(objective, random_point(objective, 7), GetParam().empty() ? 1 : 7);
  EXPECT_LT(errors.gradient_m, 1e-6);
  EXPECT_LT(errors.gradient_s, 1e-6);
  EXPECT_LT(errors.mm, 1e-6);
  EXPECT_LT(errors.ms, 1e-6);
  EXPECT_LT(errors.ss, 1e-6);
}

// A gradient alone takes no Jacobian; with second derivatives it comes from them.
TEST_P(ObjectiveDerivatives, GradientAloneHasTheBitsOfTheOneByJacobians) {
  for (const Masses masses : {Masses::plain, Masses::printed, Masses::turning}) {
    const Objective objective = make_objective(GetParam(), masses);
    const Point at = random_point(objective, 7);
    const VectorXd alone = objective.evaluate(at.s, at.m, Order::gradient).stationarity;
    const VectorXd full = objective.evaluate(at.s, at.m, Order::hessian).stationarity;
    if (GetParam().empty()) {
      EXPECT_GT(alone.norm(), 0.0);
    }
    EXPECT_EQ((alone - full).lpNorm<Eigen::Infinity>(), 0.0);
  }
}

// Newton's second derivatives come from loads of poses, those with the design from each quantity.
TEST_P(ObjectiveDerivatives, HessianOfTheMotionAloneIsThatWithTheDesign) {
  for (const Masses masses : {Masses::plain, Masses::printed, Masses::turning}) {
    const Objective objective = make_objective(GetParam(), masses);
    const Point at = random_point(objective, 7);
    const auto scaled = [&](Order order) -> MatrixXd {
      return objective.motion_units().asDiagonal() *
             MatrixXd(objective.evaluate(at.s, at.m, order).hessian_mm) *
             objective.motion_units().asDiagonal();
    };
    EXPECT_LT(error(scaled(Order::hessian), scaled(Order::design)), 1e-12);
  }
}

/// Masses that grow with their bodies: M(s), centre of mass, momentum and torques depend on it.
TEST_P(ObjectiveDerivatives, MatchCentralDifferencesOfMassesThatGrowOrTurn) {
  for (const Masses masses : {Masses::printed, Masses::turning}) {
    const Objective objective = make_objective(GetParam(), masses);
    const Errors errors = check(objective, random_point(objective, 7), 23);
    EXPECT_LT(errors.gradient_m, 1e-6);
    EXPECT_LT(errors.gradient_s, 1e-6);
    EXPECT_LT(errors.ms, 3e-6);
    EXPECT_LT(errors.ss, 3e-6);
  }
}

/// The paper's torque balance: moments of inertia of the home pose, which follow the design.
TEST(ObjectiveDerivativesOfConstantInertia, MatchCentralDifferences) {
  for (const Masses masses : {Masses::plain, Masses::printed, Masses::turning}) {
    const Objective objective =
        make_objective("torque_balance", masses, Dynamics::constant_inertia);
    const Errors errors = check(objective, random_point(objective, 7), 3);
    EXPECT_LT(errors.gradient_m, 1e-6);
    EXPECT_LT(errors.gradient_s, 1e-6);
    EXPECT_LT(errors.mm, 1e-6);
    EXPECT_LT(errors.ms, 1e-6);
    EXPECT_LT(errors.ss, 1e-6);
  }
  const Objective objective =
      make_objective("torque_balance", Masses::turning, Dynamics::constant_inertia);
  EXPECT_GT(check(objective, random_point(objective, 7), 7, 1.0001).gradient_s, 1e-6);  // poison
}

/// Limbs that nearly touch a trunk whose shape follows the design.
TEST(ObjectiveDerivativesOfCapsules, MatchCentralDifferences) {
  test::Puppy puppy = test::make_puppy(true);
  test::add_thick_capsules(puppy);
  Task task = test::make_sideways_task(true, 8);
  for (const TermEntry& entry : term_registry())
    task.weights[std::string(entry.name)] = entry.name == "limb_clearance" ? 1.0 : 0.0;
  task.limb_pairs.emplace();  // of limbs none: those with the trunk alone
  const Objective objective(puppy.morphology, puppy.space, task);
  const Point at = random_point(objective, 7);
  EXPECT_GT(objective.evaluate(at.s, at.m, Order::value).value, 0.0);
  const Errors errors = check(objective, at, 3);
  EXPECT_LT(errors.gradient_m, 1e-6);
  EXPECT_LT(errors.gradient_s, 1e-6);
  EXPECT_LT(errors.mm, 1e-5);
  EXPECT_LT(errors.ms, 1e-5);
  EXPECT_LT(errors.ss, 1e-5);
  EXPECT_GT(check(objective, at, 3, 1.0001).gradient_s, 1e-6);  // poison is noticed
}

std::vector<std::string> all_terms() {
  std::vector<std::string> names{""};  // the whole F
  for (const TermEntry& entry : term_registry()) names.emplace_back(entry.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Registry, ObjectiveDerivatives, testing::ValuesIn(all_terms()),
                         [](const auto& instance) {
                           return instance.param.empty() ? "whole" : instance.param;
                         });

TEST(ObjectiveDerivativesControl, PoisonedGradientIsNoticed) {
  const Objective objective = make_objective("com_position");
  EXPECT_GT(check(objective, random_point(objective, 7), 7, 1.0001).gradient_s, 1e-6);
}

TEST(ObjectiveWorkspace, CanBeHandedToAnotherRobot) {
  const Objective first = make_objective();
  test::Puppy heavy = test::make_puppy(true);
  test::add_pistons(heavy);
  for (Link& link : heavy.morphology.links)
    for (PointMass& point : link.masses) point.mass *= 2.0;
  const Objective second(heavy.morphology, heavy.space, test::make_sideways_task(false, 8));
  const std::unique_ptr<Objective::Workspace> workspace = first.make_workspace();
  Evaluation reused;
  const VectorXd s = first.space().initial();
  first.evaluate(s, initial_guess(first, s), Order::hessian, *workspace, reused);
  const VectorXd m = initial_guess(second, s);
  second.evaluate(s, m, Order::hessian, *workspace, reused);
  const Evaluation fresh = second.evaluate(s, m, Order::hessian);
  EXPECT_EQ(reused.value, fresh.value);
  EXPECT_EQ(reused.stationarity, fresh.stationarity);
  EXPECT_EQ(MatrixXd(reused.hessian_mm), MatrixXd(fresh.hessian_mm));
}

TEST(Objective, RefusesVectorsOfTheWrongSize) {
  const Objective objective = make_objective();
  const VectorXd s = objective.space().initial(), m = initial_guess(objective, s);
  EXPECT_THROW(objective.evaluate(s, m.head(m.size() - 1), Order::value), std::invalid_argument);
  EXPECT_THROW(objective.evaluate(s.head(3), m, Order::value), std::invalid_argument);
}

}  // namespace
}  // namespace legwright
