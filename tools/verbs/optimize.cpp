// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <memory>

#include "mjcf/input_error.hpp"
#include "tools/io/design_folder.hpp"
#include "tools/io/events.hpp"
#include "tools/io/install.hpp"
#include "tools/io/result_folder.hpp"
#include "tools/io/run_json.hpp"
#include "tools/io/task_file.hpp"
#include "tools/verbs/feasibility.hpp"
#include "tools/verbs/picture_queue.hpp"
#include "tools/verbs/progress.hpp"
#include "tools/verbs/stop_signals.hpp"
#include "tools/verbs/summary.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

struct OptimizeOptions {
  std::string task, run;
  bool motion_only = false, no_pictures = false, quiet = false, json = false, force = false;
  int max_iterations = CodesignOptions{}.max_iterations;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Writes what codesign() finds into the run's folder, as it finds it.
class Recorder {
 public:
  Recorder(const ResultFolder& folder, const RobotModel& robot, const Objective& objective,
           Progress& progress, bool pictures)
      : folder_(folder),
        robot_(robot),
        objective_(objective),
        progress_(progress),
        events_(folder.events()),
        pictures_(pictures) {}

  void start(const Json& run) {
    events_.append({{"event", "start"}, {"task", run["task"]["name"]}, {"robot", run["robot"]}});
  }

  /// @return false to stop
  bool iteration(const DesignIteration& iteration) {
    const auto start = std::chrono::steady_clock::now();
    // Rename is enough here: a killed process loses nothing, and a flush to disk would take longer
    // than the step.
    const fs::path folder = folder_.iteration(iteration.index);
    const PlanQuality quality =
        write_design(folder, robot_, objective_, iteration, Durability::process);
    events_.append(iteration_event(robot_.space, iteration, quality));
    pictures_.add(folder);
    progress_.iteration(iteration, quality);
    seconds_ += seconds_since(start);
    return StopSignals::received() == 0;
  }

  PlanQuality result(const DesignIteration& best) {
    const auto start = std::chrono::steady_clock::now();
    const PlanQuality quality = write_design(folder_.result(), robot_, objective_, best);
    seconds_ += seconds_since(start);
    return quality;
  }

  void end(const Json& run) {
    events_.append({{"event", "end"},
                    {"status", run["status"]},
                    {"F", run["final_F"]},
                    {"seconds", run["seconds"]["total"]}});
    events_.sync();
  }

  double seconds() const { return seconds_; }
  PictureQueue& pictures() { return pictures_; }

 private:
  const ResultFolder& folder_;
  const RobotModel& robot_;
  const Objective& objective_;
  Progress& progress_;
  EventLog events_;
  PictureQueue pictures_;
  double seconds_ = 0.0;
};

/// A model may be named anything, "../x" included; a folder may not.
std::string as_folder_name(std::string name) {
  for (char& c : name) {
    const bool plain = (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (!plain && c != '_' && c != '-') c = '_';
  }
  return name;
}

std::unique_ptr<Objective> make_objective(const TaskFile& file, const RobotModel& robot) {
  const Task task = make_task(file, robot);
  try {
    return std::make_unique<Objective>(robot.morphology, robot.space, task);
  } catch (const std::invalid_argument& error) {
    throw InputError(file.file.string(), 0, "",
                     std::string(error.what()) + "; robot and task do not fit");
  }
}

std::string status_text(SolveStatus status, int signal) {
  if (signal == SIGINT) return "interrupted";
  return std::string(to_string(status));
}

void draw_rest(PictureQueue& pictures, bool quiet) {
  const std::size_t waiting = pictures.waiting();
  if (!quiet && waiting > 1)
    fmt::print(stderr, "drawing {} more pictures (may be interrupted)\n", waiting);
  while (pictures.waiting() > 0 && StopSignals::received() == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  if (StopSignals::received() != 0) return;
  const std::string warning = pictures.finish();
  if (!warning.empty()) fmt::print(stderr, "legwright: warning: {}\n", warning);
}

int exit_code(int signal, const std::vector<std::string>& reasons) {
  if (signal == SIGINT) return kInterrupted;
  if (signal != 0) return kStoppedEarly;
  return reasons.empty() ? kOk : kInfeasible;
}

int optimize(const OptimizeOptions& options) {
  const TaskFile file = read_task_file(options.task);
  const RobotModel robot = read_robot(file.robot);
  const std::unique_ptr<Objective> objective = make_objective(file, robot);
  if (!options.quiet)
    for (const std::string& warning : task_warnings(objective->task(), robot))
      fmt::print(stderr, "legwright: warning: {}\n", warning);

  const fs::path root =
      options.run.empty()
          ? fs::path("runs") / (as_folder_name(robot.morphology.name) + "-" + file.name)
          : fs::path(options.run);
  const ResultFolder folder = ResultFolder::create(root, options.force);
  Json run = start_of_run(command_line(), file, robot, *objective);
  write_json(folder.run_json(), run);
  write_file(folder.inputs() / "task.toml", text_beside_robot(file));
  write_file(folder.inputs() / "robot.xml", robot.xml);

  CodesignOptions settings;
  settings.max_iterations = options.max_iterations;
  settings.motion_only = options.motion_only;
  const bool turning = objective->task().velocity.norm() == 0.0;
  Progress progress(Progress::mode_for_stderr(options.quiet), settings, turning ? "rad/s" : "m/s");
  Recorder recorder(folder, robot, *objective, progress, !options.no_pictures);
  const StopSignals signals;
  settings.on_iteration = [&](const DesignIteration& iteration) {
    return recorder.iteration(iteration);
  };

  recorder.start(run);
  progress.start(fmt::format(
      "{} design parameters, {} motion unknowns; first the motion of the initial design ...",
      robot.space.size(), objective->layout().motion_size()));
  const CodesignResult result = codesign(*objective, robot.space, settings);
  progress.finish();
  const int signal = StopSignals::received();
  const bool usable =
      result.best.m.size() > 0 && result.best.m.allFinite() && std::isfinite(result.best.value);
  const PlanQuality quality = usable ? recorder.result(result.best) : PlanQuality{};
  const std::vector<std::string> reasons =
      infeasible_reasons(usable, quality, turning ? "rad/s" : "m/s");
  finish_run(run, status_text(result.status, signal), result, quality, progress.history(),
             recorder.seconds(), reasons, robot.space);
  recorder.end(run);
  write_json(folder.run_json(), run);

  if (options.json) fmt::print("{}", to_text(run));
  if (!options.json && !options.quiet) fmt::print("{}", optimize_summary(run, root));
  std::fflush(stdout);
  if (signal == 0) draw_rest(recorder.pictures(), options.quiet);
  return exit_code(signal, reasons);
}

}  // namespace

void add_optimize(CLI::App& program, Action& action) {
  const auto options = std::make_shared<OptimizeOptions>();
  CLI::App* verb =
      program.add_subcommand("optimize", "Co-design body and gait for a task; write a run folder");
  verb->add_option("TASK", options->task, "task file (TOML), which names its robot")->required();
  verb->add_option("-o,--output", options->run, "folder of the run; default: runs/ROBOT-TASK");
  verb->add_flag("--motion-only", options->motion_only,
                 "keep the initial design, optimize its motion");
  verb->add_option("--max-iterations", options->max_iterations, "design iterations at most")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
  verb->add_flag("--no-pictures", options->no_pictures, "no frame.png of the iterations");
  verb->add_flag("--force", options->force, "replace the run that the folder holds");
  verb->add_flag("--quiet", options->quiet, "say nothing but errors");
  verb->add_flag("--json", options->json, "print run.json instead of a summary");
  verb->callback([&action, options] { action = [options] { return optimize(*options); }; });
}

}  // namespace legwright
