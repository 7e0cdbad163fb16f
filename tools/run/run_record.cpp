// SPDX-License-Identifier: Apache-2.0
#include "tools/run/run_record.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "optimizer/motion/faced_frame.hpp"

namespace legwright {

void fields(Fields& f, SlopeRecord& slope) {
  f("along", slope.along, "rad, uphill along the wanted way");
  f("across", slope.across, "rad");
}

void fields(Fields& f, PayloadRecord& payload) {
  f("mass_kg", payload.mass);
  f("position_m", payload.position);
  f("size_m", payload.size);
}

void fields(Fields& f, CandidateRecord& candidate) {
  f("name", candidate.name);
  f("F", candidate.F, "of the task as it was given");
  f("played", candidate.played);
  f("folder", candidate.folder,
    "of its files, in the run; a folder per task where there are several");
  f("failing", candidate.failing, "of several tasks: the line of each that fails");
  f("stable", candidate.stable, "whether its cycle is stable at all gains, where that decides");
  f("multiplier", candidate.multiplier,
    "largest Floquet multiplier at half, default and double gains; absent where it falls");
  f("tasks", candidate.tasks, "of several tasks: what physics says of each by itself");
}

void fields(Fields& f, ChoiceRecord& choice) {
  f("chosen", choice.chosen, "name of the candidate in result/");
  f("pass", choice.pass, "at half, default and double gains");
  f("rollouts", choice.rollouts);
  f("seconds", choice.seconds);
  f("candidates", choice.candidates, "in the order in which they were played");
}

void fields(Fields& f, PhysicsStepRecord& step) {
  f("scalars", step.scalars, "factors on what the task says");
  f("merit", step.merit, "null where it fell or there is no such gait");
  f("predicted_merit", step.predicted_merit);
  f("accepted", step.accepted);
  f("line", step.line, "of the verdict");
}

void fields(Fields& f, PhysicsStepsRecord& steps) {
  f("before", steps.before);
  f("after", steps.after);
  f("scalars", steps.scalars, "factors on what the task says");
  f("factors", steps.factors, "the same in words");
  f("period_s", steps.period, "of the gait played");
  f("seconds", steps.seconds);
  f("changed", steps.changed, "whether the gait in result/ is another one than that of F");
  f("rollouts", steps.rollouts);
  f("steps", steps.steps);
}

Eigen::Vector2d TaskRecord::facing() const {
  return facing_axis(forward.value_or("+x")).value_or(Eigen::Vector2d::UnitX());
}

void fields(Fields& f, TaskRecord& task) {
  f("name", task.name);
  f("gait", task.gait);
  f("period_s", task.period);
  f("knots", task.knots);
  f("planted_margin_knots", task.planted_margin);
  f("velocity", task.velocity, "m/s, along x and y of the trunk's frame");
  f("forward", task.forward, "the axis of that frame along which the robot looks; absent: +x");
  f("turn_rate", task.turn_rate, "rad/s, to the left");
  f("floor_friction", task.floor_friction);
  f("slope_rad", task.slope);
  f("payload", task.payload);
  f("torque_limit_Nm", task.torque_limit);
  f("servo_kp_Nm_per_rad", task.servo_kp);
  f("step_over_m", task.step_over);
  f("dynamics", task.dynamics,
    "\"constant_inertia\": equation (13) as the paper has it; absent: the momentum of all bodies");
  f("weight", task.weight, "in the joint cost; this and what follows is of a joint run");
  f("folder", task.folder, "tasks/NAME");
  f("motion_size", task.motion_size);
  f("F_initial", task.initial_F);
  f("F", task.F);
  f("speed_wanted", task.speed_wanted);
  f("speed_reached", task.speed_reached);
  f("feasible", task.feasible);
  f("physics_steps", task.physics_steps);
}

void fields(Fields& f, ParameterRecord& parameter) {
  f("name", parameter.name);
  f("unit", parameter.unit);
  f("kind", parameter.kind);
  f("sentence", parameter.sentence);
  f("initial", parameter.initial);
  f("lower", parameter.lower);
  f("upper", parameter.upper);
  f("final", parameter.final);
  f("tied_count", parameter.tied_count, "places of the robot that it sets");
}

void fields(Fields& f, OuterMeasured& measured) {
  f("initial", measured.initial, "by servo gains; without those at which it fell");
  f("result", measured.result);
}

void fields(Fields& f, OuterRecord& outer) {
  f("objective", outer.objective);
  f("source", outer.source, "of a function of the caller's: its language and name");
  f("weight", outer.weight, "of the quantity over its reference, in J");
  f("unit", outer.unit, "of the quantity");
  f("reference", outer.reference, "in that unit");
  f("plan_initial", outer.plan_initial, "the quantity in the plan of the initial body");
  f("plan_final", outer.plan_final, "the same of the result");
  f("measured", outer.measured, "the same in MuJoCo, once the run is validated");
}

void fields(Fields& f, StartRecord& start) {
  f("start", start.start, "\"initial\", or the task whose best body it set out from, …");
  f("tasks", start.tasks);
  f("status", start.status);
  f("F_start", start.start_F);
  f("F", start.F);
  f("F_tasks_start", start.start_F_of_tasks);
  f("F_tasks", start.F_of_tasks);
  f("design_iterations", start.design_iterations);
  f("newton_iterations", start.newton_iterations);
  f("seconds", start.seconds);
  f("s", start.s, "design parameters at the end, SI");
}

void fields(Fields& f, EngineWarningRecord& warning) {
  f("task", warning.task);
  f("warning", warning.warning);
  f("count", warning.count);
  f("first_s", warning.first);
}

void fields(Fields& f, BodyRecord& body) {
  f("mass_kg", body.mass, "of the robot without payload");
  f("printed_volume_m3", body.printed_volume);
}

void fields(Fields& f, BodiesRecord& bodies) {
  f("initial", bodies.initial);
  f("final", bodies.final);
}

void fields(Fields& f, CertificateNote& note) {
  f("worst_gradient_error", note.worst_gradient_error);
  f("active_bounds", note.active_bounds);
  f("seconds", note.seconds);
}

void fields(Fields& f, FrontPointRecord& point) {
  f("weight", point.weight, "of the first task");
  f("F", point.F);
  f("F_tasks", point.F_of_tasks);
  f("status", point.status);
  f("s", point.s);
}

namespace {

void visit_inputs(Fields& f, RunRecord& run) {
  f("status", run.status, "\"running\", \"failed\", or how the search ended");
  f("robot", run.robot);
  f("outer", run.outer, "the further objective J of the body");
  f("name", run.name, "of the task file, where it has several tasks");
  f("tasks", run.tasks, "of a joint run");
  f.required_if(!run.joint(), "task", run.task, "of a run of one task");
  f("design_size", run.design_size);
  f("motion_size", run.motion_size);
  f("parameters", run.parameters);
  f("argv", run.argv);
  f("versions", run.versions);
  f("factorisation", run.factorisation, "kernel of the linear solver");
  f("files", run.files, "where the inputs lay");
  f("sha256", run.sha256, "of all input files");
  f("joint_run", run.joint_run, "way to the joint run that this task is of");
  f("motion_only", run.motion_only, "whether the body was kept");
  f("start", run.start, "of a task of a joint run: from which its best search set out");
}

void visit_outcome(Fields& f, RunRecord& run) {
  const bool ended = run.ended(), single = ended && !run.joint(), joint = ended && run.joint();
  f("engine_warnings", run.engine_warnings, "of MuJoCo, while it played the result for a second");
  f("put_back", run.put_back, "what each change of the body buys; the rows do not add up");
  f("fewest_changes", run.fewest_changes, "with how few changes of the body F falls how far");
  f.required_if(ended, "feasible", run.feasible);
  f.required_if(ended, "reasons", run.reasons, "why the result is not feasible");
  f.required_if(ended, "motion_only_F", run.motion_only_F, "of the initial body");
  f.required_if(single, "motion_only_trace", run.motion_only_trace, "the same by Newton step");
  f.required_if(ended, "final_F", run.final_F);
  f.required_if(single, "final_J", run.final_J);
  f("final_terms", run.final_terms, "what final_F consists of");
  f.required_if(joint, "best_start", run.best_start);
  f.required_if(joint, "starts", run.starts);
  f.required_if(joint, "alone", run.alone, "searches for one task");
  f.required_if(single, "history", run.history, "F by iteration");
}

void visit_effort(Fields& f, RunRecord& run) {
  const bool ended = run.ended(), single = ended && !run.joint();
  f.required_if(ended, "design_iterations", run.design_iterations);
  f.required_if(ended, "newton_iterations", run.newton_iterations);
  f.required_if(ended, "factorisations", run.factorisations);
  f.required_if(ended, "seconds", run.seconds, "by what took them");
  f.required_if(ended, "peak_rss_mib", run.peak_rss_mib);
  f.required_if(ended, "projected_gradient_norm", run.projected_gradient_norm);
  f.required_if(single, "motion_status", run.motion_status);
  f.required_if(single, "speed_wanted", run.speed_wanted, "m/s; on the spot rad/s");
  f.required_if(single, "speed_reached", run.speed_reached, "of the plan");
  f.required_if(single, "heading_error_rad", run.heading_error);
  f.required_if(single, "ground_error_m", run.ground_error);
  f.required_if(single, "slide_share", run.slide_share);
  f.required_if(single, "root_residual", run.root_residual);
  f.required_if(ended, "body", run.body);
  f("certificate", run.certificate, "what result/certificate.json came to");
  f("choice", run.choice, "which of its designs MuJoCo let optimize hand back");
  f("picked", run.picked, "which design `legwright pick` made the result");
  f("physics_steps", run.physics_steps, "what optimize --physics-steps did to the gait");
  f("front", run.front, "trade-off between two tasks, as in result/front.json");
  f("failure", run.failure, "why the status is \"failed\"");
  f("scenes", run.scenes,
    "SHA-256 of the scenes that the run wrote, by their paths in it; absent in older runs");
}

}  // namespace

void fields(Fields& f, RunRecord& run) {
  visit_inputs(f, run);
  visit_outcome(f, run);
  visit_effort(f, run);
}

std::optional<std::string> ChoiceRecord::complaint(const std::string& candidate,
                                                   const std::string& task) const {
  for (const CandidateRecord& each : candidates) {
    if (each.name != candidate || each.played.pass) continue;
    const std::string* line = each.failing ? each.failing->find(task) : &each.played.line;
    if (line != nullptr) return "MuJoCo does not pass it: " + *line;
  }
  return std::nullopt;
}

bool ChoiceRecord::by_stability() const {
  double F = -std::numeric_limits<double>::infinity();
  for (const CandidateRecord& each : candidates)
    if (each.name == chosen) F = each.F;
  return std::any_of(candidates.begin(), candidates.end(), [&](const CandidateRecord& each) {
    return each.stable.has_value() && each.F < F;
  });
}

bool RunRecord::body_kept() const {
  return ended() && std::all_of(parameters.begin(), parameters.end(),
                                [](const ParameterRecord& p) { return p.final == p.initial; });
}

bool RunRecord::tightened() const {
  if (!choice) return false;
  const std::string& result = result_name();
  return result.starts_with(kTightened) ||
         result.find(std::string(", ") + kTightened) != std::string::npos;
}

std::string RunRecord::result_candidate() const {
  if (!choice) return "";
  for (const CandidateRecord& candidate : choice->candidates)
    if (candidate.name == result_name() && candidate.folder) return *candidate.folder;
  return "";
}

std::optional<double> RunRecord::fall_of_cost() const {
  if (!motion_only_F || !final_F || !std::isfinite(*motion_only_F - *final_F)) return std::nullopt;
  return *motion_only_F - *final_F;
}

}  // namespace legwright
