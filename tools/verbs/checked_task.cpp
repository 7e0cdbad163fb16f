// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/checked_task.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "mjcf/read/foot_words.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/text/angle_words.hpp"
#include "optimizer/motion/faced_frame.hpp"
#include "optimizer/terms/registry.hpp"
#include "tools/task/servo_sag.hpp"
#include "tools/verbs/init_text.hpp"
#include "tools/verbs/summary.hpp"

namespace legwright {
namespace {

std::string outer_of(const CodesignProblem& problem, int task) {
  if (problem.outers.empty()) return "";
  const OuterObjective& outer = *problem.outers[static_cast<std::size_t>(task)];
  return fmt::format("outer   J = {} x {} / {:.4g} {}; the motion minimises F, the body F + J\n",
                     outer.weight(), problem.set.outer, outer.reference(), outer.unit());
}

std::vector<std::string> limb_of(const Morphology& morphology, const Foot& foot) {
  std::vector<std::string> names;
  for (int link : morphology.chain_to(foot.link))
    names.push_back(morphology.links[link].joint.name);
  return names;
}

std::string robot_text(const CheckedTask& found) {
  const Morphology& morphology = found.robot.morphology;
  std::string text =
      fmt::format("robot   {} ({}): {:.3g} kg, trunk '{}', {} motors, {} feet\n", morphology.name,
                  found.robot.file.string(), morphology.total_mass(), found.robot.root_body,
                  morphology.joint_count(), morphology.foot_count());
  const Eigen::VectorXd s = found.robot.space.initial();
  const std::vector<Eigen::Vector3d> feet = home_feet(morphology, s);
  for (int j : order_as_faced(feet, found.file.forward)) {
    const Foot& foot = morphology.feet[j];
    text += fmt::format("  limb  {}: {} -> {}; {:.4g} m stretched; stands at {:.3f}, {:.3f} m\n",
                        foot.name, fmt::join(limb_of(morphology, foot), " -> "),
                        touching_part(found.robot, j), stretched_limb(morphology, j, s),
                        feet[j].x(), feet[j].y());
  }
  return text + held_text(found.robot.structure) + file_notes(found.robot);
}

std::string design_text(const CheckedTask& found) {
  std::string text = fmt::format("design  s has {} parameters\n", found.robot.space.size());
  std::size_t width = 0;
  for (const DesignParameter& p : found.robot.space.parameters)
    width = std::max(width, p.name.size());
  for (const DesignParameter& p : found.robot.space.parameters)
    text += fmt::format("  {:{}}  {:>7.4g}  in [{:.4g}, {:.4g}] {:3}  moves {}  {}{}\n", p.name,
                        width, p.initial, p.lower, p.upper, p.unit, p.tied_count,
                        p.frozen() ? "(frozen) " : "", p.sentence);
  return text;
}

std::string gait_text(const CheckedTask& found) {
  const Gait& gait = found.task.gait;
  std::string text = fmt::format(
      "gait    {}: period {} s, {} knots of {:.4g} ms, feet planted {} knot{} before and after "
      "stance\n",
      gait.name(), gait.period(), gait.knot_count(), 1e3 * gait.time_step(),
      found.task.planted_margin, found.task.planted_margin == 1 ? "" : "s");
  const Morphology& morphology = found.robot.morphology;
  std::istringstream diagram(footfall_diagram(gait, foot_names(morphology)));
  std::vector<std::string> rows;
  for (std::string row; std::getline(diagram, row);) rows.push_back(row);
  for (const int j :
       order_as_faced(home_feet(morphology, found.robot.space.initial()), found.file.forward))
    text += "  " + rows[static_cast<std::size_t>(j)] + "\n";
  const SupportRange support = support_range(gait);
  return text + fmt::format("  # stance, . swing; one column per knot; {} to {} feet stand\n",
                            support.least, support.most);
}

/// Lists over the cycle; nothing where the task has none.
std::string style_text(const CheckedTask& found) {
  const Task& task = found.task;
  std::string text;
  const auto add = [&](const std::string& what, std::size_t count) {
    text +=
        fmt::format("style   {}: {} value{} over the cycle, one every {:.4g} s{}\n", what, count,
                    count == 1 ? "" : "s", task.gait.period() / static_cast<double>(count),
                    static_cast<int>(count) == task.gait.knot_count()
                        ? ", one per knot"
                        : fmt::format(", read at the {} knots", task.gait.knot_count()));
  };
  if (!task.com_heights.empty()) add("com_height", task.com_heights.size());
  if (!task.com_path.empty()) add("com_path, off the wanted path", task.com_path.size());
  for (std::size_t j = 0; j < task.foot_targets.size(); ++j)
    if (!task.foot_targets[j].empty())
      add("foot_targets." + found.robot.morphology.feet[j].name, task.foot_targets[j].size());
  const auto add_target = [&](const std::string& what, const CycleTarget* target,
                              std::string_view unit) {
    if (target == nullptr) return;
    const auto [low, high] = std::minmax_element(target->values.begin(), target->values.end());
    text += fmt::format("style   {}: {} to {} {} over the cycle, weight {}\n", what, *low, *high,
                        unit, target->weight);
  };
  const Morphology& morphology = found.robot.morphology;
  for (int j = 0; j < morphology.foot_count(); ++j)
    add_target("foot_heights." + morphology.feet[j].name, target_of(task.foot_heights, j), "m");
  for (int a = 0; a < morphology.joint_count(); ++a)
    add_target("joint_angles." + morphology.links[a + 1].joint.name,
               target_of(task.joint_angles, a), "rad");
  return text;
}

std::string travel_text(const CheckedTask& found) {
  const Eigen::Vector2d& velocity = found.file.velocity;
  std::string text = fmt::format(
      "travel  {} m/s forward, {} m/s left, {} rad/s: {:.4g} m per cycle, {:.4g} m while a foot "
      "stands (more than {:.4g} m, "
      "twice the longest leg that the bounds allow, is refused)\n",
      velocity.x(), velocity.y(), found.file.turn_rate, found.stride.per_cycle,
      found.stride.per_stance, found.stride.longest);
  if (found.file.aim_speed != 1.0 || found.file.aim_turn_rate != 0.0)
    text += fmt::format("        planned {:.4g} times as fast, turning by {:.3g} rad/s more\n",
                        found.file.aim_speed, found.file.aim_turn_rate);
  return text;
}

/// What the task adds to robot and ground; nothing where it adds nothing.
std::string demands_text(const CheckedTask& found) {
  const Task& task = found.task;
  std::string text;
  if (const SlopeAngles slope = slope_of(task.velocity, task.up);
      slope.along != 0.0 || slope.across != 0.0)
    text += fmt::format("ground  rises by {:.3g} rad on the way, by {:.3g} rad to its left\n",
                        slope.along, slope.across);
  if (task.payload)
    text += fmt::format(
        "payload {} kg at {:.3g}, {:.3g}, {:.3g} m of the trunk, {:.0f} % of the "
        "robot's own mass\n",
        task.payload->mass, task.payload->position.x(), task.payload->position.y(),
        task.payload->position.z(),
        100.0 * task.payload->mass / found.robot.morphology.total_mass());
  if (task.dynamics == Dynamics::constant_inertia)
    text +=
        "model   the plan's torque balance has constant inertia, as the paper's equation (13)\n";
  if (task.torque_limit)
    text += fmt::format("motors  no more than {} N m each\n", *task.torque_limit);
  const ServoSag sag = servo_sag(found.robot, task);
  if (!sag.hardest.holds())
    text +=
        fmt::format("servos  standing takes {:.2g} N m of joint '{}', whose motor gives {:.3g}\n",
                    sag.hardest.load, sag.hardest.joint, sag.hardest.limit);
  else if (!sag.joint.empty())
    text += fmt::format(
        "servos  {}standing bends joint '{}' the most, by {} at kp {:.4g} N m/rad\n",
        task.servo_kp ? fmt::format("kp at least {} N m/rad for this task; ", *task.servo_kp) : "",
        sag.joint, rough_angle_text(sag.angle, found.robot.in_degrees), sag.kp);
  if (task.step_over > 0.0)
    text += fmt::format("step    over {:.3g} mm; swings are planned {:.3g} mm high\n",
                        1e3 * task.step_over, 1e3 * task.swing_height.value_or(0.0));
  return text;
}

/// The weights that the task changes; all of them are in the JSON document.
std::string weights_text(const CheckedTask& found) {
  std::string text = "cost    every term of F at its default weight";
  text += found.task.weights.empty() ? " (--json lists them)\n" : " but these of the task file:\n";
  for (const TermEntry& entry : term_registry()) {
    const auto own = found.task.weights.find(std::string(entry.name));
    if (own != found.task.weights.end())
      text += fmt::format("  {:20} {:5} {}  (else {})\n", entry.name, entry.equation, own->second,
                          entry.default_weight);
  }
  return text;
}

Json json_of(const CheckedTask& found) {
  const Morphology& morphology = found.robot.morphology;
  Json limbs = Json::array(), parameters = Json::array(), weights = Json::object(),
       contact = Json::object();
  const Eigen::VectorXd s = found.robot.space.initial();
  for (int j = 0; j < morphology.foot_count(); ++j) {
    const Foot& foot = morphology.feet[j];
    limbs.push_back({{"foot", foot.name},
                     {"joints", limb_of(morphology, foot)},
                     {"radius_m", foot.radius},
                     {"stretched_m", stretched_limb(morphology, j, s)}});
    std::string row;
    for (int i = 0; i < found.task.gait.knot_count(); ++i)
      row += found.task.gait.in_contact(i, j) ? '#' : '.';
    contact[foot.name] = row;
  }
  for (const DesignParameter& p : found.robot.space.parameters)
    parameters.push_back({{"name", p.name},
                          {"unit", p.unit},
                          {"initial", p.initial},
                          {"lower", p.lower},
                          {"upper", p.upper},
                          {"tied_count", p.tied_count},
                          {"sentence", p.sentence}});
  for (const TermEntry& entry : term_registry())
    weights[std::string(entry.name)] = entry.default_weight;
  for (const auto& [name, weight] : found.task.weights) weights[name] = weight;
  const Eigen::Vector2d wanted = from_facing(found.file.velocity, found.file.forward);
  return {{"schema", "legwright/check"},
          {"version", 1},
          {"robot",
           {{"name", morphology.name},
            {"file", found.robot.file.string()},
            {"mass_kg", morphology.total_mass()},
            {"trunk", found.robot.root_body},
            {"joints", morphology.joint_count()},
            {"limbs", limbs}}},
          {"parameters", parameters},
          {"gait",
           {{"name", found.task.gait.name()},
            {"period_s", found.task.gait.period()},
            {"knots", found.task.gait.knot_count()},
            {"planted_margin_knots", found.task.planted_margin},
            {"contact", contact},
            {"support_least", support_range(found.task.gait).least},
            {"support_most", support_range(found.task.gait).most}}},
          {"travel",
           {{"velocity", {wanted.x(), wanted.y()}},
            {"turn_rate", found.file.turn_rate},
            {"aim_speed", found.file.aim_speed},
            {"aim_turn_rate", found.file.aim_turn_rate},
            {"per_cycle_m", found.stride.per_cycle},
            {"per_stance_m", found.stride.per_stance},
            {"longest_stride_m", found.stride.longest}}},
          {"weights", weights},
          {"warnings", found.warnings}};
}

}  // namespace

std::vector<CheckedTask> checked_tasks(const CodesignProblem& problem) {
  std::vector<CheckedTask> all;
  for (int k = 0; k < problem.task_count(); ++k) {
    CheckedTask found{problem.task(k),     problem.robot, problem.objectives[k]->task(), {}, {},
                      outer_of(problem, k)};
    found.stride = stride_bound(found.task, found.robot);
    found.warnings = warnings_on(problem, k);
    all.push_back(std::move(found));
  }
  return all;
}

std::string to_text(const std::vector<CheckedTask>& all) {
  std::string text = robot_text(all.front()) + design_text(all.front()) + all.front().outer;
  for (const CheckedTask& found : all) {
    if (all.size() > 1)
      text +=
          fmt::format("\ntask    {}, weight {} of F_joint\n", found.task.name, found.file.weight);
    text += gait_text(found) + travel_text(found) + demands_text(found) + style_text(found) +
            weights_text(found);
    for (const std::string& warning : found.warnings) text += fmt::format("warning {}\n", warning);
  }
  return text;
}

Json to_json(const std::vector<CheckedTask>& all) {
  if (all.size() == 1) return json_of(all.front());
  Json document = {{"schema", "legwright/check"}, {"version", 1}, {"tasks", Json::object()}};
  for (const CheckedTask& found : all) {
    document["tasks"][found.task.name] = json_of(found);
    document["tasks"][found.task.name]["weight"] = found.file.weight;
  }
  return document;
}

}  // namespace legwright
