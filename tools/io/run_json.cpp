// SPDX-License-Identifier: Apache-2.0
#include "tools/io/run_json.hpp"

#include "tools/io/checksum.hpp"
#include "tools/io/install.hpp"

namespace legwright {
namespace {

Json task_json(const Task& task) {
  return {{"name", task.name},
          {"gait", task.gait.name()},
          {"period_s", task.gait.period()},
          {"knots", task.gait.knot_count()},
          {"planted_margin_knots", task.planted_margin},
          {"velocity", {task.velocity.x(), task.velocity.y()}},
          {"turn_rate", task.turn_rate},
          {"floor_friction", task.floor_friction}};
}

Json parameters_json(const DesignSpace& space) {
  Json parameters = Json::array();
  for (const DesignParameter& p : space.parameters)
    parameters.push_back({{"name", p.name},
                          {"unit", p.unit},
                          {"kind", to_string(p.kind)},
                          {"sentence", p.sentence},
                          {"initial", p.initial},
                          {"lower", p.lower},
                          {"upper", p.upper},
                          {"final", p.initial},
                          {"tied_count", p.tied_count}});
  return parameters;
}

}  // namespace

Json start_of_run(const std::vector<std::string>& argv, const TaskFile& file,
                  const RobotModel& robot, const Objective& objective) {
  return {{"schema", "legwright/run"},
          {"version", 1},
          {"status", "running"},
          {"robot", robot.morphology.name},
          {"task", task_json(objective.task())},
          {"design_size", robot.space.size()},
          {"motion_size", objective.layout().motion_size()},
          {"parameters", parameters_json(robot.space)},
          {"argv", argv},
          {"versions", versions()},
          {"sha256", {{"task.toml", sha256_hex(file.text)}, {"robot.xml", sha256_hex(robot.xml)}}}};
}

void finish_run(Json& run, const std::string& status, const CodesignResult& result,
                const PlanQuality& quality, const std::vector<double>& history, double file_seconds,
                const std::vector<std::string>& reasons, const DesignSpace& space) {
  run["status"] = status;
  run["feasible"] = reasons.empty();
  run["reasons"] = reasons;
  run["motion_only_F"] = result.initial.value;
  run["motion_only_trace"] = result.motion_only_trace;
  run["final_F"] = result.best.value;
  run["history"] = history;
  run["design_iterations"] = result.design_iterations;
  run["newton_iterations"] = result.newton_iterations;
  run["factorisations"] = result.factorisations;
  run["projected_gradient_norm"] = result.best.projected_gradient_norm;
  run["motion_status"] = to_string(result.best.motion_status);
  run["speed_wanted"] = quality.speed_wanted;
  run["speed_reached"] = quality.speed_reached;
  run["heading_error_rad"] = quality.heading_error;
  run["ground_error_m"] = quality.ground_error;
  run["slide_share"] = quality.slide_share;
  run["root_residual"] = quality.root_residual;
  run["seconds"] = {{"total", result.seconds.total},
                    {"motion", result.seconds.motion},
                    {"adjoint", result.seconds.adjoint},
                    {"predictor", result.seconds.predictor},
                    {"files", file_seconds}};
  run["peak_rss_mib"] = peak_memory_mib();
  for (int k = 0; k < space.size(); ++k) run["parameters"][k]["final"] = result.best.s(k);
}

Json iteration_event(const DesignSpace& space, const DesignIteration& iteration,
                     const PlanQuality& quality) {
  Json terms = Json::object();
  for (const TermValue& term : iteration.terms) terms[std::string(term.name)] = term.value;
  return {{"event", "iteration"},
          {"index", iteration.index},
          {"F", iteration.value},
          {"terms", terms},
          {"s", by_name(space, iteration.s)},
          {"design_gradient_norm", iteration.projected_gradient_norm},
          {"newton_iterations", iteration.newton_iterations},
          {"motion_status", to_string(iteration.motion_status)},
          {"speed_reached", quality.speed_reached},
          {"design_step", iteration.design_step},
          {"seconds", iteration.seconds}};
}

}  // namespace legwright
