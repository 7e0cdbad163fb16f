// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/close_gap.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <atomic>
#include <cmath>
#include <memory>

#include "mjcf/text/input_error.hpp"
#include "optimizer/base/stopwatch.hpp"
#include "optimizer/solve/task_solver.hpp"
#include "tools/choose/kept_play.hpp"
#include "tools/choose/physics_trial.hpp"
#include "tools/files/replace_folder.hpp"
#include "tools/run/design_folder.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/verbs/joint_folders.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using Eigen::VectorXd;

/// A gait of the body: its cost with the scaled task, and its motion.
struct PlannedGait {
  std::unique_ptr<Objective> objective;
  TaskIterate motion;
};

class GapCloser {
 public:
  GapCloser(const CodesignProblem& problem, const Candidate& chosen, int k)
      : problem_(problem),
        chosen_(chosen),
        k_(k),
        scalars_(gait_scalars(problem.task(k))),
        // What was tightened stays so; knots planted beyond stance stay the same number where the
        // period changes by a little.
        file_(tightened_file(problem, k,
                             chosen.tightening.empty()
                                 ? Tightening()
                                 : chosen.tightening.at(static_cast<std::size_t>(k)))) {}

  const std::vector<GaitScalar>& scalars() const { return scalars_; }

  VectorXd factors(const VectorXd& x) const {
    VectorXd out(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i)
      out[i] = 1.0 + scalars_[static_cast<std::size_t>(i)].unit * x[i];
    return out;
  }

  /// The best motion of the body for scaled scalars, from the one that is known, which is that of
  /// scalars as they are. Throws InputError where there is no such task.
  PlannedGait plan(const VectorXd& x) const {
    const DesignIteration& best = chosen_.design;
    TaskFile file = scaled_task(file_, scalars_, factors(x));
    // A wish for the margin counts in knots: the scaled period must not change their number.
    *file.planted_margin *= file.period / file_.period;
    PlannedGait gait;
    const Task task_now = make_task(file, problem_.robot);
    gait.objective = std::make_unique<Objective>(as_in_task(problem_.robot.morphology, task_now),
                                                 problem_.robot.space, task_now);
    ObjectiveCost cost(*gait.objective);
    WeightedCost task;
    task.cost = &cost;
    gait.motion = best.tasks.at(static_cast<std::size_t>(k_));
    if (x.isZero(0.0)) return gait;
    task.initial_motion = gait.motion.m;
    const MotionLimits limits;
    TaskSolver solver(task, limits);
    if (!solver.start(best.s) || !solver.differentiate())
      throw InputError("the motion of the scaled task is not finite");
    gait.motion = solver.now();
    return gait;
  }

  GaitTrial play(const VectorXd& x) const {
    try {
      const PlannedGait gait = plan(x);
      return try_in_physics(
          problem_.robot, problem_.task(k_),
          design_texts(problem_.robot, *gait.objective, chosen_.design.s, gait.motion.m));
    } catch (const InputError&) {
      return {};  // out of reach, or no knot left for a swing: no such gait
    } catch (const MujocoError&) {
      return {};
    }
  }

 private:
  const CodesignProblem& problem_;
  const Candidate& chosen_;
  int k_;
  std::vector<GaitScalar> scalars_;
  TaskFile file_;
};

ByName<double> scalars_of(const GapCloser& closer, const VectorXd& x) {
  ByName<double> out;
  const VectorXd factors = closer.factors(x);
  for (std::size_t i = 0; i < closer.scalars().size(); ++i)
    out.emplace_back(closer.scalars()[i].name, factors[static_cast<Eigen::Index>(i)]);
  return out;
}

/// "speed x1.012, period x0.975": factors on what the task file says.
std::string factor_words(const GapCloser& closer, const VectorXd& x) {
  std::string text;
  const VectorXd factors = closer.factors(x);
  for (std::size_t i = 0; i < closer.scalars().size(); ++i)
    text += fmt::format("{}{} x{:.3f}", i == 0 ? "" : ", ", closer.scalars()[i].name,
                        factors[static_cast<Eigen::Index>(i)]);
  return text;
}

/// Of a gait that is played, in a checkpoint.
std::string name_of(const VectorXd& x) {
  return fmt::format("{:a}", fmt::join(x.begin(), x.end(), " "));
}

std::string step_words(const GapCloser& closer, const PhysicsStep& step, std::size_t number) {
  const char* const end = step.accepted             ? "kept, closer to the task"
                          : step.trial.line.empty() ? "rejected, there is no such gait"
                                                    : "rejected, no closer to the task";
  return fmt::format("physics step {}: {}: {}{}{}", number, factor_words(closer, step.x), end,
                     step.trial.line.empty() ? "" : ": ", step.trial.line);
}

double played_period_factor(const GapCloser& closer, const VectorXd& x) {
  for (std::size_t i = 0; i < closer.scalars().size(); ++i)
    if (closer.scalars()[i].name == "period")
      return closer.factors(x)[static_cast<Eigen::Index>(i)];
  return 1.0;
}

void write_result(const fs::path& result, const CodesignProblem& problem,
                  const DesignIteration& best, int k, const PlannedGait& gait) {
  DesignIteration iteration = best;
  iteration.tasks.at(static_cast<std::size_t>(k)) = gait.motion;
  const fs::path fresh = result.parent_path() / ".result-physics";
  fs::remove_all(fresh);  // of a run that was killed
  write_design(fresh, problem.robot, *gait.objective, iteration, k);
  // The certificate is of the co-design, whose gait was another one: it says so.
  if (const fs::path proof = result / "certificate.json"; fs::exists(proof)) {
    Json certificate = read_json(proof);
    certificate["of"] = "the gait before the physics steps";
    write_json(fresh / "certificate.json", certificate);
  }
  replace_folder(fresh, result);
}

}  // namespace

std::vector<GaitScalar> gait_scalars(const TaskFile& task) {
  std::vector<GaitScalar> out;
  if (task.velocity.norm() > 0.0) out.push_back({"speed", 0.01, 0.9, 1.1});
  if (task.turn_rate != 0.0) out.push_back({"turn_rate", 0.01, 0.9, 1.1});
  out.push_back({"swing_height", 0.1, 0.7, 1.5});
  out.push_back({"period", 0.03, 0.85, 1.15});
  out.push_back({"margins", 0.1, 1.0, 1.5});
  return out;
}

TaskFile scaled_task(const TaskFile& task, const std::vector<GaitScalar>& scalars,
                     const VectorXd& factors) {
  TaskFile out = task;
  for (std::size_t i = 0; i < scalars.size(); ++i) {
    const std::string& name = scalars[i].name;
    const double factor = factors[static_cast<Eigen::Index>(i)];
    if (name == "speed") out.velocity *= factor;
    if (name == "turn_rate") out.turn_rate *= factor;
    if (name == "swing_height" && out.margins.swing_height) *out.margins.swing_height *= factor;
    if (name == "period") out.period *= factor;
    if (name == "margins") {  // farther from the edges of the cone
      out.margins.friction /= factor;
      out.margins.min_normal *= factor;
    }
  }
  return out;
}

PhysicsStepsRecord close_gap(const ResultFolder& folder, const CodesignProblem& problem,
                             const Candidate& chosen, int k, const CloseGapOptions& options) {
  const Stopwatch watch;
  load_gait_plugin();
  const GapCloser closer(problem, chosen, k);
  const auto count = static_cast<Eigen::Index>(closer.scalars().size());
  VectorXd lower(count), upper(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const GaitScalar& scalar = closer.scalars()[static_cast<std::size_t>(i)];
    lower[i] = (scalar.least - 1.0) / scalar.unit;
    upper[i] = (scalar.most - 1.0) / scalar.unit;
  }
  PhysicsStepOptions rules;
  rules.steps = options.steps;
  rules.threads = options.threads;
  rules.stop = options.stop;
  std::size_t number = 0;
  rules.on_step = [&](const PhysicsStep& step) {
    if (options.tell) options.tell(step_words(closer, step, ++number));
  };
  std::atomic<int> rollouts = 0;
  const auto play = [&](const VectorXd& x) -> PhysicsTrial {
    GaitTrial trial =
        kept_play(options.checkpoint.in(name_of(x)), options.stop, [&] { return closer.play(x); });
    rollouts += trial.rollouts;
    return trial;
  };
  const PhysicsStepsResult found =
      take_physics_steps(play, VectorXd::Zero(count), lower, upper, rules);
  const bool better = found.best.merit() < found.start.merit();
  if (better)
    write_result(result_folder(folder, problem, k), problem, chosen.design, k,
                 closer.plan(found.x));
  const auto summary = [](const PhysicsTrial& trial) {
    return PlayedGait{trial.merit(), trial.pass, trial.line};
  };
  PhysicsStepsRecord out{.before = summary(found.start),
                         .after = summary(found.best),
                         .scalars = scalars_of(closer, found.x),
                         .factors = factor_words(closer, found.x),
                         .period = problem.task(k).period * played_period_factor(closer, found.x),
                         .seconds = watch.seconds(),
                         .changed = better,
                         .rollouts = rollouts,
                         .steps = {}};
  for (const PhysicsStep& step : found.steps)
    out.steps.push_back({scalars_of(closer, step.x), step.trial.merit(), step.predicted_merit,
                         step.accepted, step.trial.line});
  return out;
}

}  // namespace legwright
