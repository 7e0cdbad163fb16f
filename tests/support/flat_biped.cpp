// SPDX-License-Identifier: Apache-2.0
#include "tests/support/flat_biped.hpp"

#include <string>

namespace legwright::test {
namespace {

using Eigen::Vector3d;

constexpr double kHip = 0.09, kThigh = 0.25, kShank = 0.25, kAnkle = 0.05;  // [m]
constexpr double kBend = 0.3;                                               // at home [rad]
enum Parameter { shank_length, hip_turn, ankle_turn, roll_turn, parameter_count };

DesignSpace make_space() {
  DesignSpace space;
  space.parameters.resize(parameter_count);
  space.parameters[shank_length] = {"shank_length", "m",  "length", ParameterKind::length,
                                    kShank,         0.15, 0.35,     2};
  const char* const names[] = {"hip_turn", "ankle_turn", "roll_turn"};
  for (int k = 0; k < 3; ++k)
    space.parameters[static_cast<std::size_t>(hip_turn + k)] = {
        names[k], "rad", "turn of a joint axis", ParameterKind::axis_angle, 0.0, -1.0, 1.0, 2};
  return space;
}

std::vector<PointMass> rod(double mass, double length) {
  return {{mass / 6, {}},
          {2 * mass / 3, {-0.5 * length * Vector3d::UnitZ(), {}}},
          {mass / 6, {-length * Vector3d::UnitZ(), {}}}};
}

/// Six links of a leg; `side` 1: left.
void add_leg(Morphology& robot, double side, double toes_out) {
  const std::string name = side > 0 ? "left" : "right";
  struct Hinge {
    const char* name;
    Vector3d axis, origin;
    double nominal, mass, length;
  };
  const Hinge hinges[] = {
      {"yaw", Vector3d::UnitZ(), {0, side * kHip, -0.05}, side * toes_out, 0.5, 0.02},
      {"roll", Vector3d::UnitX(), {0, 0, 0}, 0.0, 0.5, 0.02},
      {"pitch", Vector3d::UnitY(), {0, 0, 0}, -kBend, 2.0, kThigh},
      {"knee", Vector3d::UnitY(), {0, 0, -kThigh}, 2 * kBend, 1.5, kShank},
      {"ankle", Vector3d::UnitY(), {0, 0, 0}, -kBend, 0.3, 0.02},
      {"ankle_roll", Vector3d::UnitX(), {0, 0, 0}, 0.0, 0.4, kAnkle}};
  for (const Hinge& hinge : hinges) {
    Link link;
    link.name = name + "_" + hinge.name;
    link.parent = robot.links.size() % 6 == 1 ? 0 : static_cast<int>(robot.links.size()) - 1;
    link.origin.constant = hinge.origin;
    link.joint.name = link.name;
    link.joint.axis.reference = hinge.axis;
    link.joint.nominal = hinge.nominal;
    link.masses = rod(hinge.mass, hinge.length);
    robot.links.push_back(link);
  }
  // Mirror images of turns about z change sign, those of turns about y do not.
  Link* const first = &robot.links[robot.links.size() - 6];
  first[2].joint.axis.turns = {{hip_turn, side * Vector3d::UnitZ()}};
  first[4].origin.slopes = {{shank_length, -Vector3d::UnitZ()}};
  first[4].joint.axis.turns = {{ankle_turn, side * Vector3d::UnitZ()}};
  first[5].joint.axis.turns = {{roll_turn, Vector3d::UnitY()}};
  robot.feet.push_back({name + "_sole",
                        static_cast<int>(robot.links.size()) - 1,
                        {Vector3d(0.02, 0.0, -kAnkle), {}},
                        0.0,
                        Sole{}});
}

}  // namespace

Puppy make_flat_biped(double toes_out) {
  Puppy biped{{}, make_space()};
  Morphology& robot = biped.morphology;
  robot.name = "flat_biped";
  robot.leg_length = kThigh + kShank + kAnkle;
  Link trunk;
  trunk.name = "pelvis";
  for (const double sign : {-1.0, 1.0})
    for (int k = 0; k < 3; ++k)
      trunk.masses.push_back(
          {8.0 / 6, {Vector3d(0.02, 0.0, 0.1) + sign * 0.1 * Vector3d::Unit(k), {}}});
  robot.links.push_back(trunk);
  for (const double side : {1.0, -1.0}) add_leg(robot, side, toes_out);
  return biped;
}

Task make_flat_walk(int knot_count) {
  Task task;
  task.name = "flat_walk";
  task.gait = Gait(gait_library(2).front(), 1.0, knot_count, {0, 1});
  task.velocity = {0.05, 0.0};
  task.swing_height = 0.03;
  return task;
}

}  // namespace legwright::test
