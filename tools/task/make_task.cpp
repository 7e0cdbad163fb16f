// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "mjcf/propose/beside_feet.hpp"
#include "mjcf/propose/home_touches.hpp"
#include "mjcf/propose/module_overlaps.hpp"
#include "mjcf/propose/odd_joints.hpp"
#include "mjcf/propose/trunk_axes.hpp"
#include "mjcf/propose/unlike_sides.hpp"
#include "mjcf/text/angle_words.hpp"
#include "mjcf/text/nearest_word.hpp"
#include "mjcf/text/refusals.hpp"
#include "optimizer/design/kinematics.hpp"
#include "optimizer/motion/faced_frame.hpp"
#include "optimizer/motion/initial_guess.hpp"
#include "optimizer/motion/margins.hpp"
#include "optimizer/motion/pendulum.hpp"
#include "optimizer/terms/registry.hpp"
#include "tools/task/damped_pace.hpp"
#include "tools/task/gait_table.hpp"
#include "tools/task/servo_sag.hpp"
#include "tools/task/stuck_feet.hpp"
#include "tools/task/style_table.hpp"
#include "tools/task/support_check.hpp"
#include "tools/task/task_file.hpp"
#include "tools/task/toml_reader.hpp"
#include "tools/task/two_feet.hpp"

namespace legwright {
namespace {

constexpr double kMostHeight = 1.5;  // com_height over the longest leg: the trunk has height
constexpr double kQuickDuty = 0.6;   // gaits up to this duty have no third foot to catch them
constexpr double kPlantedShareOfSwing = 1.0 / 6.0;  // planted before and after stance, at most

/// Knots of each foot strictly in the air, the smallest of them.
int fewest_airborne(const Gait& gait, int margin) {
  int fewest = gait.knot_count();
  for (int foot = 0; foot < gait.foot_count(); ++foot) {
    int airborne = 0;
    for (int knot = 0; knot < gait.knot_count(); ++knot)
      airborne += !gait.planted(knot, foot, margin);
    fewest = std::min(fewest, airborne);
  }
  return fewest;
}

int longest_stance(const Gait& gait) {
  int longest = 0;
  for (int foot = 0; foot < gait.foot_count(); ++foot) {
    int stance = 0;
    for (int knot = 0; knot < gait.knot_count(); ++knot) stance += gait.in_contact(knot, foot);
    longest = std::max(longest, stance);
  }
  return longest;
}

void check_weights(const TaskFile& file, Refusals& reasons) {
  std::vector<std::string> term_names;
  for (const TermEntry& entry : term_registry()) term_names.emplace_back(entry.name);
  for (const auto& [name, weight] : file.weights) {
    if (std::find(term_names.begin(), term_names.end(), name) != term_names.end()) continue;
    const std::string guess = nearest(name, term_names);
    reasons.add(file.refusal(
        "weights." + name,
        guess.empty()
            ? fmt::format("no term of that name; there are {}", fmt::join(term_names, ", "))
            : fmt::format("no term of that name; did you mean '{}'?", guess)));
  }
}

/// Every name in limits.limb_pairs is that of a link with a joint or of a foot.
void check_limb_pairs(const TaskFile& file, const Morphology& morphology, Refusals& reasons) {
  std::vector<std::string> names = foot_names(morphology);
  for (std::size_t l = 1; l < morphology.links.size(); ++l)
    names.push_back(morphology.links[l].name);
  if (!file.margins.limb_pairs) return;
  for (const auto& [first, second] : *file.margins.limb_pairs)
    for (const std::string& name : {first, second}) {
      if (std::find(names.begin(), names.end(), name) != names.end()) continue;
      const std::string guess = nearest(name, names);
      reasons.add(
          file.refusal("limits.limb_pairs",
                       fmt::format("no link or foot is named '{}'; {}there are {}", name,
                                   guess.empty() ? "" : fmt::format("did you mean '{}'? ", guess),
                                   fmt::join(names, ", "))));
    }
}

/// A way that turns has no slope.
void check_ground(const TaskFile& file, Refusals& reasons) {
  const bool slope = file.slope_along != 0.0 || file.slope_across != 0.0;
  for (const auto& [key, rate] :
       {std::pair("turn_rate", file.turn_rate), std::pair("aim_turn_rate", file.aim_turn_rate)})
    if (slope && rate != 0.0)
      reasons.add(file.refusal(
          fmt::format("travel.{}", key),
          fmt::format("is {} rad/s on a slope: a robot that turns meets it from another side each "
                      "cycle, so its gait does not repeat; take out [ground] or {}",
                      rate, key)));
}

/// Steps over a height need feet that are lifted higher.
void check_foot_heights(const TaskFile& file, const Task& task, const Morphology& morphology,
                        Refusals& reasons) {
  for (int j = 0; j < morphology.foot_count(); ++j)
    if (target_of(task.foot_heights, j) != nullptr && highest_swing(task, j) < task.step_over)
      reasons.add(file.refusal(
          "style.foot_heights." + morphology.feet[j].name,
          fmt::format(
              "lifts the foot by {:.3g} m at most while it swings; limits.step_over asks for "
              "steps over {} m. Raise the heights, or lower step_over",
              highest_swing(task, j), task.step_over)));
}

/// Heights over the cycle of which little falls into the swing, by mistake or not.
void warn_of_low_feet(const Task& task, const Morphology& morphology,
                      std::vector<std::string>& warnings) {
  for (int j = 0; j < morphology.foot_count(); ++j) {
    if (target_of(task.foot_heights, j) == nullptr) continue;
    const double most = highest_swing(task, j), usual = task.swing_height.value_or(0.0);
    if (most < 0.5 * usual)
      warnings.push_back(fmt::format(
          "style.foot_heights.{} lifts the foot by {:.2g} mm at most while it swings, which may "
          "drag "
          "it; without it the swing height is {:.2g} mm (`legwright check` draws when a "
          "foot swings)",
          morphology.feet[j].name, 1e3 * most, 1e3 * usual));
  }
}

/// Moves the feet's places towards the line of travel or away from it; on the spot, the line ahead.
void scale_width(const RobotModel& robot, const TaskFile& file, Task& task) {
  const Eigen::Vector2d ahead = task.velocity.norm() > 0.0
                                    ? Eigen::Vector2d(task.velocity.normalized())
                                    : from_facing(Eigen::Vector2d::UnitX(), file.forward);
  task.follow_hips = task.follow_hips.value_or(!task.footprint);
  task.footprint = style_targets(robot.morphology, robot.space.initial(), task).footprint;
  for (Eigen::Vector2d& foot : *task.footprint) {
    const Eigen::Vector2d along = ahead * ahead.dot(foot);
    foot = along + file.stance_width * (foot - along);
  }
}

void check_reach(const TaskFile& file, const Task& task, const RobotModel& robot,
                 Refusals& reasons) {
  const auto refuse = [&](const std::string& key, const std::string& why) {
    reasons.add(file.refusal(key, why));
  };
  const StrideBound bound = stride_bound(task, robot);
  if (bound.per_stance > bound.longest)
    refuse("travel.velocity",
           fmt::format("out of reach: the body travels {:.3g} m while a foot stands, the longest "
                       "stride of this robot "
                       "is {:.3g} m (twice its longest leg at the bounds); slow down by a factor "
                       "of {:.2g}, or shorten "
                       "gait.period or the duty",
                       bound.per_stance, bound.longest, bound.per_stance / bound.longest));
  const double highest = 0.5 * bound.longest;
  const std::optional<double> com_height = highest_com(task);
  if (com_height && *com_height > kMostHeight * highest)
    refuse("style.com_height",
           fmt::format("is {} m; at most {:.3g} m is accepted, {} times the longest leg that the "
                       "bounds allow, {:.3g} m; lower it",
                       *com_height, kMostHeight * highest, kMostHeight, highest));
  const int airborne = fewest_airborne(task.gait, task.planted_margin);
  const bool moves = task.velocity.norm() > 0.0 || task.turn_rate != 0.0;
  if (moves && airborne == 0)
    refuse("gait.knots",
           fmt::format("no knot is left for the swing: {} knots of {:.3g} s, of which {} stay "
                       "planted before and after "
                       "stance; use more knots, a lower duty or a shorter limits.planted_margin",
                       task.gait.knot_count(), task.gait.time_step(), task.planted_margin));
  const int support = support_range(task.gait).most;
  if (task.min_normal * support >= 1.0)
    refuse("limits.min_normal",
           fmt::format("is {}; {} feet stand at once, so it must be below {:.3g} of the weight",
                       task.min_normal, support, 1.0 / support));
}

}  // namespace

int planted_margin_knots(std::optional<double> seconds, double duty, double period,
                         double time_step, double leg_length) {
  const double quick =
      std::min(touchdown_error(leg_length), kPlantedShareOfSwing * (1.0 - duty) * period);
  const double wanted = seconds.value_or(duty <= kQuickDuty + 1e-9 ? quick : time_step);
  return std::max(1, static_cast<int>(std::lround(wanted / time_step)));
}

std::vector<Eigen::Vector3d> home_feet(const Morphology& morphology, const Eigen::VectorXd& s) {
  const GeometryAtDesign geometry(morphology, s);
  const PoseKinematics home = home_pose(morphology, geometry);
  std::vector<Eigen::Vector3d> feet;
  feet.reserve(static_cast<std::size_t>(morphology.foot_count()));
  for (int foot = 0; foot < morphology.foot_count(); ++foot)
    feet.push_back(foot_place(morphology, geometry, home, foot));
  return feet;
}

std::vector<std::string> foot_names(const Morphology& morphology) {
  std::vector<std::string> names;
  for (const Foot& foot : morphology.feet) names.push_back(foot.name);
  return names;
}

StrideBound stride_bound(const Task& task, const RobotModel& robot) {
  StrideBound bound;
  const Eigen::VectorXd initial = robot.space.initial(), upper = robot.space.upper();
  double turn_radius = 0.0;
  for (const Eigen::Vector3d& foot : home_feet(robot.morphology, initial))
    turn_radius = std::max(turn_radius, foot.head<2>().norm());
  for (int foot = 0; foot < robot.morphology.foot_count(); ++foot) {
    bound.longest = std::max(bound.longest, 2.0 * stretched_limb(robot.morphology, foot, upper));
    bound.leg_length = std::max(bound.leg_length, stretched_limb(robot.morphology, foot, initial));
  }
  const double speed = task.velocity.norm() + std::abs(task.turn_rate) * turn_radius;
  bound.per_cycle = speed * task.gait.period();
  bound.per_stance = bound.per_cycle * longest_stance(task.gait) / task.gait.knot_count();
  return bound;
}

std::vector<std::string> task_warnings(const Task& task, const RobotModel& robot) {
  std::vector<std::string> warnings;
  const StrideBound bound = stride_bound(task, robot);
  if (bound.per_stance > 0.4 * bound.longest)
    warnings.push_back(fmt::format(
        "long strides: {:.3g} m while a foot stands, with legs that the bounds let reach over "
        "{:.3g} m at most; a shorter period is easier",
        bound.per_stance, bound.longest));
  if (task.velocity.norm() == 0.0 && task.turn_rate == 0.0)
    warnings.push_back("the wanted velocity is zero: the robot will step on the spot");
  if (const auto com_height = highest_com(task); com_height && *com_height > bound.leg_length)
    warnings.push_back(
        fmt::format("com_height {} m is above the stretched legs of the initial design, {:.3g} m",
                    *com_height, bound.leg_length));
  warn_of_low_feet(task, robot.morphology, warnings);
  if (task.friction > 0.75 * task.floor_friction)
    warnings.push_back(
        fmt::format("little friction is kept in hand: the plan uses {} of a floor of {}",
                    task.friction, task.floor_friction));
  if (fewest_airborne(task.gait, task.planted_margin) < 3 && bound.per_cycle > 0.0)
    warnings.push_back("a swing has fewer than three knots: use more knots for a smooth step");
  if (support_range(task.gait).least == 0)
    warnings.push_back(
        "at times no foot is on the ground: nothing steers the robot while it plays such a gait, "
        "and "
        "most fall; raise gait.duty for steadier ones");
  if (std::string why = unsupported_stance(task, robot); !why.empty())
    warnings.push_back(std::move(why));
  if (const auto axes = find_trunk_axes(robot.xml, robot.file))
    warnings.push_back(axes->why +
                       (axes->upright ? "; ahead, left and right are along its axes"
                                      : "; plans and verdicts take z for up") +
                       ": `legwright init " + robot.file.filename().string() +
                       " --write` turns the frame where that file holds the trunk");
  for (std::string& odd : odd_joints(robot)) warnings.push_back(std::move(odd));
  for (std::string& unlike : unlike_sides(robot)) warnings.push_back(std::move(unlike));
  if (std::string why = unlimited_torques(robot); !why.empty() && !task.torque_limit)
    warnings.push_back(why + ", or torque_limit in the task's [limits]");
  if (std::string why = overdamped_joints(robot, task.torque_limit, asked_joint_speed(robot, task));
      !why.empty())
    warnings.push_back(std::move(why));
  for (std::string& overlap : overlapping_modules(robot)) warnings.push_back(std::move(overlap));
  for (std::string& overlap : overlapping_links(robot)) warnings.push_back(std::move(overlap));
  for (std::string& beside : beside_feet(robot)) warnings.push_back(std::move(beside));
  const ServoSag sag = servo_sag(robot, task);
  if (std::string why = weak_motors_text(sag.hardest); !why.empty())
    warnings.push_back(std::move(why));
  else if (sag.soft() && sag.can_be_stiffer())
    warnings.push_back(fmt::format(
        "soft servos: standing alone bends joint '{}' by {} (kp {:.4g} N m/rad), and a "
        "planned gait is not followed well; [servos] kp = {} in the task file plays it "
        "stiffer",
        sag.joint, rough_angle_text(sag.angle, robot.in_degrees), sag.kp, sag.stiff_kp()));
  else if (sag.soft())
    warnings.push_back(fmt::format(
        "weak motors: standing alone takes {:.2g} N m of joint '{}', {:.0f} % of the "
        "{:.3g} N m that its motor gives, and bends it by {} (kp {:.4g} N m/rad); a stronger "
        "motor, shorter legs or less weight would help",
        sag.load, sag.joint, 100.0 * sag.load / sag.limit, sag.limit,
        rough_angle_text(sag.angle, robot.in_degrees), sag.kp));
  if (std::string stuck = stuck_foot_text(robot); !stuck.empty())
    warnings.push_back(std::move(stuck));
  if (const TwoFeet feet = two_feet(robot, task); !feet.why_it_falls().empty())
    warnings.push_back(feet.why_it_falls());
  else if (feet.soft())
    warnings.push_back(fmt::format(
        "soft ankles: gravity tips the robot over its feet with {:.3g} N m/rad, and the softest "
        "servo of its ankles has {:.4g}; [servos] kp = {} in the task file plays it stiffer",
        feet.toppling, feet.kp, feet.upright_kp()));
  else if (feet.is_underdamped())
    warnings.push_back(fmt::format(
        "little damping: on flat feet a robot rocks over its ankles, the longer the more; [servos] "
        "kd = {} in the task file damps servos that have less",
        feet.upright_kd()));
  if (robot.space.size() == 0)
    warnings.push_back(
        "the robot declares no design parameters: only its motion will be optimized");
  return warnings;
}

Task make_task(const TaskFile& file, const RobotModel& robot) {
  const std::vector<int> order =
      order_as_faced(home_feet(robot.morphology, robot.space.initial()), file.forward);
  const std::vector<std::string> names = foot_names(robot.morphology);
  Refusals reasons;
  check_weights(file, reasons);
  check_limb_pairs(file, robot.morphology, reasons);
  check_ground(file, reasons);
  Task task = file.margins;
  task.name = file.name;
  reasons.collect([&] { task.gait = make_gait(file, names, order); });
  reasons.collect([&] { apply_style(file, robot, order, task); });
  reasons.throw_if_any();
  task.velocity = from_facing(file.aim_speed * file.velocity, file.forward);
  task.turn_rate = file.aim_speed * file.turn_rate + file.aim_turn_rate;
  task.up = up_on_slope(task.velocity, file.slope_along, file.slope_across);
  const double leg = standing_leg(robot.morphology, robot.space.initial());
  // By the pattern's duty: rounded to knots, a pace of 0.6 at 24 knots would count as a slow gait.
  task.planted_margin = planted_margin_knots(file.planted_margin, longest_duty(file, names, order),
                                             file.period, task.gait.time_step(), leg);
  task.swing_height = swing_height(task, leg);
  task.clearance = limb_clearance(task, robot.morphology.leg_length);
  task.weights = file.weights;
  if (task.com_path.empty() && stands_on_soles(robot.morphology)) {
    const StyleTargets style = style_targets(robot.morphology, robot.space.initial(), task);
    task.com_path = pendulum_path(task, style.footprint, style.com_height);
  }
  if (file.stance_width != 1.0) scale_width(robot, file, task);
  check_foot_heights(file, task, robot.morphology, reasons);
  check_reach(file, task, robot, reasons);
  reasons.throw_if_any();
  return task;
}

}  // namespace legwright
