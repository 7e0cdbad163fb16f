// SPDX-License-Identifier: Apache-2.0
// The rows of the table of keys.
#include "tools/task/key_table.hpp"

#include <limits>
#include <utility>

namespace legwright {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr Range kNoRange{-kNoLimit, kNoLimit, false, false, ""};

constexpr Range kPhaseRange{0.0, 1.0, false, true, ""};
constexpr Range kShareRange{0.0, 1.0, true, false, ""};
constexpr Range kSpeedRange{-10.0, 10.0, false, false, "m/s"};
constexpr Range kTurnRateRange{-10.0, 10.0, false, false, "rad/s"};
constexpr Range kReachRange{-5.0, 5.0, false, false, "m"};
constexpr Range kHalfWidthRange{0.0, 5.0, false, false, "m"};
constexpr Range kHeightRange{0.0, 5.0, true, false, "m"};
constexpr Range kFootHeightRange{0.0, 5.0, false, false, "m"};
constexpr Range kAngleRange{-10.0, 10.0, false, false, "rad"};
constexpr Range kTargetWeightRange{0.0, 1e6, false, false, ""};
constexpr Range kFrictionRange{0.0, 5.0, true, false, ""};
constexpr Range kSlopeRange{-1.0, 1.0, false, false, "rad"};
constexpr Range kFrameRange{-10.0, 10.0, false, false, "m"};
constexpr Range kBoundRange{-100.0, 100.0, false, false, "m or rad"};
constexpr Range kWeightRange{0.0, kNoLimit, true, false, ""};
constexpr Range kTermWeightRange{0.0, kNoLimit, false, false, ""};

KeyForm one_number(const Range& range) { return {KeyKind::number, range}; }
KeyForm list_of_numbers(const Range& range, std::size_t count = 0) {
  return {KeyKind::numbers, range, count};
}
KeyForm list_of_pairs(const Range& range) { return {KeyKind::pairs, range}; }
KeyForm over_cycle(const Range& range) { return {KeyKind::target, range}; }
KeyForm one_text() { return {KeyKind::text, kNoRange}; }

TaskKey listed(std::string_view path, std::vector<KeyForm> forms, KeyScope scope,
               std::string_view fallback, std::string_view example, std::string_view meaning) {
  return {path, std::move(forms), scope, fallback, example, meaning};
}

std::vector<TaskKey> keys_of_the_file() {
  using enum KeyScope;
  return {
      listed("robot", {one_text()}, file, "needed", "\"robot.xml\"",
             "MJCF of the robot, found from the folder of the task file. `--robot FILE` takes "
             "another."),
      listed(
          "name", {one_text()}, both, "the file's name; needed in `[[task]]`", "\"sideways\"",
          "Names the run; in `[[task]]` a folder of it, by up to 60 letters, digits, `_` and `-`."),
      listed("weight", {one_number(kWeightRange)}, task, "one over the number of tasks", "0.5",
             "Of this task's F in the F of all, the weighted sum."),
      listed("dynamics", {one_text()}, shared, "`\"full\"`", "\"constant_inertia\"",
             "How the plan's torques are balanced: `\"full\"`, the angular momentum of all bodies "
             "as they move; `\"constant_inertia\"`, as in the paper's equation (13), the robot's "
             "inertia in its home pose."),
      listed("task", {{KeyKind::tables, kNoRange}}, file,
             "one task, whose tables stand in the file itself", "[{name = \"a\"}]",
             "`[[task]]`, once for each of several tasks for one body; its tables are "
             "`[task.gait]`, `[task.travel]` and so on."),
  };
}

std::vector<TaskKey> keys_of_gait() {
  using enum KeyScope;
  return {
      listed("gait.name", {one_text()}, task, "needed, unless `touchdown` is given", "\"walk\"",
             "A gait of the library for the robot's number of feet (`legwright gaits` draws them), "
             "or a name of your own for the pattern that `touchdown` and `duty` give."),
      listed("gait.period", {one_number({0.05, 20.0, false, false, "s"})}, task, "needed", "1.0",
             "One cycle."),
      listed("gait.knots", {{KeyKind::integer, {8, 384, false, false, ""}}}, task, "24", "32",
             "Points per cycle at which the motion is planned."),
      listed("gait.duty", {one_number(kShareRange), list_of_numbers(kShareRange)}, task,
             "the named gait's; needed with `touchdown`", "0.75",
             "Share of the cycle that a foot stands: one for all feet, or one for each, front to "
             "hind, left before right."),
      listed("gait.duty.FOOT", {one_number(kShareRange)}, task, "", "0.75",
             "The same, by the foot's name."),
      listed("gait.touchdown", {list_of_numbers(kPhaseRange)}, task, "the named gait's",
             "[0.0, 0.5, 0.75, 0.25]",
             "A pattern of your own: when in the cycle each foot touches down, front to hind, left "
             "before right."),
      listed("gait.touchdown.FOOT", {one_number(kPhaseRange)}, task, "", "0.5",
             "The same, by the foot's name."),
  };
}

std::vector<TaskKey> keys_of_travel() {
  using enum KeyScope;
  return {
      listed("travel.forward", {one_text()}, task, "\"+x\"", "\"+y\"",
             "Where the robot faces, along an axis of its trunk's frame: `+x`, `-x`, `+y` or `-y`. "
             "Velocity, front and hind, left and right are those of a robot that looks there; "
             "mirror images of the body stay those about the trunk's x-z plane."),
      listed("travel.velocity", {list_of_numbers(kSpeedRange, 2)}, task, "needed", "[0.0, 0.1]",
             "Forward and left, as the robot faces."),
      listed("travel.turn_rate", {one_number(kTurnRateRange)}, task, "0", "0.3",
             "Positive to the left."),
      listed("travel.aim_speed", {one_number({0.5, 2.0, false, false, ""})}, task, "1", "1.03",
             "The plan goes, and turns, so many times as fast as is wanted: makes up for what feet "
             "lose that slip in MuJoCo. Verdicts are about the wanted speed."),
      listed("travel.aim_turn_rate", {one_number(kTurnRateRange)}, task, "0", "-0.02",
             "The plan turns by so much more than is wanted: makes up for a drift in MuJoCo."),
  };
}

std::vector<TaskKey> keys_of_style() {
  using enum KeyScope;
  return {
      listed("style.com_height", {one_number(kHeightRange), list_of_numbers(kHeightRange)}, shared,
             "as in the home pose", "0.175",
             "Of the centre of mass above the ground; a list goes over the cycle, evenly spaced in "
             "time, straight in between. Weight: `style_com`."),
      listed("style.com_path", {list_of_pairs(kReachRange)}, shared,
             "none; on flat feet that of an inverted pendulum", "[[0.0, 0.01], [0.0, -0.01]]",
             "Centre of mass forward and left of the wanted path, over the cycle: a sway."),
      listed("style.footprint", {list_of_numbers(kHalfWidthRange, 2), list_of_pairs(kReachRange)},
             shared, "as in the home pose, and as much farther apart as the hips of the design are",
             "[0.12, 0.09]",
             "Where the feet stand around the centre of mass: half length and half width, or "
             "`[forward, left]` for each foot, front to hind, left before right. Weight: "
             "`style_foot`."),
      listed(
          "style.stance_width", {one_number({0.2, 5.0, false, false, ""})}, shared, "1", "1.15",
          "Multiplies how far the footprint's feet are from the line of travel; on the spot, from "
          "the line ahead."),
      listed("style.foot_targets.FOOT", {list_of_pairs(kReachRange)}, shared, "the footprint",
             "[[0.13, 0.09], [0.11, 0.09]]", "The same for one foot, over the cycle."),
      listed("style.foot_heights.FOOT", {over_cycle(kFootHeightRange)}, shared,
             "`limits.swing_height`", "[[0.8, 0.0], [0.87, 0.05], [0.95, 0.0]]",
             "Of a foot's sole over the ground while it swings. Weight: `style_foot_height`."),
      listed("style.foot_heights.FOOT.over_cycle", {over_cycle(kFootHeightRange)}, shared,
             "needed in a table", "[0.0, 0.05]", "The same, in a table that has a weight, too."),
      listed("style.foot_heights.FOOT.weight", {one_number(kTargetWeightRange)}, shared, "1", "0.5",
             "Multiplies `style_foot_height` for this foot."),
      listed("style.joint_angles.JOINT", {over_cycle(kAngleRange)}, shared, "none", "[-1.0, -0.8]",
             "Of a joint. Weight: `style_joint`."),
      listed("style.joint_angles.JOINT.over_cycle", {over_cycle(kAngleRange)}, shared,
             "needed in a table", "[-1.0, -0.8]", "The same, in a table that has a weight, too."),
      listed("style.joint_angles.JOINT.weight", {one_number(kTargetWeightRange)}, shared, "1",
             "0.5", "Multiplies `style_joint` for this joint."),
  };
}

std::vector<TaskKey> keys_of_limits() {
  using enum KeyScope;
  return {
      listed("limits.friction", {one_number(kFrictionRange)}, shared, "0.4", "0.3",
             "That the plan may use, well below the floor's."),
      listed("limits.floor_friction", {one_number(kFrictionRange)}, shared, "0.8", "0.9",
             "Of the floor it is played on."),
      listed("limits.min_normal", {one_number({0.0, 0.5, false, false, ""})}, shared, "0.05", "0.1",
             "Share of the weight that each stance foot carries at least."),
      listed(
          "limits.swing_height", {one_number({0.0, 1.0, false, false, "m"})}, shared,
          "0.12 leg lengths (less for legs that crouch), at most 0.06 g t² for a swing of t; 2.25 "
          "`step_over` if that is more",
          "0.025", "How high a foot is lifted."),
      listed("limits.step_over", {one_number({0.0, 0.7, true, false, "m"})}, shared, "none", "0.03",
             "Height of a bar across each step that every foot shall pass over; validation "
             "measures it."),
      listed(
          "limits.planted_margin", {one_number({0.0, 1.0, false, false, "s"})}, shared,
          "one knot; 0.24 √(leg / g), at most a sixth of the swing, for gaits of a duty up to 0.6",
          "0.04",
          "That a foot is on the ground before and after it carries load, at least one knot."),
      listed("limits.joint_margin", {one_number({0.0, 1.5, false, false, "rad"})}, shared, "0",
             "0.1", "Distance kept from joint limits."),
      listed("limits.torque_margin", {one_number({0.0, 1.0, false, true, ""})}, shared, "0.1",
             "0.2", "Share of each motor's torque limit kept in hand."),
      listed("limits.torque_limit", {one_number({0.0, 1e4, true, false, "N m"})}, shared,
             "each has its own", "1.5",
             "Of every motor that has more; linear actuators keep their force."),
      listed("limits.clearance", {one_number({0.0, 1.0, true, false, "m"})}, shared,
             "0.095 leg lengths", "0.02",
             "Between the centre lines of limbs (from the trunk: by its geoms)."),
      listed("limits.limb_pairs", {{KeyKind::name_pairs, kNoRange}}, shared, "all but neighbours",
             "[[\"FL_foot\", \"HL_thigh\"]]",
             "Limbs to keep apart, by link or foot; `[]` for none (from the trunk: always)."),
  };
}

std::vector<TaskKey> keys_of_surroundings() {
  using enum KeyScope;
  return {
      listed("ground.slope_along", {one_number(kSlopeRange)}, shared, "0", "0.1",
             "By which the ground rises on the way to go."),
      listed("ground.slope_across", {one_number(kSlopeRange)}, shared, "0", "0.05",
             "By which it rises to the left of the way."),
      listed("payload.mass", {one_number({0.0, 1e4, true, false, "kg"})}, shared,
             "none; needed with `position` or `size`", "0.5", "Of a box fixed to the trunk."),
      listed("payload.position", {list_of_numbers(kFrameRange, 3)}, shared, "its origin",
             "[0.0, 0.0, 0.06]", "Of the box's centre in the trunk's frame."),
      listed("payload.size", {list_of_numbers({0.0, 10.0, true, false, "m"}, 3)}, shared,
             "a cube as dense as water", "[0.1, 0.08, 0.06]", "Its edges."),
      listed("servos.kp", {one_number({0.0, 1e9, true, false, "N m/rad"})}, shared,
             "as the robot's file has them", "80.0",
             "With which servos are played that the robot's file has softer, none stiffer than one "
             "that gives all its torque at 0.0375 rad."),
      listed("servos.kd", {one_number({0.0, 1e9, false, false, "N m s/rad"})}, shared,
             "0.015 s · `kp`, less what a joint damps itself", "1.2",
             "Damps those that are damped less. Needs `kp`."),
  };
}

std::vector<TaskKey> keys_of_cost_and_design() {
  using enum KeyScope;
  return {
      listed(
          "weights.TERM", {one_number(kTermWeightRange)}, shared, "the term's own, below", "0.3",
          "Of a term of F, by name. `mechanical_work`, `peak_torque` and `printed_volume` have 0; "
          "with more they count in F, for body and motion."),
      listed("outer.objective", {one_text()}, file, "none", "\"mechanical_work\"",
             "Outer objective J = weight · v/v₀: the motion minimises F, the body F + J. "
             "`mechanical_work`: v is the positive work of a cycle, v₀ that of the first guess; "
             "`peak_torque`: v₀ is half the weight at the end of a level leg; `printed_volume`: v₀ "
             "is that of the given body."),
      listed("outer.weight", {one_number(kWeightRange)}, file, "1", "0.3",
             "Of J. Needs `objective`."),
      listed("design.freeze", {{KeyKind::names, kNoRange}}, file, "none",
             "[\"body_width\", \"front_*\"]",
             "These design parameters stay as they are: names, or patterns in which `*` stands for "
             "any letters, `?` for one and `[ab]` for one of these. A pattern that meets no "
             "parameter is an error."),
      listed("design.bounds.PARAMETER", {list_of_numbers(kBoundRange, 2)}, file, "the robot's",
             "[0.2, 0.3]", "Lower and upper, within the robot's and around its value."),
      listed("design.given.PARAMETER", {one_number(kBoundRange)}, file, "the robot's", "0.25",
             "What it was before somebody changed it: the Studio calls that given, where the robot "
             "is a body on the way. A search begins from the robot's value all the same."),
  };
}

}  // namespace

const std::vector<TaskKey>& task_keys() {
  static const std::vector<TaskKey> keys = [] {
    std::vector<TaskKey> all;
    for (const auto& part : {keys_of_the_file(), keys_of_gait(), keys_of_travel(), keys_of_style(),
                             keys_of_limits(), keys_of_surroundings(), keys_of_cost_and_design()})
      all.insert(all.end(), part.begin(), part.end());
    return all;
  }();
  return keys;
}

}  // namespace legwright
