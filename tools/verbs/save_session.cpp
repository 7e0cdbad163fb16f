// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/save_session.hpp"

#include <utility>

#include "mjcf/text/input_error.hpp"
#include "optimizer/solve/lbfgs.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/run/run_json.hpp"
#include "tools/run/scene_sums.hpp"
#include "tools/session/design_motions.hpp"
#include "tools/task/task_text.hpp"
#include "tools/verbs/optimize_results.hpp"

namespace legwright {
namespace {

/// The problem of a state, with weights of its own.
CodesignProblem problem_of(const SessionState& state) {
  TaskSet set = state.problem->set;
  if (set.joint()) {
    set.text = with_weights(set.text, state.weights);
    for (std::size_t k = 0; k < set.tasks.size(); ++k) set.tasks[k].weight = state.weights[k];
  }
  return make_problem(std::move(set), state.problem->robot);
}

DesignIteration iteration_of(const SessionState& state, int index, const DesignPoint& point) {
  DesignIteration out;
  out.index = index;
  out.s = point.s;
  out.tasks = point.tasks;
  out.design_gradient.setZero(point.s.size());
  for (std::size_t k = 0; k < point.tasks.size(); ++k) {
    const TaskIterate& task = point.tasks[k];
    out.value += state.weights[k] * (task.value + task.outer_value);
    out.design_gradient += state.weights[k] * task.design_gradient;
    out.exact_gradient = out.exact_gradient && task.exact_gradient;
    out.newton_iterations += task.newton_iterations;
  }
  const DesignSpace space = state.space();
  out.projected_gradient_norm = projected_gradient_norm(out.s, out.design_gradient, space.lower(),
                                                        space.upper(), space.scale());
  return out;
}

using PointPointer = std::shared_ptr<const DesignPoint>;

PointPointer checked(PointPointer point) {
  if (!point) throw InputError("the session's body has no finite motion; change it before saving");
  return point;
}

/// The given body with its motions, which are solved for once.
PointPointer given_point(const SessionState& state, const std::vector<JointTask>& tasks,
                         DesignMotions& motions) {
  const Eigen::VectorXd given = state.problem->robot.space.initial();
  const SolvedMotions solved = state.given_motions->get([&] {
    std::vector<Eigen::VectorXd> first;
    first.reserve(tasks.size());
    for (const JointTask& task : tasks) first.push_back(task.guess(given));
    SolvedMotions out;
    for (const TaskIterate& task : checked(motions.settle(given, first))->tasks) {
      out.motions.push_back(task.m);
      out.status.push_back(task.motion_status);
    }
    return out;
  });
  return checked(motions.adopt(given, solved.motions, solved.status));
}

/// The given body and where the session stands, both with their motions.
MultistartResult found_by(const SessionState& state, const std::vector<JointTask>& tasks) {
  DesignMotions motions(tasks, static_cast<int>(tasks.size()), [] { return false; });
  std::vector<Eigen::VectorXd> here;
  for (std::size_t k = 0; k < tasks.size(); ++k)
    here.push_back(state.cold[k] ? tasks[k].guess(state.s()) : state.now->tasks[k].m);
  const PointPointer last = checked(motions.settle(state.s(), here));
  StartedRun run;
  run.label.start = "initial";
  for (int k = 0; k < static_cast<int>(tasks.size()); ++k) run.label.tasks.push_back(k);
  run.result.status = SolveStatus::stopped;
  run.result.initial = iteration_of(state, 0, *given_point(state, tasks, motions));
  run.result.best = iteration_of(state, 1, *last);
  run.result.motion_only_traces.resize(tasks.size());
  run.result.design_iterations = state.iterations;
  MultistartResult found;
  found.joint.push_back(std::move(run));
  return found;
}

}  // namespace

void save_session(const SessionRecord& session, const std::filesystem::path& root, bool force,
                  const SessionMaker& maker) {
  CodesignProblem problem = problem_of(*session.state);
  const ProblemCosts costs(problem);
  const MultistartResult found = found_by(*session.state, costs.tasks());
  const ResultFolder folder = ResultFolder::create(root, force);
  RunRecord run = write_start(folder, problem, false, maker.command);
  if (!maker.robot.empty()) run.files.of("robot.xml") = maker.robot.string();
  write_file(folder.inputs() / "session.jsonl", session.journal);
  Progress progress(Progress::Mode::quiet, {}, {}, {});
  Recorder recorder(folder, problem, progress, false, [] { return false; });
  recorder.start();
  const StartedRun& only = found.joint.front();
  recorder.iteration(only.label, only.result.initial);
  recorder.iteration(only.label, only.result.best);
  const Candidate chosen{kOptimum, only.result.best, {}, {}};
  write_end(folder, problem, found, chosen, false, maker.status, recorder, run,
            [](const std::string&) {});
  note_scenes(folder, run);
  recorder.end(run);
  write_json(folder.run_json(), json_of(run));
  folder.stand();
}

}  // namespace legwright
