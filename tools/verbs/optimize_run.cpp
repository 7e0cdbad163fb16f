// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/optimize_run.hpp"

#include <fmt/format.h>

#include "mjcf/text/input_error.hpp"
#include "tools/choose/choose_design.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/files/licence.hpp"
#include "tools/run/install.hpp"
#include "tools/run/run_json.hpp"
#include "tools/run/scene_sums.hpp"
#include "tools/simulate/rollout.hpp"
#include "tools/verbs/explain_changes.hpp"
#include "tools/verbs/joint_folders.hpp"
#include "tools/verbs/optimize_results.hpp"
#include "tools/verbs/recorder.hpp"
#include "tools/verbs/resume.hpp"

namespace legwright {
namespace {

Progress make_progress(const OptimizeOptions& options, const CodesignOptions& settings,
                       const CodesignProblem& problem) {
  std::vector<std::string> names, units;
  int unknowns = 0;
  for (int k = 0; k < problem.task_count(); ++k) {
    names.push_back(problem.task(k).name);
    units.push_back(problem.speed_unit(k));
    unknowns += problem.objectives[k]->layout().motion_size();
  }
  const auto mode =
      options.progress ? Progress::Mode::json : Progress::mode_for_stderr(options.quiet);
  Progress progress(mode, settings, names, units, problem.set.outer.empty() ? "F" : "F + J");
  progress.start(fmt::format(
      "{} design parameters, {} motion unknowns; first the motion of the initial design ...",
      problem.robot.space.size(), unknowns));
  return progress;
}

/// A run that has started. What is written of it in the end stands in its record.
class OptimizeRun {
 public:
  OptimizeRun(const ResultFolder& folder, const CodesignProblem& problem,
              const OptimizeOptions& options, const RunFollower& follower, CommandTimes& times,
              CheckpointFile* checkpoint, RunRecord& run)
      : folder_(folder),
        problem_(problem),
        options_(options),
        follower_(follower),
        times_(times),
        run_(run),
        checkpoint_file_(checkpoint),
        checkpoint_(checkpoint, "run"),
        stop_([&follower] { return follower.stop_signal() != 0; }),
        settings_(settings_of(options, problem.task_count(), stop_)),
        progress_(make_progress(options, settings_.codesign, problem)),
        recorder_(folder, problem, progress_, !options.no_pictures, stop_),
        costs_(problem, first_motion()),
        reasons_(problem, options.threads, options.few_keeps / 100.0, !options.plan_only, stop_,
                 checkpoint_.in("reasons")) {
    settings_.codesign.checkpoint = checkpoint_.in("search");
  }

  /// Solves the problem and writes what comes of it.
  void solve() {
    const MultistartResult found = search();
    folder_.check_there();
    Candidate chosen = optimum_of(found);
    const bool to_play = !stop_() && !options_.plan_only && usable(chosen.design);
    if (to_play) chosen = choose(found);
    write_end(folder_, problem_, found, chosen, to_play,
              status_text(found.winner().status, follower_.stop_signal()), recorder_, run_,
              follower_.warn);
    times_.end_of("results");
    if (usable(chosen.design)) explain(found, chosen);
    if (options_.front > 0 && !stop_()) trade_off(found);
    finish();
  }

 private:
  FirstMotionOptions first_motion() const {
    FirstMotionOptions out = first_motion_of(options_, stop_);
    out.checkpoint = checkpoint_.in("first motion");
    return out;
  }

  MultistartResult search() {
    settings_.on_iteration = [this](const RunLabel& label, const DesignIteration& iteration) {
      const bool whole = static_cast<int>(label.tasks.size()) == problem_.task_count();
      if (whole) along_.push_back(iteration);
      const bool low_enough = whole && options_.stop_at && iteration.value <= *options_.stop_at;
      const bool go_on = recorder_.iteration(label, iteration) && !low_enough;
      return (!follower_.on_iteration || follower_.on_iteration(label, iteration)) && go_on;
    };
    recorder_.start();
    times_.end_of("reading");
    MultistartResult found = codesign_from_starts(costs_.tasks(), problem_.robot.space, settings_);
    if (options_.few) reasons_.keep_fewest(found, settings_.on_iteration);
    times_.end_of("search");
    progress_.finish();
    return found;
  }

  static Candidate optimum_of(const MultistartResult& found) {
    return {kOptimum, found.winner().best, {}, {}};
  }

  Candidate choose(const MultistartResult& found) {
    ChoiceOptions how = choice_options(options_, settings_, stop_);
    how.space = reasons_.space_of_fewest();
    how.codesign.checkpoint = checkpoint_.in("choice");
    try {
      ChosenDesign choice = choose_design(problem_, costs_.tasks(), found, along_, how);
      run_.choice = choice.record;
      write_candidates(folder_, problem_, choice, *run_.choice);
      times_.end_of("physics");
      return std::move(choice.result);
    } catch (const RolloutStopped&) {  // before anything was played to the end
      return optimum_of(found);
    }
  }

  /// Reasons, certificate, steps on the gait.
  void explain(const MultistartResult& found, const Candidate& chosen) {
    folder_.check_there();
    if (!stop_() && !options_.no_reasons) {
      if (chosen.design.s != problem_.robot.space.initial())
        progress_.start(
            "why the body changed: each change is put back and played alone (Ctrl-C keeps the "
            "result) ...");
      reasons_.write(folder_, found, chosen, run_);
      progress_.finish();
      times_.end_of("reasons");
    }
    write_json(folder_.run_json(), json_of(run_));  // what follows may take a while, and adds to it
    if (!stop_() && !options_.no_certificate) {
      run_.certificate =
          write_certificate(folder_, problem_, costs_.tasks(), chosen, settings_.codesign.threads);
      times_.end_of("certificate");
    }
    CloseGapOptions gaps = gap_options(options_, stop_);
    gaps.checkpoint = checkpoint_.in("physics steps");
    if (gaps.steps > 0 && !stop_()) {
      close_gaps(folder_, problem_, chosen, gaps, run_);
      times_.end_of("physics_steps");
    }
  }

  void trade_off(const MultistartResult& found) {
    if (static_cast<int>(found.alone.size()) < problem_.task_count()) {
      follower_.warn("no trade-off front: the search ended before each task was solved alone");
      return;
    }
    CodesignOptions rules = settings_.codesign;
    rules.on_iteration = [this](const DesignIteration&) { return !stop_(); };
    rules.checkpoint = checkpoint_.in("front");
    run_.front = write_front(folder_, problem_, costs_.tasks(), found, options_.front, rules);
    times_.end_of("front");
  }

  void finish() {
    folder_.check_there();
    note_scenes(folder_, run_);
    recorder_.end(run_);
    write_json(folder_.run_json(), json_of(run_));  // complete, should the pictures be interrupted
    if (!options_.no_pictures && !stop_()) {
      recorder_.draw_rest(options_.quiet);
      times_.end_of("pictures");
    }
    times_.add_to(*run_.seconds);
    write_json(folder_.run_json(), json_of(run_));
    if (checkpoint_file_ != nullptr && !stop_()) checkpoint_file_->remove();
  }

  const ResultFolder& folder_;
  const CodesignProblem& problem_;
  const OptimizeOptions& options_;
  const RunFollower& follower_;
  CommandTimes& times_;
  RunRecord& run_;
  CheckpointFile* const checkpoint_file_;  // null: nothing is kept
  const Checkpoint checkpoint_;
  const StopAsked stop_;
  MultistartOptions settings_;
  Progress progress_;
  Recorder recorder_;
  const ProblemCosts costs_;
  ChangeReasons reasons_;
  std::vector<DesignIteration> along_;  // of the whole problem
};

/// Where the search of a run is kept; null where it is not.
std::unique_ptr<CheckpointFile> checkpoint_of(const ResultFolder& folder,
                                              const RunFollower& follower) {
  if (!follower.checkpoint) return nullptr;
  CheckpointBegin begin = follower.checkpoint->begin;
  const ByName<std::string> inputs = sums_of_inputs(folder.root());
  if (!begin.inputs.empty())
    check_same_inputs(folder.in_the_end(folder.root()), begin.inputs, inputs);
  begin.inputs = inputs;
  return std::make_unique<CheckpointFile>(folder.root(), begin, follower.checkpoint->states);
}

/// Whoever follows a run need not wait for one that was given up.
void note_failure(const ResultFolder& folder, RunRecord& run, const char* why) {
  if (run.status != "running") return;
  run.status = "failed";
  run.failure = clean_utf8(why);
  try {
    write_json(folder.run_json(), json_of(run));
  } catch (const std::exception&) {  // what went wrong first is told
  }
}

}  // namespace

void check_options(const OptimizeOptions& options, const CodesignProblem& problem) {
  if (options.front > 0 && (problem.task_count() != 2 || options.one_start || options.motion_only))
    throw InputError(
        problem.set.file.string(), 0, "",
        fmt::format("a front needs two tasks ([[task]] tables, in Python a list), each "
                    "solved alone, so neither one start nor motion only; found {}{}{}",
                    problem.task_count(), options.one_start ? ", one start" : "",
                    options.motion_only ? ", motion only" : ""));
}

void tell_warnings(const CodesignProblem& problem, const RunFollower& follower) {
  for (int k = 0; k < problem.task_count(); ++k)
    for (const std::string& warning : warnings_on(problem, k))
      follower.warn((problem.set.joint() ? problem.task(k).name + ": " : "") + warning);
}

void check_not_in_run(const std::filesystem::path& root, const RobotFiles& files) {
  namespace fs = std::filesystem;
  const fs::path run = fs::weakly_canonical(fs::absolute(root));
  std::vector<fs::path> needed;
  for (const AssetFile& asset : files.assets()) needed.push_back(asset.source);
  for (const std::string& licence : licences_in(files.folder()))
    needed.push_back(files.folder() / licence);
  for (const fs::path& file : needed) {
    const fs::path inside = fs::weakly_canonical(fs::absolute(file)).lexically_relative(run);
    if (!inside.empty() && *inside.begin() != "..")
      throw IoError(
          fmt::format("{}: the robot's own files lie in it, like {}; choose another folder, "
                      "or copy the robot elsewhere first",
                      root.string(), inside.string()));
  }
}

RunRecord optimize_into(const ResultFolder& folder, CodesignProblem& problem,
                        const OptimizeOptions& options, const RunFollower& follower,
                        CommandTimes& times) {
  RunRecord run = write_start(folder, problem, options.motion_only, follower.command);
  try {
    const auto checkpoint = checkpoint_of(folder, follower);
    OptimizeRun(folder, problem, options, follower, times, checkpoint.get(), run).solve();
  } catch (const std::exception& error) {
    note_failure(folder, run, error.what());
    throw;
  }
  return run;
}

}  // namespace legwright
