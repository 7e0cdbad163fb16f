// SPDX-License-Identifier: Apache-2.0
#include "tools/task/starter_task.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "mjcf/propose/facing.hpp"
#include "mjcf/text/angle_words.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/nearest_word.hpp"
#include "optimizer/motion/faced_frame.hpp"
#include "optimizer/motion/gait.hpp"
#include "optimizer/motion/initial_guess.hpp"
#include "tools/task/damped_pace.hpp"
#include "tools/task/stuck_feet.hpp"
#include "tools/task/toml_reader.hpp"

namespace legwright {
namespace {

// Of √(g h): a Froude number of 0.02, at which feet need not hurry. Two feet balance at less. Trots
// of some robots limp at 0.2; three and four feet at a time carry a robot that does not tip, which
// follows plans at 0.35 as well as at 0.15.
constexpr double kSpeed = 0.15, kTwoFeetSpeed = 0.075, kTripodSpeed = 0.25;
// A cycle over √(h/g), by how long feet stand: nothing catches a robot on one pair of feet but its
// next step.
constexpr double kQuickCycle = 3.7, kTripodCycle = 5.0, kSlowCycle = 7.0;
constexpr double kSlowDuty = 0.65;
// Of the first limb stretched out: how far a foot goes back below its hip while it stands.
constexpr double kLongestStride = 0.8;
// Flat feet: slow and low, as their ankles have to hold what sways above them.
constexpr double kFlatFeetSpeed = 0.06, kFlatFeetCycle = 4.65;
constexpr double kFlatFeetSwing = 0.045;  // of h
constexpr int kFlatFeetKnots = 28;
// Pairs that land before the others lift forgive servos that are soft or stiff.
constexpr double kOverlap = 0.6;
// Of a swing, two of which the planted margin takes; and of a cycle, where the task does not say.
constexpr double kSwingKnots = 5.0, kUsualKnots = 24.0;

std::string two_digits(double value) { return fmt::format("{:.2g}", value); }

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
      continue;
    }
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

GaitPattern find_gait(int foot_count, const std::optional<std::string>& wanted) {
  const std::vector<GaitPattern> library = gait_library(foot_count);
  if (library.empty()) throw InputError(no_gait_text(foot_count));
  const std::string name = wanted.value_or(foot_count == 4 ? "trot" : library.front().name);
  std::vector<std::string> names;
  for (const GaitPattern& pattern : library) {
    if (pattern.name == name) return pattern;
    names.push_back(pattern.name);
  }
  const std::string guess = nearest(name, names);
  throw InputError(fmt::format(
      "gait '{}' is not in the library for {} feet; {}there are {}", name, foot_count,
      guess.empty() ? "" : fmt::format("did you mean '{}'? ", guess), fmt::join(names, ", ")));
}

double speed(int foot_count, double duty, bool flat) {
  if (flat) return kFlatFeetSpeed;
  if (foot_count >= 6 && duty < kSlowDuty) return kTripodSpeed;
  return foot_count == 2 ? kTwoFeetSpeed : kSpeed;
}

double cycle(int foot_count, double duty, bool flat) {
  if (flat) return kFlatFeetCycle;
  if (duty >= kSlowDuty) return kSlowCycle;
  return foot_count >= 6 ? kTripodCycle : kQuickCycle;
}

/// The section that plays servos stiffer than the file has them; empty where it need not.
std::string servos_text(const StarterTask& task) {
  const bool sags = task.sag.soft() && task.sag.can_be_stiffer();
  const double stiff = sags ? task.sag.stiff_kp() : 0.0;
  const TwoFeet& feet = task.two_feet;
  std::string why;
  if (sags)
    why = fmt::format(
        "the file's ({:.4g}) give in by {} when it only stands, too\n{:32}# much to follow "
        "a planned gait",
        task.sag.kp, rough_angle_text(task.sag.angle, task.in_degrees), "");
  const bool tips = feet.kind == TwoFeet::Kind::flat &&
                    (feet.kp < feet.upright_kp() || feet.kd < feet.upright_kd());
  if (tips && feet.upright_kp() > stiff)
    why = fmt::format(
        "gravity tips the robot over its ankles with {:.3g} N m/rad,\n{:32}# and its servos have "
        "{:.4g}",
        feet.toppling, "", feet.kp);
  if (why.empty()) return "";
  const double kp = tips ? std::max(stiff, feet.upright_kp()) : stiff;
  std::string out = fmt::format(
      "\n[servos]\nkp = {:26} # N m/rad, of those that are softer: {}; without this section they "
      "are played as they are\n",
      fmt::format("{}", kp), why);
  if (tips)
    out += fmt::format("kd = {:26} # N m s/rad at least: it rocks on flat feet with less\n",
                       fmt::format("{}", feet.upright_kd()));
  return out;
}

}  // namespace

StarterTask starter_task(const RobotModel& robot, const std::optional<std::string>& gait) {
  const int feet = robot.morphology.foot_count();
  const GaitPattern pattern = find_gait(feet, gait);
  double longest = 0.0;
  for (std::size_t place = 0; place < pattern.touchdown.size(); ++place)
    longest = std::max(longest, pattern.duty_of(place));
  const double height = home_stance(robot.morphology, robot.space.initial()).com_height;
  StarterTask task;
  task.in_degrees = robot.in_degrees;
  task.two_feet = two_feet(robot);
  const bool flat = task.two_feet.kind == TwoFeet::Kind::flat;
  if (flat) {
    task.swing_height = kFlatFeetSwing * height;
    task.knots = kFlatFeetKnots;
  }
  task.gait = pattern.name;
  task.period = cycle(feet, longest, flat) * std::sqrt(height / kGravity);
  task.speed = speed(feet, longest, flat) * std::sqrt(kGravity * height);
  // A trunk that is tall for its legs would have them run.
  task.speed = std::min(task.speed, kLongestStride * robot.morphology.leg_length /
                                        (std::max(longest, kOverlap) * task.period));
  const bool flies = support_range(pattern).least == 0;
  if (feet == 4 && !flies && longest < kOverlap) task.duty = kOverlap;
  if ((1.0 - longest) * kUsualKnots < kSwingKnots - 1e-9)
    task.knots = static_cast<int>(std::ceil(kSwingKnots / (1.0 - longest) - 1e-9));
  slow_down_for_damping(robot, std::max(longest, task.duty.value_or(0.0)), task);
  task.sag = servo_sag(robot);
  task.ahead = facing_of(robot).ahead;
  return task;
}

std::string no_gait_text(int foot_count) {
  if (!gait_library(foot_count).empty()) return "";
  std::string phases;  // one foot at a time
  for (int place = 0; place < foot_count; ++place)
    phases += fmt::format("{}{:.2g}", place ? ", " : "", static_cast<double>(place) / foot_count);
  return fmt::format(
      "the library has no gait for a robot of {0} {1}; declare one in a task file, for instance "
      "[gait] touchdown = [{2}] (when in the cycle each foot lands, front to hind, left before "
      "right), duty = {3:.2g} (share of the cycle that it stands), period = 1.0 (s)",
      foot_count, foot_count == 1 ? "foot" : "feet", phases,
      foot_count > 1 ? 1.0 - 0.5 / foot_count : 0.5);
}

std::string no_task_text(const RobotModel& robot) {
  std::string gait = no_gait_text(robot.morphology.foot_count());
  if (!gait.empty()) return gait;
  std::string why = stuck_foot_text(robot);
  if (why.empty()) why = two_feet(robot).why_it_falls();
  if (why.empty()) return "";
  return fmt::format("{}; --gait {} writes a task all the same", why,
                     gait_library(robot.morphology.foot_count()).front().name);
}

std::string starter_text(const StarterTask& task, const std::string& robot) {
  std::string out =
      "# A first task for this robot. SI units; every other key has a default: docs/task_file.md "
      "of\n"
      "# Legwright, or `legwright check --keys`, explains them all.\n"
      "robot = " +
      quoted(robot) + "\n\n[gait]\n" +
      fmt::format("name = {:24} # `legwright gaits` draws all that there are\n",
                  quoted(task.gait)) +
      fmt::format("period = {:22} # s, one cycle: {}\n", two_digits(task.period),
                  task.slowed ? "joints that damp much lift feet slowly"
                              : "in proportion to the root of the robot's height");
  if (task.knots)
    out += fmt::format(
        "knots = {:<23} # points per cycle: of the usual 24 too few are in a swing\n", *task.knots);
  if (task.duty)
    out += fmt::format(
        "duty = {:24} # share of the cycle that a foot stands: pairs land before the others lift\n",
        two_digits(*task.duty));
  out += "\n[travel]\n";
  if (task.ahead != Eigen::Vector2d::UnitX())
    out += fmt::format("forward = {:21} # axis of the trunk's frame along which the robot looks\n",
                       quoted(facing_text(task.ahead)));
  out += fmt::format(
      "velocity = [{}, 0.0]{:{}} # m/s forward, left: {}\n", two_digits(task.speed), "",
      std::max(0, 13 - static_cast<int>(two_digits(task.speed).size())),
      task.slowed ? "as slow as damping leaves joints" : "unhurried for a robot of this size");
  if (task.swing_height)
    out += fmt::format("\n[limits]\nswing_height = {:16} # m: {}\n", two_digits(*task.swing_height),
                       task.slowed ? "joints that damp much lift feet low" : "flat feet stay low");
  return out + servos_text(task);
}

}  // namespace legwright
