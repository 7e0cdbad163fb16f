// SPDX-License-Identifier: Apache-2.0
#include "tests/support/puppy.hpp"

#include <Eigen/Geometry>
#include <string>

namespace legwright::test {
namespace {

using Eigen::Vector3d;

constexpr std::array<double, 3> kLengths{0.06, 0.08, 0.07}, kNominal{0.5, -1.0, 0.6};
constexpr double kMotor = 0.08, kFoot = 0.02, kRodDensity = 0.4, kWidth = 0.14, kLength = 0.24;
constexpr double kHeight = 0.05;

/// Numbers the parameters of one design space, tied or not.
class Parameters {
 public:
  explicit Parameters(bool tied) : tied_(tied) {}

  int length(int leg, int link) const { return tied_ ? 3 * (leg / 2) + link : 3 * leg + link; }
  int angle(int leg, int link, int which) const {
    return tied_ ? 6 + 2 * (3 * (leg / 2) + link) + which : 12 + 2 * (3 * leg + link) + which;
  }
  int width() const { return tied_ ? 18 : 36; }
  int body_length() const { return tied_ ? 19 : 37; }
  int size() const { return tied_ ? 20 : 38; }
  int copies() const { return tied_ ? 2 : 1; }

 private:
  bool tied_;
};

DesignSpace make_space(const Parameters& parameters) {
  DesignSpace space;
  space.parameters.resize(parameters.size());
  for (int leg = 0; leg < 4; ++leg)
    for (int link = 0; link < 3; ++link) {
      const std::string where = std::to_string(leg) + "_" + std::to_string(link);
      const double l = kLengths[link];
      space.parameters[parameters.length(leg, link)] = {
          "length_" + where, "m",     "length of a link", ParameterKind::length, l,
          0.6 * l,           1.6 * l, parameters.copies()};
      for (int which = 0; which < 2; ++which)
        space.parameters[parameters.angle(leg, link, which)] = {
            "axis_" + where + (which ? "_x" : "_z"),
            "rad",
            "turn of a joint axis",
            ParameterKind::axis_angle,
            0.0,
            -1.4,
            1.4,
            parameters.copies()};
    }
  space.parameters[parameters.width()] = {
      "body_width", "m", "width", ParameterKind::length, kWidth, 0.5 * kWidth, 1.6 * kWidth, 1};
  space.parameters[parameters.body_length()] = {"body_length",         "m",     "length",
                                                ParameterKind::length, kLength, 0.5 * kLength,
                                                1.6 * kLength,         1};
  return space;
}

AffineVector along(double share, const Vector3d& direction, int parameter) {
  return {Vector3d::Zero(), {{parameter, share * direction}}};
}

}  // namespace

Puppy make_puppy(bool tied) {
  const Parameters parameters(tied);
  Puppy puppy{{}, make_space(parameters)};
  Morphology& robot = puppy.morphology;
  robot.name = "puppy";
  robot.leg_length = kLengths[0] + kLengths[1] + kLengths[2];
  Link trunk;
  trunk.name = "trunk";
  for (double sign : {-1.0, 1.0}) {
    trunk.masses.push_back({1.0 / 6, along(sign / 2, Vector3d::UnitX(), parameters.body_length())});
    trunk.masses.push_back({1.0 / 6, along(sign / 2, Vector3d::UnitY(), parameters.width())});
    trunk.masses.push_back({1.0 / 6, {sign / 2 * kHeight * Vector3d::UnitZ(), {}}});
  }
  robot.links.push_back(trunk);
  for (int leg = 0; leg < 4; ++leg) {
    const double front = leg < 2 ? 0.5 : -0.5, left = leg % 2 == 0 ? 0.5 : -0.5;
    const AffineVector hip{Vector3d::Zero(),
                           {{parameters.body_length(), front * Vector3d::UnitX()},
                            {parameters.width(), left * Vector3d::UnitY()}}};
    robot.links[0].masses.push_back({kMotor, hip});
    for (int k = 0; k < 3; ++k) {
      Link link;
      link.name = "link" + std::to_string(leg) + "_" + std::to_string(k);
      link.parent = k == 0 ? 0 : static_cast<int>(robot.links.size()) - 1;
      link.origin = k == 0 ? hip : along(-1.0, Vector3d::UnitZ(), parameters.length(leg, k - 1));
      link.joint.name = "joint" + std::to_string(leg) + "_" + std::to_string(k);
      link.joint.nominal = kNominal[k];
      const double mirror =
          tied && left < 0 ? -1.0 : 1.0;  // (−x, y, −z): both directions change sign
      link.joint.axis.turns = {{parameters.angle(leg, k, 0), mirror * Vector3d::UnitZ()},
                               {parameters.angle(leg, k, 1), mirror * Vector3d::UnitX()}};
      const double rod = kRodDensity * kLengths[k], tip = k == 2 ? kFoot : kMotor;
      const int l = parameters.length(leg, k);
      link.masses = {{rod / 6, {}},
                     {2 * rod / 3, along(-0.5, Vector3d::UnitZ(), l)},
                     {rod / 6 + tip, along(-1.0, Vector3d::UnitZ(), l)}};
      robot.links.push_back(link);
    }
    robot.feet.push_back({"foot" + std::to_string(leg), static_cast<int>(robot.links.size()) - 1,
                          along(-1.0, Vector3d::UnitZ(), parameters.length(leg, 2)), 0.012});
  }
  return puppy;
}

void add_pistons(Puppy& puppy) {
  const int first = puppy.space.size();
  const Vector3d lower(0.015, 0.0, -0.035);
  for (int k = 0; k < 3; ++k)
    puppy.space.parameters.push_back({std::string("piston_") + "xyz"[k], "m", "end of a piston",
                                      ParameterKind::position, lower[k], lower[k] - 0.02,
                                      lower[k] + 0.02, 4});
  for (int leg = 0; leg < 4; ++leg) {
    const int knee = 3 * leg + 1;
    const AffineVector& thigh = puppy.morphology.links[knee + 1].origin;
    LinearActuator piston;
    piston.name = "piston_" + std::to_string(leg);
    piston.joint = knee;
    piston.upper = {Vector3d(0.02, 0.0, 0.0), {}};
    for (const AffineVector::Slope& slope : thigh.slopes)  // a sixth of the way down
      piston.upper.slopes.push_back({slope.parameter, slope.slope / 6});
    for (int k = 0; k < 3; ++k)
      piston.lower.slopes.push_back(
          {first + k, (k == 1 && leg % 2 == 1 ? -1.0 : 1.0) * Vector3d::Unit(k)});
    piston.shortest = 0.045;
    piston.longest = 0.082;
    piston.force_limit = 120.0;
    puppy.morphology.linear_actuators.push_back(std::move(piston));
  }
}

void add_capsules(Puppy& puppy, double low, double radius) {
  Morphology& robot = puppy.morphology;
  const auto index = [&](const std::string& name) {
    int k = 0;
    while (puppy.space.parameters[static_cast<std::size_t>(k)].name != name) ++k;
    return k;
  };
  const int width = index("body_width"), length = index("body_length");
  int part = 0;
  for (const double side : {0.3, -0.3}) {
    const auto end = [&](double front) {
      return AffineVector{-low * Vector3d::UnitZ(),
                          {{length, front * Vector3d::UnitX()}, {width, side * Vector3d::UnitY()}}};
    };
    robot.capsules.push_back({0, part++, end(0.5), end(-0.5), radius});
  }
  for (const Foot& foot : robot.feet) {
    const int shank = foot.link, thigh = robot.links[static_cast<std::size_t>(shank)].parent;
    robot.capsules.push_back(
        {thigh, part++, {}, robot.links[static_cast<std::size_t>(shank)].origin, 0.008});
    robot.capsules.push_back({shank, part++, {}, foot.position, 0.006});
  }
  for (int trunk = 0; trunk < 2; ++trunk)
    for (int limb = 2; limb < part; ++limb) robot.capsule_pairs.push_back({trunk, limb});
}

void add_thick_capsules(Puppy& puppy) { add_capsules(puppy, -0.05, 0.08); }

void add_soles(Puppy& puppy) {
  double turn = 0.2;
  for (Foot& foot : puppy.morphology.feet) {
    const Eigen::Quaterniond askew(Eigen::AngleAxisd(turn, Vector3d(1.0, -2.0, 0.5).normalized()));
    foot.sole = Sole{askew * Vector3d::UnitX(), askew * Vector3d::UnitY()};
    turn += 0.3;
  }
}

void print_bodies(Puppy& puppy) {
  std::vector<Link>& links = puppy.morphology.links;
  const Eigen::VectorXd initial = puppy.space.initial();
  const int width = puppy.space.find("body_width"), length = puppy.space.find("body_length");
  for (std::size_t l = 0; l < links.size(); ++l)
    for (std::size_t p = 0; p < links[l].masses.size() && p < 6; ++p) {
      PointMass& point = links[l].masses[p];
      if (l == 0)
        point.growth = {{width, initial[width]}, {length, initial[length]}};
      else if (!point.position.slopes.empty() && p < 2)
        point.growth = {
            {point.position.slopes[0].parameter, initial[point.position.slopes[0].parameter]}};
      point.volume = point.mass / 1000.0;
    }
}

void hang_servos(Puppy& puppy) {
  std::vector<Link>& links = puppy.morphology.links;
  for (std::size_t l = 1; l < links.size(); ++l)
    for (const Vector3d& arm : {Vector3d(0.03, 0.01, -0.02), Vector3d(-0.01, 0.02, 0.03)}) {
      PointMass point{0.03, links[l].origin};
      point.arm = {arm, links[l].joint.axis.turns};
      links[static_cast<std::size_t>(links[l].parent)].masses.push_back(point);
    }
}

void make_masses(Puppy& puppy, Masses masses) {
  if (masses == Masses::printed) print_bodies(puppy);
  if (masses == Masses::turning) hang_servos(puppy);
}

Task make_sideways_task(bool trot, int knot_count, int planted_margin) {
  const GaitPattern pattern = trot ? GaitPattern{"trot", {0, 0.5, 0.5, 0}, 0.5}
                                   : GaitPattern{"walk", {0, 0.5, 0.75, 0.25}, 0.75};
  Task task;
  task.name = trot ? "sideways_trot" : "sideways";
  task.gait = Gait(pattern, trot ? 0.4 : 1.0, knot_count, {0, 1, 2, 3});
  task.velocity = {0.0, 0.1};
  task.com_height = 0.175;
  task.footprint =
      std::vector<Eigen::Vector2d>{{0.12, 0.09}, {0.12, -0.09}, {-0.12, 0.09}, {-0.12, -0.09}};
  task.min_normal = 0.1;
  task.swing_height = 0.025;
  task.planted_margin = planted_margin;
  return task;
}

}  // namespace legwright::test
