// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/document.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "optimizer/motion/faced_frame.hpp"
#include "optimizer/terms/registry.hpp"
#include "tools/task/task_file.hpp"
#include "tools/validate/verdict.hpp"

namespace legwright {
namespace {

const char* group_of(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::length:
      return "lengths";
    case ParameterKind::axis_angle:
      return "axes";
    case ParameterKind::position:
      return "attachments";
  }
  return "others";
}

Json parameters_of(const SessionState& state, const std::vector<Handle>& handles,
                   const mjModel& model) {
  Json out = Json::array();
  const DesignSpace& space = state.problem->robot.space;
  const Eigen::VectorXd scale = space.scale();
  for (std::size_t i = 0; i < space.parameters.size(); ++i) {
    const DesignParameter& one = space.parameters[i];
    Json parts = Json::array();
    for (const Binding::Target& target : state.problem->robot.bindings[i].targets)
      parts.push_back({{"name", target.name}, {"mirrored", target.mirror.has_value()}});
    out.push_back({{"name", one.name},
                   {"sentence", one.sentence},
                   {"unit", one.unit},
                   {"kind", to_string(one.kind)},
                   {"group", group_of(one.kind)},
                   {"value", state.s()[static_cast<Eigen::Index>(i)]},
                   {"given", state.given[static_cast<Eigen::Index>(i)]},
                   {"robot_lower", one.lower},
                   {"robot_upper", one.upper},
                   {"scale", scale[static_cast<Eigen::Index>(i)]},
                   {"tie", parts},
                   {"handle", handle_json(handles.at(i), model)}});
  }
  return out;
}

Json cells_of(const Gait& gait, const std::vector<std::string>& feet) {
  Json out = Json::array();
  for (int foot = 0; foot < gait.foot_count(); ++foot) {
    Json cells = Json::array();
    for (int knot = 0; knot < gait.knot_count(); ++knot)
      cells.push_back(gait.in_contact(knot, foot) ? 1 : 0);
    out.push_back({{"foot", feet[static_cast<std::size_t>(foot)]}, {"cells", cells}});
  }
  return out;
}

Json payload_of(const Task& task) {
  return task.payload ? Json(task.payload->mass) : Json(nullptr);
}

/// What a task asks for, as verdicts say it.
std::string words_of(const TaskFile& file) {
  WantedMotion wanted;  // velocity and facing in the frame that it faces along
  wanted.velocity = file.velocity;
  wanted.turn_rate = file.turn_rate;
  return describe(wanted, file.gait);
}

Json tasks_of(const SessionState& state, const std::vector<std::string>& feet) {
  Json out = Json::array();
  for (int k = 0; k < state.problem->task_count(); ++k) {
    const TaskFile& file = state.problem->task(k);
    const Task& task = state.problem->objectives[static_cast<std::size_t>(k)]->task();
    const SlopeAngles slope = slope_of(task.velocity, task.up);
    const bool own = !file.touchdown.empty() || !file.touchdown_by_foot.empty();
    out.push_back({{"name", file.name},
                   {"words", words_of(file)},
                   {"gait", file.gait},
                   {"gait_kind", own ? "own" : "library"},
                   {"velocity", {file.velocity.x(), file.velocity.y()}},
                   {"turn", file.turn_rate},
                   {"period", task.gait.period()},
                   {"knots", task.gait.knot_count()},
                   {"weight", state.weights[static_cast<std::size_t>(k)]},
                   {"com_height", task.com_height ? Json(*task.com_height) : Json(nullptr)},
                   {"payload", payload_of(task)},
                   {"slope", {slope.along, slope.across}},
                   {"step", task.step_over},
                   {"swing_height", task.swing_height ? Json(*task.swing_height) : Json(nullptr)},
                   {"friction", task.friction},
                   {"floor_friction", task.floor_friction},
                   {"min_normal", task.min_normal},
                   {"torque_margin", task.torque_margin},
                   {"stance_width", file.stance_width},
                   {"aim_speed", file.aim_speed},
                   {"aim_turn_rate", file.aim_turn_rate},
                   {"term_weights", task.weights},
                   {"footfalls", cells_of(task.gait, feet)}});
  }
  return out;
}

Json gaits_of(const SessionState& state, const std::vector<std::string>& feet) {
  constexpr int kCells = 24;
  Json out = Json::array();
  const std::vector<int> order = order_as_faced(
      home_feet(state.problem->robot.morphology, state.problem->robot.space.initial()),
      state.problem->set.tasks.front().forward);
  for (const GaitPattern& pattern : gait_library(static_cast<int>(feet.size())))
    out.push_back({{"name", pattern.name},
                   {"words", pattern.about},
                   {"duty", pattern.duty},
                   {"footfalls", cells_of(Gait(pattern, 1.0, kCells, order), feet)}});
  return out;
}

Json terms_of_all() {
  Json out = Json::array();
  for (const TermEntry& entry : term_registry())
    out.push_back({{"name", entry.name},
                   {"words", entry.label},
                   {"cost_words", entry.cost_label},
                   {"unit", entry.unit},
                   {"weight", entry.default_weight}});
  return out;
}

/// Whether a body's mass depends on its design: links whose masses a file tells keep them.
bool mass_changes(const RobotModel& robot) {
  for (const Link& link : robot.morphology.links)
    for (const PointMass& point : link.masses)
      for (const Eigen::VectorXd& s : {robot.space.lower(), robot.space.upper()})
        if (point.growth_at(s) != point.growth_at(robot.space.initial())) return true;
  return false;
}

/// The body that each joint moves.
Json joints_of(const mjModel& model) {
  Json out = Json::array();
  for (int joint = 0; joint < model.njnt; ++joint)
    if (const char* name = mj_id2name(&model, mjOBJ_JOINT, joint); name != nullptr)
      out.push_back({{"name", name}, {"body", model.jnt_bodyid[joint]}});
  return out;
}

}  // namespace

Json document_json(const SessionState& state, const std::vector<Handle>& handles,
                   const mjModel& model) {
  const std::vector<std::string> feet = foot_names(state.problem->robot.morphology);
  return {{"name", state.problem->robot.morphology.name},
          {"mass", state.problem->robot.morphology.total_mass()},
          {"mass_changes", mass_changes(state.problem->robot)},
          {"leg_length", state.problem->robot.morphology.leg_length},
          {"feet", feet},
          {"joints", joints_of(model)},
          {"parameters", parameters_of(state, handles, model)},
          {"tasks", tasks_of(state, feet)},
          {"task_text", state.problem->set.text},
          {"gaits", gaits_of(state, feet)},
          {"terms", terms_of_all()}};
}

}  // namespace legwright
