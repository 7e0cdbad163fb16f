// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/made_up_robots.hpp"

#include <fmt/format.h>

#include <map>
#include <random>
#include <vector>

#include "tools/task/task_file.hpp"

namespace legwright::bench {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double size = 0.05;  // initial value of a made-up parameter [m]

AffineVector frozen(const AffineVector& v, const VectorXd& s) { return {v.at(s), {}}; }

/// Adds slope·(s − size): nothing changes at the initial design.
void add_slope(AffineVector& v, int parameter, const Vector3d& slope) {
  v.slopes.push_back({parameter, slope});
  v.constant -= size * slope;
}

/// A copy of a leg `ahead` metres further ahead, at the end of the robot's links.
void add_leg(const Morphology& from, int foot, double ahead, Morphology& robot) {
  std::map<int, int> place{{0, 0}};  // of a link of `from`
  for (const int each : from.chain_to(from.feet[foot].link)) {
    Link link = from.links[each];
    link.parent = place.at(link.parent);
    if (link.parent == 0) link.origin.constant.x() += ahead;
    link.name = link.joint.name = fmt::format("{}_{}", link.name, robot.links.size());
    place[each] = static_cast<int>(robot.links.size());
    robot.links.push_back(std::move(link));
  }
  Foot copy = from.feet[foot];
  copy.link = place.at(copy.link);
  copy.name = fmt::format("foot_{}", robot.feet.size());
  robot.feet.push_back(std::move(copy));
}

}  // namespace

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
  for (Capsule& capsule : robot.capsules) {
    capsule.from = frozen(capsule.from, s);
    capsule.to = frozen(capsule.to, s);
  }
  return robot;
}

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

Morphology with_rows(const Morphology& hexapod, int rows) {
  const std::vector<int> order = footfall_order(home_feet(hexapod, {}));
  Morphology robot = hexapod;
  robot.links.resize(1);
  robot.feet.clear();
  robot.linear_actuators.clear();
  robot.capsules.clear();
  robot.capsule_pairs.clear();
  for (int row = 0; row < rows; ++row)
    for (const int side : {2, 3})
      add_leg(hexapod, order[side], hexapod.leg_length * (0.5 * (rows - 1) - row), robot);
  return robot;
}

Task alternating(Task task, const Morphology& robot) {
  GaitPattern pattern{"alternating", {}, 0.6};
  for (int place = 0; place < robot.foot_count(); ++place)
    pattern.touchdown.push_back((place / 2 + place % 2) % 2 == 0 ? 0.0 : 0.5);
  std::vector<int> order(robot.feet.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<int>(k);
  task.gait = Gait(pattern, task.gait.period(), task.gait.knot_count(), order);
  task.footprint.reset();
  task.limb_pairs.reset();
  return task;
}

}  // namespace legwright::bench
