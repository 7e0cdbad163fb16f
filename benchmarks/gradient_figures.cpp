// SPDX-License-Identifier: Apache-2.0
// Price of a design parameter: the adjoint design gradient at 10, 50 and 200 of them.
#include <fmt/format.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "benchmarks/figures.hpp"
#include "benchmarks/timing.hpp"
#include "optimizer/solve/adjoint.hpp"

namespace legwright::bench {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double size = 0.05;  // initial value of a made-up parameter [m]

AffineVector frozen(const AffineVector& v, const VectorXd& s) { return {v.at(s), {}}; }

/// The robot at one design, with nothing left to choose.
Morphology frozen(Morphology robot, const VectorXd& s) {
  for (Link& link : robot.links) {
    link.origin = frozen(link.origin, s);
    link.joint.axis = {link.joint.axis.at(s), {}};
    for (PointMass& mass : link.masses) {
      const double growth = mass.growth_at(s);
      mass = {growth * mass.mass, frozen(mass.position, s), {}, growth * mass.volume};
    }
  }
  for (LinearActuator& actuator : robot.linear_actuators) {
    actuator.upper = frozen(actuator.upper, s);
    actuator.lower = frozen(actuator.lower, s);
  }
  for (Foot& foot : robot.feet) foot.position = frozen(foot.position, s);
  return robot;
}

/// Adds slope·(s − size): nothing changes at the initial design.
void add_slope(AffineVector& v, int parameter, const Vector3d& slope) {
  v.slopes.push_back({parameter, slope});
  v.constant -= size * slope;
}

/// Gives the robot `count` parameters: three of four move what hangs below a link, and one of the
/// link's masses, along a random direction; the others turn a joint axis.
DesignSpace give_parameters(Morphology& robot, int count) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  DesignSpace space;
  for (int k = 0; k < count; ++k) {
    const int place = 1 + k % robot.joint_count();
    const Vector3d direction =
        Vector3d(normal(random), normal(random), normal(random)).normalized();
    const bool turns = k % 4 == 3;
    space.parameters.push_back({fmt::format("p{}", k), turns ? "rad" : "m", "made up",
                                turns ? ParameterKind::axis_angle : ParameterKind::length,
                                turns ? 0.0 : size, turns ? -1.0 : 0.5 * size,
                                turns ? 1.0 : 2.0 * size, 1});
    Link& link = robot.links[place];
    if (turns) {
      link.joint.axis.turns.push_back({k, direction});
      continue;
    }
    for (Link& child : robot.links)
      if (child.parent == place) add_slope(child.origin, k, direction);
    for (Foot& foot : robot.feet)
      if (foot.link == place) add_slope(foot.position, k, direction);
    if (!link.masses.empty()) add_slope(link.masses[k % link.masses.size()].position, k, direction);
  }
  return space;
}

/// dF/ds and a Newton iteration of one robot.
class Gradient {
 public:
  Gradient(const Objective& objective, const VectorXd& s, VectorXd m)
      : cost_(objective), s_(s), m_(std::move(m)) {
    report_ = newton(cost_, s_, m_, {}, workspace_);
    if (report_.status != SolveStatus::converged)
      throw std::runtime_error("the motion of the robot with made-up parameters did not converge");
    cost_.evaluate(s_, m_, Order::hessian, at_);
    if (!factor_.factor(at_.hessian_mm, {})) throw std::runtime_error("not a minimum");
  }
  // As in co-design: Newton's method leaves the exact factor behind.
  void by_adjoint() {
    cost_.evaluate(s_, m_, Order::design, design_);
    result_ = adjoint(factor_, design_.stationarity, design_.hessian_ms, design_.partial_s);
  }
  void newton_iteration() {
    cost_.evaluate(s_, m_, Order::hessian, at_);
    if (!factor_.factor(at_.hessian_mm, {}) || !factor_.solve(at_.stationarity, step_))
      throw std::runtime_error("not a minimum");
    cost_.evaluate(s_, m_, Order::gradient, trial_);
  }
  // One entry of dF/ds: two motion solves from m*.
  double by_differences(int k) {
    constexpr double h = 1e-5;
    double value[2];
    for (const int side : {0, 1}) {
      VectorXd s = s_, m = m_;
      s[k] += side == 1 ? h : -h;
      value[side] = newton(cost_, s, m, {}, workspace_).value;
    }
    return (value[1] - value[0]) / (2 * h);
  }
  double entry(int k) const { return result_.dJ_ds[k]; }

 private:
  ObjectiveCost cost_;
  VectorXd s_, m_, step_;
  Evaluation at_, trial_, design_;
  HessianFactor factor_;
  NewtonWorkspace workspace_;
  SolveReport report_;
  AdjointResult result_;
};

}  // namespace

Group gradient_figures(const SolvedCase& solved) {
  Group group;
  const Morphology body = frozen(solved.problem.robot.morphology, solved.s);
  for (const int count : {10, 50, 200}) {
    Morphology robot = body;
    const DesignSpace space = give_parameters(robot, count);
    const Objective objective(robot, space, solved.problem.objectives[0]->task());
    Gradient gradient(objective, space.initial(), solved.m[0]);
    double worst = 0.0;
    int entry = 0;
    const std::vector<Times> times =
        interleave({{"Newton iteration", [&] { gradient.newton_iteration(); }},
                    {"design gradient by adjoint", [&] { gradient.by_adjoint(); }},
                    {"one entry by central differences", [&] {
                       const double difference = gradient.by_differences(entry);
                       const double error = std::abs(difference - gradient.entry(entry));
                       worst = std::max(worst, error / std::max(1.0, std::abs(difference)));
                       entry = (entry + 7) % count;
                     }}});
    const double adjoint = times[1].min();
    const double over_iteration = adjoint / times[0].min();
    const double faster = count * times[2].median() / times[1].median();
    group.details[std::to_string(count)] = {{"times", to_json(times)},
                                            {"over_newton_iteration", over_iteration},
                                            {"differences_over_adjoint", faster},
                                            {"largest_disagreement", worst}};
    const std::string at = "at " + std::to_string(count) + " parameters";
    group.figures.push_back({"design gradient over one Newton iteration, " + at, 1.5, 1.0,
                             over_iteration, false, "×", solved.of.label});
    group.figures.push_back({"central differences over the adjoint gradient, " + at,
                             static_cast<double>(count), 2.0 * count, faster, true, "×",
                             solved.of.label});
  }
  return group;
}

}  // namespace legwright::bench
