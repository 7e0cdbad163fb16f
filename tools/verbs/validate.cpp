// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include "mjcf/text/input_error.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/files/io_error.hpp"
#include "tools/run/joined_by_and.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/validate/limits_file.hpp"
#include "tools/validate/robustness_limits.hpp"
#include "tools/verbs/judge_run.hpp"
#include "tools/verbs/junit_file.hpp"
#include "tools/verbs/matrix_table.hpp"
#include "tools/verbs/number_options.hpp"
#include "tools/verbs/progress.hpp"
#include "tools/verbs/python_module.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

struct ValidateOptions : ReadingOptions {
  std::string run, limits, junit;
  std::string engine = "mujoco";
  JudgeOptions judge;
  bool json = false, quick = false, progress = false;
};

/// Read before anything is played: a damaged file must not cost the roll-outs. Throws InputError.
RunRecord read_run_record(const ResultFolder& folder) {
  try {
    return read_record_file<RunRecord>(folder.run_json());
  } catch (const IoError& error) {
    throw InputError(error.what());
  }
}

/// Tells on stderr from the first moment what is done and how far it is: one live line on a
/// terminal, none elsewhere; or a line for each step, for programs.
ProgressListener live_progress(bool lines) {
  if (lines) return print_progress;
  if (::isatty(STDERR_FILENO) == 0) return {};
  return [](const std::string& stage, int done, int total) {
    if (done == total)
      fmt::print(stderr, "\r\x1b[K");
    else
      fmt::print(stderr, "\r\x1b[K{}: {:3} %", stage, 100 * done / total);
    std::fflush(stderr);
  };
}

/// "stability: a cycle multiplies small disturbances by 0.31 at half, …": of the gains at which
/// it was measured.
void print_stability(const JudgedRun& judged, const std::string& indent) {
  std::vector<std::string> parts;
  bool grows = false;
  for (const Measurements& run : judged.designs[1].at_gains)
    if (run.floquet_multiplier) {
      parts.push_back(
          fmt::format("{:.2f} at {}", *run.floquet_multiplier, gain_name(run.gain_scale)));
      grows = grows || *run.floquet_multiplier >= 1.0;
    }
  if (parts.empty()) return;
  fmt::print("{}stability: a cycle multiplies small disturbances by {} gains{}\n", indent,
             joined_by_and(parts), grows ? "; from 1 on they grow" : "");
}

/// That the gait was played on servos which the robot's file does not have.
void print_servos(const TaskRecord& task, const std::string& indent) {
  if (task.servo_kp)
    fmt::print(
        "{}servos:             softer ones than {} N m/rad played so stiff, as far as their torque "
        "limits bear it ([servos] of the task)\n",
        indent, *task.servo_kp);
}

void print_judged(const JudgedRun& judged, bool same, const std::string& indent) {
  fmt::print("{0}initial design:     {1}\n{0}{2}  {3}\n", indent, judged.designs[0].verdict.line,
             same ? "the same, as result:" : "co-designed robot:", judged.designs[1].verdict.line);
  if (!same && judged.designs[0].verdict.pass && !judged.designs[1].verdict.pass)
    fmt::print(
        "{}the body as it was passes, the designed one does not: a lower F promises no steadier "
        "gait; try --starts,\n{}--physics-steps, or fewer free parameters ([design] freeze)\n",
        indent, indent);
  if (!judged.home_touches.empty())
    fmt::print("{}warning: {}\n", indent, terminal_text(describe(judged.home_touches)));
  if (judged.verdict.never_touch)
    fmt::print("{}{}\n", indent, terminal_text(judged.verdict.never_touch->line));
  if (!judged.overridden.empty())
    fmt::print("{}{}\n", indent, describe_overridden(judged.overridden));
  if (const auto& comparison = judged.designs[1].comparison)
    fmt::print("{}{}\n", indent, describe(*comparison));
  if (judged.verdict.not_judged)
    fmt::print("{}warning: {}\n", indent, judged.verdict.not_judged->line);
  if (judged.verdict.run_status)
    fmt::print("{}warning: {}\n", indent, early_stop_words(*judged.verdict.run_status));
  if (judged.numerics) fmt::print("{}{}\n", indent, describe(*judged.numerics));
  print_stability(judged, indent);
  if (!judged.robustness) return;
  fmt::print(
      "{}robustness, each factor alone until it falls, or goes at less than half or more than "
      "twice its speed:\n",
      indent);
  for (const std::string& line : robustness_lines(*judged.robustness))
    fmt::print("{}  {}\n", indent, line);
}

/// What a run is called where its verdict stands beside others.
std::string suite_of(const fs::path& run) {
  const fs::path whole = fs::absolute(run).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

/// Where other numerics and limits on margins, which are asked of the common body alone, change its
/// verdict.
std::string common_body_words(const MatrixRecord& matrix, const std::vector<JudgedRun>& judged,
                              const RunRecord& run) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < judged.size(); ++k)
    if (judged[k].verdict_at_gains.pass != judged[k].designs[1].verdict.pass)
      names.push_back((*run.tasks)[k].name);
  return names.empty() ? ""
                       : fmt::format("with all that was asked the body for all tasks {}: {}\n",
                                     matrix.pass ? "passes" : "fails", joined_by_and(names));
}

int validate_joint(const ResultFolder& folder, const RunRecord& run, JunitFile& junit,
                   const ValidateOptions& options) {
  std::vector<JudgedRun> judged;
  const MatrixRecord matrix = judge_joint_run(folder, run, options.judge, judged);
  std::vector<JunitSuite> suites;
  for (std::size_t k = 0; k < judged.size(); ++k)
    suites.push_back(
        {junit.suite() + "." + (*run.tasks)[k].name, judged[k].designs[1].verdict, judged[k].of});
  junit.write(suites);
  if (options.json) {
    fmt::print("{}", to_text(json_of(matrix)));
  } else {
    for (std::size_t k = 0; k < judged.size(); ++k) {
      fmt::print("{}\n", (*run.tasks)[k].name);
      print_servos((*run.tasks)[k], "  ");
      print_judged(judged[k], run.motion_only, "  ");
    }
    fmt::print("{}{}", matrix_table(matrix), common_body_words(matrix, judged, run));
  }
  return matrix.pass ? kOk : kInfeasible;
}

/// Throws InputError where the limits file asks for what --quick leaves out.
void refuse_if_too_quick(const ValidateOptions& options) {
  const Limits& limits = options.judge.validation.limits;
  const bool robustness = need_robustness(limits), numerics = ask_for_numerics(limits);
  if (!options.quick || (!robustness && !numerics)) return;
  const std::string what = robustness && numerics ? "survival, margins or numerics"
                           : robustness           ? "survival or margins"
                                                  : "numerics";
  throw InputError(options.limits, 0, "",
                   "has limits on " + what +
                       ", which --quick leaves out; validate without --quick, or take them out");
}

/// In another engine. Throws InputError for what only MuJoCo's validation has.
int validate_elsewhere(const ValidateOptions& options) {
  for (const auto& [given, name] :
       {std::pair{options.quick, "--quick"}, {!options.junit.empty(), "--junit"}})
    if (given)
      throw InputError(
          fmt::format("{} is for MuJoCo's validation, not for --engine {}: leave one "
                      "of them out",
                      name, options.engine));
  (void)ResultFolder::open(options.run);
  options.check_run(options.run);
  std::vector<std::string> words{options.run, "--cycles",
                                 std::to_string(options.judge.validation.cycles)};
  if (!options.limits.empty()) words.insert(words.end(), {"--limits", options.limits});
  if (options.json) words.emplace_back("--json");
  return run_python_module(drake_part(), words);
}

/// Why a run cannot be written into; empty where it can.
std::string unwritable(const ResultFolder& folder) {
  std::vector<fs::path> written{folder.root(), folder.result()};
  std::error_code error;
  for (const auto& task : fs::directory_iterator(folder.root() / "tasks", error))
    written.insert(written.end(), {task.path(), task.path() / "result"});
  for (const fs::path& path : written)
    if (::access(path.c_str(), W_OK) != 0 && errno != ENOENT)
      return std::generic_category().message(errno);
  return "";
}

/// The run: to write into, or, where that cannot be, as on a medium to read from, to read.
ResultFolder run_to_judge(const ValidateOptions& options, bool& write) {
  ResultFolder folder = ResultFolder::open(options.run);
  const std::string why = unwritable(folder);
  write = why.empty();
  if (write) return ResultFolder::open_to_write(options.run);
  fmt::print(stderr,
             "legwright: warning: {} cannot be written ({}): the verdict is told, no file of it "
             "goes there\n",
             terminal_text(options.run), why);
  return folder;
}

/// Throws InputError where the margin of the floor's friction is on the wrong side of a task's.
void check_friction_margins(const ValidateOptions& options, const RunRecord& run) {
  std::vector<TaskRecord> tasks = run.tasks.value_or(std::vector<TaskRecord>{});
  if (run.task) tasks.push_back(*run.task);
  for (const TaskRecord& task : tasks)
    check_friction_margin(options.judge.validation.limits, options.limits, task.floor_friction);
}

int validate_here(ValidateOptions options, JunitFile& junit) {
  if (!options.limits.empty()) options.judge.validation.limits = read_limits(options.limits);
  refuse_if_too_quick(options);
  options.judge.numerics = options.judge.robustness = options.judge.stability = !options.quick;
  options.judge.validation.progress = live_progress(options.progress);
  const ResultFolder folder = run_to_judge(options, options.judge.write);
  options.check_run(options.run);
  const RunRecord run = read_run_record(folder);
  check_friction_margins(options, run);
  if (run.joint()) return validate_joint(folder, run, junit, options);
  const JudgedRun judged = judge_run(folder, options.judge);
  const Verdict& verdict = judged.designs[1].verdict;
  junit.write({{junit.suite(), verdict, judged.of}});
  if (options.json) {
    Json document{{"verdict", json_of(judged.verdict)}, {"metrics", json_of(judged.metrics)}};
    if (const auto record = judged.robustness_record()) document["robustness"] = json_of(*record);
    if (const auto record = judged.numerics_record()) document["numerics"] = json_of(*record);
    fmt::print("{}", to_text(document));
  } else {
    if (run.task) print_servos(*run.task, "");
    print_judged(judged, run.motion_only, "");
  }
  return verdict.pass ? kOk : kInfeasible;
}

int validate(const ValidateOptions& options) {
  if (options.engine != "mujoco") return validate_elsewhere(options);
  JunitFile junit(options.junit, suite_of(options.run));
  try {
    return validate_here(options, junit);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    junit.write_error(error.what());
    throw;
  }
}

void add_options(CLI::App& verb, ValidateOptions& options) {
  JudgeOptions& judge = options.judge;
  verb.add_option("run", options.run, "Folder that legwright optimize wrote")->required();
  verb.add_option("--engine", options.engine,
                  "Physics engine that plays the result: mujoco, or drake, a second engine, in the "
                  "Python of LEGWRIGHT_PYTHON or python3")
      ->check(CLI::IsMember({"mujoco", "drake"}))
      ->capture_default_str();
  verb.add_option("--limits", options.limits,
                  "TOML file of what passes; examples/limits.toml has all that may be limited");
  verb.add_option("--junit", options.junit,
                  "Write the verdict as JUnit XML, a case per limit; an error where there is none");
  verb.add_flag(
      "--quick", options.quick,
      "Only the roll-outs at three gains: no disturbances, no second opinion on numerics, no "
      "stability; what an earlier validate wrote of these in the run goes away");
  verb.add_option("--cycles", judge.validation.cycles, "Cycles of the gait to play")
      ->check(CLI::Range(4, 10000))
      ->capture_default_str();
  verb.add_option("--samples", judge.disturbed.samples,
                  "Walks with all disturbances drawn at once; 0: margins only")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
  verb.add_option("--seed", judge.disturbed.seed, "Of those draws")
      ->check(seed_number())
      ->capture_default_str();
  verb.add_option("--threads", judge.validation.threads,
                  "Roll-outs at the same time; results do not depend on it; default: all cores")
      ->check(CLI::Range(1, 64));
  verb.add_flag("--progress", options.progress,
                "Tell what is done as lines of JSON on stderr, for programs");
  verb.add_flag("--json", options.json,
                "One JSON document on stdout: verdict, metrics, robustness, numerics");
}

}  // namespace

void add_validate(CLI::App& program, Action& action) {
  const auto [verb, options] = add_verb(
      program, action, "validate", "Play the gaits of a run in MuJoCo and judge them", validate);
  options->judge.validation.threads =
      static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 64U));
  add_options(*verb, *options);
  verb->footer(
      "Plays iterations/0000/scene.xml (the initial design) and result/scene.xml, each at half, "
      "default and double\n"
      "servo gains, headless. Unless a limits file says otherwise the result passes when at all "
      "gains it never falls,\n"
      "keeps 95 to 105 % of the planned speed along its heading, of the turn rate and of the "
      "radius where it turns,\n"
      "keeps its heading within 0.01 rad a cycle and its straight or arc within 10 % of the way, "
      "tilts by less than\n"
      "0.1 rad, touches itself for at most 1 % of the time and 1 mm, has a servo at its limit for "
      "less than 0.1 % of it,\n"
      "MuJoCo has nothing to warn of, and other numerics agree.\n"
      "Then one disturbance after the other grows until the result fails: friction and slope of "
      "the floor, how soft it\n"
      "is, mass, gains and delay of the servos, a tilted start, pushes; and 200 walks have them "
      "all at once "
      "(tools/validate/README.md).\n"
      "Writes metrics.json, verdict.json, comparison.json, numerics.json, robustness.json, "
      "playback_initial.csv and\n"
      "playback_result.csv into result/, unless that cannot be written: then the verdict is told "
      "alone.\n"
      "--engine drake plays the result alone, at the same gains, with the same measures and "
      "limits, "
      "and writes\n"
      "validation_drake.json into result/ (docs/findings/second_engine.md).\n"
      "Exit code: 0 the result passes, 1 it fails, 2 bad input, 3 a file cannot be read or "
      "written.");
}

}  // namespace legwright
