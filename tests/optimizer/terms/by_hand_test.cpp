// SPDX-License-Identifier: Apache-2.0
// Every term of the registry against a calculation by hand, at an arbitrary point of the extended
// vector [s; m; y]. A term without an entry in the table below fails.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "optimizer/design/actuator_length.hpp"
#include "optimizer/terms/registry.hpp"
#include "tests/optimizer/terms/term_bench.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

using Bench = test::TermBench;

struct ByHand {
  Penalty penalty;
  std::function<void(Bench&)> check;
};

void travel(Bench& b) {
  const Vector3d x0 = b.at(b.layout().com(0)), xT = b.at(b.layout().com(8));
  b.expect(0, b.layout().com(8), (xT - Bench::heading(0.4) * x0 - Bench::path(0.4)) / b.leg());
}

void turning(Bench& b) {
  const int first = b.layout().pose(0) + 5, last = b.layout().pose(8) + 5;
  b.expect(0, last, b.x[last] - b.x[first] - 0.24);
}

void style_com(Bench& b) {
  const Vector3d wanted = Bench::path(3 * b.h()) + 0.175 * Vector3d::UnitZ();
  b.expect(3, b.layout().com(3), (b.at(b.layout().com(3)) - wanted) / b.leg());
}

void style_foot(Bench& b) {
  const Vector3d wanted =
      Bench::path(3 * b.h()) + Bench::heading(3 * b.h()) * Vector3d(0.12, -0.09, 0);
  const int slot = b.layout().foot(3, 1);
  b.expect(3, slot, ((b.at(slot) - wanted) / b.leg()).head<2>());
}

void style_foot_height(Bench& b) {
  // 20 mm at 0.1 of the cycle, 60 mm at 0.7, with a weight of its own of 2.
  const int i = Bench::first([&](int k) { return !b.planted(k, 3); });
  const double phase = i / 8.0, share = (phase - 0.1) / 0.6;
  ASSERT_TRUE(share > 0.0 && share < 1.0);
  const int slot = b.layout().foot(i, 3) + 2;
  const double wanted = b.robot().feet[3].radius + 0.02 + share * 0.04;
  b.expect(i, slot, std::sqrt(2.0) * (b.x[slot] - wanted) / b.leg());
  for (const Element& element : b.term->elements()) {
    EXPECT_EQ(element.foot, 3);
    EXPECT_FALSE(b.planted(element.knot, 3));
  }
}

void style_joint(Bench& b) {
  // −0.9, −1.1 and −1.0 rad at thirds of the cycle, with a weight of its own of 0.5.
  for (const auto& [knot, wanted] : {std::pair(0, -0.9), std::pair(2, -1.05), std::pair(8, -0.9)}) {
    const int slot = b.layout().pose(knot) + 6 + 4;
    b.expect(knot, slot, std::sqrt(0.5) * (b.x[slot] - wanted));
  }
  EXPECT_EQ(b.term->elements().size(), 9u);
  EXPECT_EQ(b.term->subject(0, 0), b.robot().links[5].joint.name);
}

void trunk_orientation(Bench& b) {
  const int slot = b.layout().pose(3) + 3;
  b.expect(3, slot, b.at(slot) - 0.6 * 3 * b.h() * Vector3d::UnitZ());
}

void nominal_pose(Bench& b) {
  const int slot = b.layout().pose(2) + 6;
  VectorXd wanted = b.x.segment(slot, 12);
  for (int a = 0; a < 12; ++a) wanted[a] -= b.robot().links[a + 1].joint.nominal;
  b.expect(2, slot, wanted);
}

void smoothness(Bench& b) {
  // 4e-3 s² for legs of 21 cm, which the puppy has and does not bend by much.
  const double scale = 4e-3 / (b.h() * b.h()) * b.leg() / 0.21;
  const auto q = [&](int knot) { return b.x.segment(b.layout().pose(knot) + 3, 15); };
  b.expect(2, b.layout().pose(2) + 3, scale * (q(1) - 2 * q(2) + q(3)));
  VectorXd before = q(7);
  before[2] -= 0.24;
  b.expect(0, b.layout().pose(0) + 3, scale * (before - 2 * q(0) + q(1)));
}

void com_position(Bench& b) {
  const int phi = b.layout().com_from_pose(4), com = b.layout().com(4);
  b.expect(4, com, (b.at(phi) - b.at(com)) / b.leg());
}

void foot_position(Bench& b) {
  const int phi = b.layout().foot_from_pose(4, 2), foot = b.layout().foot(4, 2);
  b.expect(4, foot, (b.at(phi) - b.at(foot)) / b.leg());
}

void force_balance(Bench& b) {
  const auto com = [&](int knot) { return b.at(b.layout().com(knot)); };
  for (const int knot : {0, 2}) {
    const Vector3d before = knot > 0 ? com(knot - 1) : Bench::cycle_earlier(com(7));
    Vector3d sum = -b.mass() * ((before - 2 * com(knot) + com(knot + 1)) / (b.h() * b.h()) +
                                9.81 * Vector3d::UnitZ());
    for (int j = 0; j < 4; ++j)
      if (const int f = b.layout().force(knot, j); f >= 0) sum += b.at(f);
    b.expect(knot, b.layout().com(knot), sum / b.weight());
  }
}

void torque_balance(Bench& b) {
  const auto c = [&](int knot) { return b.at(b.layout().com_from_pose(knot)); };
  for (const int knot : {0, 2}) {
    const Vector3d x = b.at(b.layout().com(knot));
    const Vector3d before = knot > 0 ? c(knot - 1) : Bench::cycle_earlier(c(7));
    const Vector3d swept_before =
        b.at(knot > 0 ? b.layout().swept_momentum(knot - 1) : b.layout().wrapping_momentum());
    Vector3d sum = -(b.at(b.layout().swept_momentum(knot)) - swept_before -
                     b.mass() * x.cross(before - 2 * c(knot) + c(knot + 1))) /
                   (b.h() * b.h());
    for (int j = 0; j < 4; ++j) {
      const int f = b.layout().force(knot, j);
      if (f < 0) continue;
      const Vector3d ground =
          b.at(b.layout().foot(knot, j)) - b.robot().feet[j].radius * Vector3d::UnitZ();
      sum += (ground - x).cross(b.at(f));
    }
    b.expect(knot, b.layout().com(knot), sum / (b.weight() * b.leg()));
  }
}

void stance_foot(Bench& b) {
  const int i = Bench::first([&](int k) { return b.planted(k, 1) && b.planted(k + 1, 1); });
  const int here = b.layout().foot(i, 1), next = b.layout().foot(i + 1, 1);
  const Vector3d roll =
      b.robot().feet[1].radius * b.at(b.layout().foot_turn(i, 1)).cross(Vector3d::UnitZ());
  b.expect(i, next, (b.at(next) - b.at(here) - roll) / b.leg());
}

void friction_cone(Bench& b) {
  const int i = Bench::first([&](int k) { return b.layout().force(k, 1) >= 0; });
  const Vector3d f = b.at(b.layout().force(i, 1)) / b.weight();
  b.expect(i, b.layout().force(i, 1),
           0.4 * f.z() - std::sqrt(f.x() * f.x() + f.y() * f.y() + 1e-6));
}

void limb_clearance(Bench& b) {
  // Crossing a hand's breadth apart; an end beside an end. The clearance is 6 cm, the range a tenth
  // of the leg.
  const std::vector<int>& slots = b.term->elements()[0].slots;
  const auto put = [&](const Vector3d& from, const Vector3d& to) {
    const Vector3d places[] = {Vector3d::Zero(), {0.1, 0.0, 0.0}, from, to};
    for (int k = 0; k < 12; ++k) b.x[slots[k]] = places[k / 3][k % 3];
  };
  put({0.05, -0.05, 0.09}, {0.05, 0.05, 0.09});
  b.expect(0, slots[0], (0.09 - 0.06) / (0.1 * b.leg()));
  put({0.16, 0.0, 0.08}, {0.3, 0.2, 0.3});
  b.expect(0, slots[0], (0.10 - 0.06) / (0.1 * b.leg()));
}

void periodicity(Bench& b) {
  VectorXd pose = b.x.segment(b.layout().pose(8) + 2, 16) - b.x.segment(b.layout().pose(0) + 2, 16);
  pose[0] *= 0.21 / b.leg();  // the root's height
  pose[3] -= 0.24;            // its heading
  b.expect(8, b.layout().pose(8) + 2, pose);
  const Matrix3d turn = Bench::heading(0.4);
  const int foot = b.layout().foot(8, 2), force = b.layout().force(8, 0);
  ASSERT_GE(force, 0);
  b.expect(8, foot, (b.at(foot) - turn * b.at(b.layout().foot(0, 2)) - Bench::path(0.4)) / b.leg());
  b.expect(8, force, (b.at(force) - turn * b.at(b.layout().force(0, 0))) / b.weight());
}

void ground_height(Bench& b) {
  const int i = Bench::first([&](int k) { return b.planted(k, 1); });
  const int slot = b.layout().foot(i, 1) + 2;
  b.expect(i, slot, (b.x[slot] - b.robot().feet[1].radius) / b.leg());
}

void swing_height(Bench& b) {
  // Six of eight knots are planted: the two others are a third and two thirds on the way.
  const int i = Bench::first([&](int k) { return !b.planted(k, 1) && !b.planted(k + 1, 1); });
  const double height = 0.025 * std::pow(std::sin(std::numbers::pi / 3.0), 1.5);
  for (const int knot : {i, i + 1}) {
    const int slot = b.layout().foot(knot, 1) + 2;
    b.expect(knot, slot, (b.x[slot] - b.robot().feet[1].radius - height) / b.leg());
  }
}

void flat_foot(Bench& b) {
  const int i = Bench::first([&](int k) { return b.planted(k, 1) && b.planted(k + 1, 1); });
  const int ahead = b.layout().sole_direction(i, 1, 0), beside = b.layout().sole_direction(i, 1, 1);
  b.expect(i, ahead, Vector2d(b.x[ahead + 2], b.x[beside + 2]));
  const Vector3d next = b.at(b.layout().sole_direction(i + 1, 1, 0));
  b.expect(i, ahead, (next - b.at(ahead)).head<2>(), 1);
}

void least_normal_force(Bench& b) {
  const int i = Bench::first([&](int k) { return b.layout().force(k, 1) >= 0; });
  const int slot = b.layout().force(i, 1) + 2;
  b.expect(i, slot, b.x[slot] / b.weight() - 0.1);
}

void joint_limits(Bench& b) {
  const int slot = b.layout().pose(1) + 6 + 4;  // from −1.2 to 1.2 rad
  b.expect(1, slot, 1.0 + b.x[slot] / 1.2);
  b.expect(1, slot, 1.0 - b.x[slot] / 1.2, 1);
}

void torque_limits(Bench& b) {
  const int slot = b.layout().joint_torque(1, 0);  // 0.6 N m, a tenth of it in hand
  b.expect(1, slot, Vector2d((1.0 - b.x[slot] / 0.54) / 0.3, (1.0 + b.x[slot] / 0.54) / 0.3));
  // One gives 0.9 N m at rest, nothing at 6 rad/s, and a tenth of its torque is in hand, too.
  const int running = b.layout().joint_torque(1, 3), angle = 6 + 3;
  const double speed =
      (b.x[b.layout().pose(2) + angle] - b.x[b.layout().pose(0) + angle]) / (2.0 * b.h());
  const double used = b.x[running] / 0.81 + speed / 6.0;
  b.expect(1, running, Vector2d((1.0 - used) / 0.3, (1.0 + used) / 0.3), 1);
}

/// A, B, C of the first actuator: put where its length is a number.
int put_shape(Bench& b) {
  const int slot = b.layout().actuator_shape(0);
  b.x.segment<3>(slot) = Vector3d(0.08, 0.02, -0.03);
  return slot;
}

void stroke_limits(Bench& b) {
  const LinearActuator& piston = b.robot().linear_actuators[0];
  const int shape = put_shape(b);
  const double q = b.x[b.layout().pose(1) + 6 + piston.joint];
  const double length = b.leg() * std::sqrt(0.08 + 0.02 * std::cos(q) - 0.03 * std::sin(q));
  const double half = 0.5 * (piston.longest - piston.shortest);
  b.expect(1, shape, Vector2d(length - piston.shortest, piston.longest - length) / half);
}

void actuator_force(Bench& b) {
  const LinearActuator& piston = b.robot().linear_actuators[0];
  const int shape = put_shape(b);
  const auto arm = [](const Vector3d& abc, double q) {
    return 0.5 * (abc[2] * std::cos(q) - abc[1] * std::sin(q)) /
           std::sqrt(abc[0] + abc[1] * std::cos(q) + abc[2] * std::sin(q));
  };
  const double home = arm(actuator_shape(b.robot(), piston, b.setting.puppy.space.initial()).value,
                          b.robot().links[piston.joint + 1].joint.nominal);
  const double here = arm(b.at(shape), b.x[b.layout().pose(1) + 6 + piston.joint]) / home;
  const double torque = b.x[b.layout().joint_torque(1, piston.joint)] /
                        (0.9 * piston.force_limit * b.leg() * std::abs(home));
  b.expect(1, shape, Vector2d(here - torque, here + torque) / 0.3);
}

void force_size(Bench& b) {
  const int i = Bench::first([&](int k) { return b.layout().force(k, 1) >= 0; });
  b.expect(i, b.layout().force(i, 1), b.at(b.layout().force(i, 1)) / b.weight());
}

void force_smoothness(Bench& b) {
  const int i = Bench::first(
      [&](int k) { return b.layout().force(k, 1) >= 0 && b.layout().force(k + 1, 1) >= 0; });
  const int here = b.layout().force(i, 1), next = b.layout().force(i + 1, 1);
  b.expect(i, next, (b.at(next) - b.at(here)) / b.weight());
}

void design_tether(Bench& b) {
  const DesignSpace& space = b.setting.puppy.space;
  for (const int k : {0, space.find("body_width")}) {  // a length of two legs; of the trunk
    const DesignParameter& p = space.parameters[k];
    EXPECT_EQ(p.tied_count, k == 0 ? 2 : 1);
    b.expect(0, k, std::sqrt(p.tied_count) * (b.x[k] - p.initial) / p.initial);
  }
  // A hip's axis turns about z and then about x.
  const JointAxis& axis = b.robot().links[1].joint.axis;
  ASSERT_EQ(axis.turns.size(), 2U);
  Vector3d turned = axis.reference;
  for (std::size_t k = 2; k-- > 0;)
    turned = Eigen::AngleAxisd(b.x[axis.turns[k].parameter], axis.turns[k].about) * turned;
  b.expect(0, axis.turns[0].parameter, turned - axis.reference);
}

void mechanical_work(Bench& b) {
  const auto q = [&](int knot) { return b.x[b.layout().pose(knot) + 6 + 5]; };
  const int slot = b.layout().joint_torque(2, 5);
  const double work = b.x[slot] * 0.5 * (q(3) - q(1)) / (b.weight() * b.leg());
  b.expect(2, slot, 0.5 * (work + std::sqrt(work * work + 1e-8) - 1e-4));
}

void peak_torque(Bench& b) {
  const Layout& layout = b.layout();
  const double unit = b.weight() * b.leg();
  for (int k = 0; k < 8; ++k) b.x[layout.joint_torque(k, 4)] += unit;
  const auto torque = [&](int knot) { return b.x[layout.joint_torque(knot, 4)]; };
  const auto bend = [&](int knot) {
    const auto q = [&](int k) { return b.x[layout.pose((k + 8) % 8) + 6 + 4]; };
    return q(knot - 1) - 2.0 * q(knot) + q(knot + 1);
  };
  b.expect(2, layout.joint_torque(2, 4), std::pow(torque(2) / unit, 16));
  // Joint 4 is the knee of foot 1. kp 40, kd 0.6, 0.05 s a knot; of double gains.
  const int first = Bench::first(
      [&](int k) { return b.gait().in_contact(k, 1) && !b.gait().in_contact(k - 1, 1); });
  const int last = Bench::first(
      [&](int k) { return b.gait().in_contact(k, 1) && !b.gait().in_contact(k + 1, 1); });
  const double place = 0.75 * 0.75 * 0.75 / 6.0 * 80.0,
               rate = 0.75 * 0.75 / 0.1 * std::sqrt(2.0) * 0.6;
  const auto load = [&](int knot) { return b.x[layout.force(knot, 1) + 2] / b.weight(); };
  const auto held = [&](int knot, int free, double answer) {
    const int beside = (free + 8) % 8;
    b.expect(
        knot, layout.joint_torque(beside, 4),
        std::pow(
            (0.25 * torque(knot) + 0.75 * torque(beside) + answer * load(knot) * bend(free)) / unit,
            16));
  };
  held(last, last + 1, place + rate);
  held(first, first - 1, -rate);
}

void printed_volume(Bench& b) {
  const int slot = b.layout().printed_volume();
  b.expect(0, slot, b.x[slot]);
}

const std::map<std::string_view, ByHand>& table() {
  constexpr Penalty kHalfSquare = Penalty::quadratic, kBarrier = Penalty::barrier,
                    kNear = Penalty::near_only, kLinear = Penalty::linear;
  static const std::map<std::string_view, ByHand> table{
      {"travel", {kHalfSquare, travel}},
      {"turning", {kHalfSquare, turning}},
      {"style_com", {kHalfSquare, style_com}},
      {"style_foot", {kHalfSquare, style_foot}},
      {"style_foot_height", {kHalfSquare, style_foot_height}},
      {"style_joint", {kHalfSquare, style_joint}},
      {"trunk_orientation", {kHalfSquare, trunk_orientation}},
      {"nominal_pose", {kHalfSquare, nominal_pose}},
      {"smoothness", {kHalfSquare, smoothness}},
      {"com_position", {kHalfSquare, com_position}},
      {"foot_position", {kHalfSquare, foot_position}},
      {"force_balance", {kHalfSquare, force_balance}},
      {"torque_balance", {kHalfSquare, torque_balance}},
      {"stance_foot", {kHalfSquare, stance_foot}},
      {"friction_cone", {kBarrier, friction_cone}},
      {"limb_clearance", {kNear, limb_clearance}},
      {"periodicity", {kHalfSquare, periodicity}},
      {"ground_height", {kHalfSquare, ground_height}},
      {"swing_height", {kHalfSquare, swing_height}},
      {"flat_foot", {kHalfSquare, flat_foot}},
      {"least_normal_force", {kBarrier, least_normal_force}},
      {"joint_limits", {kBarrier, joint_limits}},
      {"torque_limits", {kNear, torque_limits}},
      {"stroke_limits", {kBarrier, stroke_limits}},
      {"actuator_force", {kNear, actuator_force}},
      {"force_size", {kHalfSquare, force_size}},
      {"force_smoothness", {kHalfSquare, force_smoothness}},
      {"design_tether", {kHalfSquare, design_tether}},
      {"mechanical_work", {kLinear, mechanical_work}},
      {"peak_torque", {kLinear, peak_torque}},
      {"printed_volume", {kLinear, printed_volume}},
  };
  return table;
}

class TermByHand : public testing::TestWithParam<std::string> {};

TEST_P(TermByHand, ResidualAndPenalty) {
  const auto entry = table().find(GetParam());
  ASSERT_NE(entry, table().end()) << "write down by hand what " << GetParam() << " is";
  for (const bool printed : {false, true}) {
    Bench bench(GetParam(), printed);
    EXPECT_EQ(bench.term->penalty(), entry->second.penalty);
    entry->second.check(bench);
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, TermByHand, testing::ValuesIn(test::registered_terms()),
                         [](const auto& instance) { return instance.param; });

TEST(TermsByHand, SwingHeightLeavesFeetWithHeightsOfTheirOwnAlone) {
  const Bench bench("swing_height", false);
  EXPECT_FALSE(bench.term->elements().empty());
  for (const Element& element : bench.term->elements()) EXPECT_NE(element.foot, 3);
}

TEST(TermsByHand, AreAllRegistered) {
  for (const auto& [name, by_hand] : table()) EXPECT_NE(find_term(name), nullptr) << name;
}

}  // namespace
}  // namespace legwright
