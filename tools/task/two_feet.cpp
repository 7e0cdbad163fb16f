// SPDX-License-Identifier: Apache-2.0
#include "tools/task/two_feet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mjcf/scene/surroundings.hpp"
#include "optimizer/motion/initial_guess.hpp"
#include "tools/task/servo_sag.hpp"

namespace legwright {
namespace {

constexpr double kRolyPoly =
    1.0;  // radius of round soles over the leg: there a robot rights itself
// Of M g h: at half gains no less than 1 holds. Robots of 31 and 33 kg walked at half of 2.2 and
// fell at half of 1.1.
constexpr double kUpright = 8.0, kLeast = 2.15;
// Of M g h √(h/g), the damping that the robot's own swing over its ankles is critical with. At a
// third of it, and gains at which that swing takes as long as a cycle, robots rocked till they
// fell; at two thirds they kept 90 to 98 % of their speed; at 4/3 none rocked.
constexpr double kDamping = 4.0 / 3.0, kLeastDamping = 0.9;
constexpr std::size_t kAnkleHinges = 2;  // next to the foot: one pitches, one rolls

std::string torque_words(double value) {
  return value < 100.0 ? fmt::format("{:.3g}", value) : fmt::format("{:.0f}", value);
}

}  // namespace

double TwoFeet::upright_kp() const { return two_digits_up(kUpright * toppling); }

double TwoFeet::upright_kd() const {
  return two_digits_up(kDamping * toppling * std::sqrt(height / kGravity));
}

bool TwoFeet::is_underdamped() const {
  return kind == Kind::flat && kd < kLeastDamping * toppling * std::sqrt(height / kGravity);
}

bool TwoFeet::soft() const { return kind == Kind::flat && kp < kLeast * toppling; }

bool TwoFeet::can_be_stiffer() const { return limit / kFullTorqueError >= kLeast * toppling; }

std::string TwoFeet::why_it_falls() const {
  if (kind == Kind::neither)
    return "two small feet: nothing balances a robot while a plan is played but round soles as "
           "large as its legs, on which it rights itself, or flat feet, level in the home pose, "
           "on ankles that both pitch and roll, which keep them so";
  if (soft() && !can_be_stiffer())
    return fmt::format(
        "weak ankles: to hold this robot over its feet (M g h = {} N m/rad), at half its gains "
        "too, "
        "takes motors of {} N m there, and joint '{}' has {}; a stronger one, or a lower or "
        "lighter body, would do",
        torque_words(toppling), torque_words(kLeast * toppling * kFullTorqueError), ankle,
        torque_words(limit));
  return "";
}

TwoFeet two_feet(const RobotModel& robot) {
  const Morphology& body = robot.morphology;
  TwoFeet out;
  if (body.foot_count() != 2) return out;
  const double radius = std::min(body.feet[0].radius, body.feet[1].radius);
  out.kind = stands_on_soles(body)                   ? TwoFeet::Kind::flat
             : radius >= kRolyPoly * body.leg_length ? TwoFeet::Kind::round
                                                     : TwoFeet::Kind::neither;
  out.height = home_stance(body, robot.space.initial()).com_height;
  out.toppling = body.total_mass() * kGravity * out.height;
  out.kp = out.kd = out.limit = std::numeric_limits<double>::infinity();
  for (const Foot& foot : body.feet) {
    const std::vector<int> chain = body.chain_to(foot.link);
    const std::size_t from = chain.size() - std::min(chain.size(), kAnkleHinges);
    for (std::size_t k = from; k < chain.size(); ++k) {
      const Servo& servo = robot.servos[static_cast<std::size_t>(chain[k] - 1)];
      if (!servo.tendon.empty()) continue;  // an actuator's gain is along it
      out.kp = std::min(out.kp, servo.kp);
      out.kd = std::min(out.kd, servo.kd);
      if (!out.ankle.empty() && servo.torque_limit >= out.limit) continue;
      out.ankle = servo.joint;
      out.limit = servo.torque_limit;
    }
  }
  return out;
}

TwoFeet two_feet(const RobotModel& robot, const Task& task) {
  return two_feet(as_played(robot, task));
}

}  // namespace legwright
