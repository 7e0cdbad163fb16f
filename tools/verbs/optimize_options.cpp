// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/optimize_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "tools/verbs/number_options.hpp"
#include "tools/verbs/progress.hpp"

namespace legwright {
namespace {

/// Threads as asked, or all there are.
int all_threads(const OptimizeOptions& options) {
  if (options.threads > 0) return options.threads;
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

std::function<void(const std::string&)> teller_of(const OptimizeOptions& options) {
  if (options.progress)
    return [played = 0](const std::string&) mutable {
      print_progress("playing designs in MuJoCo", ++played, 0);
    };
  if (options.quiet) return {};
  return [](const std::string& line) { fmt::print(stderr, "{}\n", line); };
}

}  // namespace

MultistartOptions settings_of(const OptimizeOptions& options, int task_count,
                              const StopAsked& stop) {
  MultistartOptions settings;
  settings.codesign.max_iterations = options.max_iterations;
  settings.codesign.motion_only = options.motion_only;
  settings.codesign.method = options.lbfgs     ? DesignMethod::lbfgs
                             : options.bilevel ? DesignMethod::newton
                                               : DesignMethod::joint;
  settings.codesign.go_on = settings.codesign.newton.go_on = [stop] { return !stop(); };
  settings.codesign.threads = std::min(task_count, all_threads(options));
  settings.from_single_tasks = !options.one_start && !options.motion_only;
  settings.perturbations = options.motion_only ? 0 : options.starts;
  settings.seed = options.seed;
  return settings;
}

FirstMotionOptions first_motion_of(const OptimizeOptions& options, const StopAsked& stop) {
  FirstMotionOptions out{options.motion_only ? options.starts : 0, options.seed};
  out.go_on = [stop] { return !stop(); };
  out.threads = all_threads(options);
  if (out.perturbations > 0 && !options.quiet && !options.progress)
    out.tell = [](const std::string& start, double F) {
      fmt::print(stderr, "motion from {}: F {:.5g}\n", start, F);
    };
  return out;
}

ChoiceOptions choice_options(const OptimizeOptions& options, const MultistartOptions& settings,
                             const StopAsked& stop) {
  ChoiceOptions out;
  out.codesign = settings.codesign;
  out.threads = all_threads(options);
  out.tell = teller_of(options);
  out.stop = stop;
  return out;
}

CloseGapOptions gap_options(const OptimizeOptions& options, const StopAsked& stop) {
  return {options.physics_steps, all_threads(options), teller_of(options), stop};
}

void fields(Fields& f, OptimizeOptions& options) {
  f("task", options.task);
  f("robot", options.robot);
  f("confined", options.confined);
  f("motion_only", options.motion_only);
  f("max_iterations", options.max_iterations);
  f("one_start", options.one_start);
  f("stop_at", options.stop_at);
  f("starts", options.starts);
  f("seed", options.seed);
  f("front", options.front);
  f("physics_steps", options.physics_steps);
  f("threads", options.threads);
  f("no_certificate", options.no_certificate);
  f("no_reasons", options.no_reasons);
  f("bilevel", options.bilevel);
  f("lbfgs", options.lbfgs);
  f("few", options.few);
  f("few_keeps", options.few_keeps);
  f("plan_only", options.plan_only);
  f("no_pictures", options.no_pictures);
}

namespace {

/// --resume and what may stand beside it: all else is as it was begun.
void add_resume(CLI::App& verb, OptimizeOptions& options) {
  CLI::Option* const resume =
      verb.add_option("--resume", options.resume,
                      "go on with the search of this run folder, which was stopped or killed, with "
                      "the options that it was begun with");
  verb.add_flag("--anyway", options.anyway,
                "though another version of Legwright, or another kind of processor, began it: last "
                "bits may differ then")
      ->needs(resume);
  verb.add_flag("--quiet", options.quiet, "say nothing but errors");
  verb.add_flag("--progress", options.progress,
                "tell iterations, then designs that were played, as lines of JSON on stderr, for "
                "programs; their total is 0 where nobody knows it");
  verb.add_flag("--json", options.json, "print run.json instead of a summary");
}

}  // namespace

void add_options(CLI::App& verb, OptimizeOptions& options) {
  verb.add_option("TASK", options.task, "task file (TOML), which names its robot");
  verb.add_option("--robot", options.robot, "MJCF of another robot than the one the task names");
  verb.add_option("-o,--output", options.run, "folder of the run; default: runs/ROBOT-TASK");
  verb.add_flag("--motion-only", options.motion_only,
                "keep the initial design, optimize its motion");
  verb.add_option("--max-iterations", options.max_iterations, "design iterations at most")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
  verb.add_flag("--one-start", options.one_start,
                "several tasks: start from the initial design only, not from each task's optimum");
  verb.add_option("--stop-at", options.stop_at,
                  "end the search once F is as low as this, as the paper's Algorithm 1 does")
      ->check(finite_number());
  verb.add_option("--starts", options.starts,
                  "further starts from perturbed initial designs; with --motion-only: from "
                  "perturbed motions")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  verb.add_option("--seed", options.seed, "of the perturbations")
      ->check(seed_number())
      ->capture_default_str();
  verb.add_option(
          "--front", options.front,
          "two tasks: walk the weights from one to the other over so many points between the ends, "
          "and that of the task file")
      ->check(CLI::Range(1, 99));
  verb.add_option("--physics-steps", options.physics_steps,
                  "then so many steps on speed, swing height, period and margins of the gait, "
                  "from roll-outs in MuJoCo; only what they confirm is kept")
      ->check(CLI::Range(0, 100));
  verb.add_option("--threads", options.threads,
                  "tasks solved at the same time; results do not depend on it; default: all cores")
      ->check(CLI::Range(1, 64));
  verb.add_flag("--no-certificate", options.no_certificate,
                "no result/certificate.json, which costs some hundredths of a second");
  verb.add_flag("--no-reasons", options.no_reasons,
                "not what each change of the body buys, nor how few of them would do, which MuJoCo "
                "plays, too; both take up to half of the command");
  verb.add_flag("--bilevel", options.bilevel,
                "solve the motion anew for each body, as the paper's Algorithm 1 does, instead of "
                "stepping body and motion together");
  verb.add_flag("--lbfgs", options.lbfgs,
                "the same, with the design stepped by L-BFGS, as in the paper, instead of Newton's "
                "method");
  verb.add_flag("--few", options.few,
                "hand back the body with the fewest changes that keeps most of the fall of F");
  verb.add_option("--few-keeps", options.few_keeps, "how much of the fall of F [%]")
      ->check(number_between(1.0, 100.0))
      ->capture_default_str();
  verb.add_flag("--plan-only", options.plan_only,
                "hand back the optimum of F, whatever MuJoCo says of it");
  verb.add_flag("--no-pictures", options.no_pictures, "no frame.png of the iterations");
  verb.add_flag("--force", options.force, "replace the run that the folder holds");
  add_resume(verb, options);
}

}  // namespace legwright
