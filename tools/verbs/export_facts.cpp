// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/export_facts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <vector>

#include "mjcf/propose/standing_pose.hpp"
#include "mjcf/read/world_parts.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/numbers.hpp"
#include "mjcf/text/safe_path.hpp"
#include "mjcf/write/home_ctrl.hpp"
#include "mjcf/write/keyframes.hpp"
#include "tools/files/checksum.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/files/shell_word.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/run/scene_sums.hpp"
#include "tools/run/task_folders.hpp"
#include "tools/verbs/whole_run.hpp"

namespace legwright {
namespace {

constexpr double kAsDrawn = 1e-5;  // [m], [rad]

namespace fs = std::filesystem;

std::string value_or_empty(const ByName<std::string>& list, const char* name) {
  const std::string* const found = list.find(name);
  return found != nullptr ? *found : "";
}

/// The last part of an absolute path: what is passed on tells nothing of its author's folders.
std::string without_folders(const std::string& word) {
  return fs::path(word).is_absolute() ? fs::path(word).filename().string() : word;
}

std::string command_of(const RunRecord& run) {
  std::string out;
  for (const std::string& word : run.argv)
    out +=
        out.empty() ? fs::path(word).filename().string() : " " + shell_word(without_folders(word));
  return out;
}

/// What a verdict.json says that it is of.
std::optional<JudgedSums> of_verdict(const Json& verdict) {
  if (!verdict.contains("of")) return std::nullopt;
  return record_of<ByName<std::string>>(verdict["of"], "result/verdict.json");
}

/// The verdict on the result in a verdict.json that others may have written; empty without.
/// @param standing to the run whose verdict it should be
std::string line_of(const Json& verdict, Standing standing) {
  if (standing == Standing::of_another) return std::string("result/verdict.json is ") + kOfAnother;
  const Json line = verdict.value("/result/line"_json_pointer, Json());
  if (!line.is_string()) return "";
  const std::string words = line.get<std::string>();
  return standing == Standing::of_this ? words : words + " (" + kWithoutSums + ")";
}

/// What was judged, for each task that was validated: a line, and the sum of the limits.
void add_verdicts(const fs::path& root, ExportFacts& facts) {
  std::vector<fs::path> folders{root};
  for (const TaskFolder& task : task_folders_of(root)) folders.push_back(root / task.relative);
  for (const fs::path& folder : folders) {
    const fs::path file = folder / "result" / "verdict.json";
    if (!fs::exists(file)) continue;
    const Json verdict = read_json(file);
    if (!verdict.is_object()) continue;
    const std::optional<JudgedSums> of = of_verdict(verdict);
    const Standing standing = standing_of(of, sums_of_run(folder));
    const std::string line = line_of(verdict, standing);
    if (line.empty()) continue;
    facts.verdicts.push_back(line);
    const std::string* const limits =
        standing == Standing::of_this ? of->find(kLimitsSum) : nullptr;
    if (limits != nullptr &&
        std::find(facts.limits.begin(), facts.limits.end(), *limits) == facts.limits.end())
      facts.limits.push_back(*limits);
  }
}

/// What MuJoCo said of the result as the search chose it; empty where it was not asked, or not
/// for each task of several.
std::string line_of_choice(const RunRecord& run) {
  if (run.physics_steps && run.physics_steps->changed) return run.physics_steps->after.line;
  for (const TaskRecord& task : run.tasks.value_or(std::vector<TaskRecord>{}))
    if (task.physics_steps && task.physics_steps->changed) return "";
  if (!run.choice) return "";
  for (const CandidateRecord& candidate : run.choice->candidates)
    if (candidate.name == run.result_name()) return candidate.played.line;
  return "";
}

/// A task from keywords has no file of its own.
std::string task_file_of(const RunRecord& run) {
  const std::string file = without_folders(value_or_empty(run.files, "task.toml"));
  return file == "<task>" ? "from keywords in Python: inputs/task.toml of the run" : file;
}

/// A robot without keyframe, which the longer or shorter legs of its design leave at another height
/// than the ground's as it is drawn, with that pose on the ground as its keyframe.
/// @param drawn gets where its feet are drawn, in words
RobotFiles with_drawn_pose(const RobotFiles& files, const fs::path& file, std::string& drawn) {
  const ModelPointer model = compile_mjcf(files.text(), file);
  if (model->nkey > 0) return files;
  const std::optional<StandingPose> pose = find_standing_pose(files.text(), file);
  if (!pose) return files;
  const std::optional<std::vector<double>> qpos = parse_numbers(pose->qpos);
  const int height = model->jnt_qposadr[model->body_jntadr[trunk_of(*model)]] + 2;
  for (int k = 0; k < static_cast<int>(model->nq); ++k)
    if (k != height && std::abs((*qpos)[static_cast<std::size_t>(k)] - model->qpos0[k]) > kAsDrawn)
      return files;  // another pose than the one that was planned from
  drawn = pose->why;
  return files.with_text(with_keyframe(files.text(), file, *pose));
}

}  // namespace

ExportedRun read_exported_run(const fs::path& root) {
  const ResultFolder folder = ResultFolder::open(root);
  ExportedRun out;
  out.run = read_record_file<RunRecord>(folder.run_json());
  out.sums = sums_of(root, out.run);
  const fs::path input = folder.inputs() / "robot.xml", result = folder.result() / "robot.xml";
  if (!fs::exists(result))
    throw IoError(result.string() +
                  ": no such file; the run has no result yet, finish `legwright " + "optimize`");
  out.before = read_robot(input);
  check_inputs(root, out.run, out.before.files);
  check_result_scenes(root, out.run);
  // What was a leg is one: a design may be read otherwise where it is borderline.
  const RobotFiles files = RobotFiles::read(result);
  check_assets(out.run, files);
  const LiftedKeyframes raised = with_lifted_keyframes(
      files.at_their_lines([&] { return parse_robot(files, &out.before.structure); }));
  out.lifted = raised.lifted;
  const RobotFiles standing = with_drawn_pose(raised.files, result, out.drawn);
  const RobotFiles held = with_home_ctrl(standing);
  out.after = files.at_their_lines([&] { return parse_robot(held, &out.before.structure); });
  out.holds_home = held.text() != standing.text();
  check_design(out.before, out.after, result);
  return out;
}

double friction_of(const RunRecord& run) {
  const double friction = run.task                           ? run.task->floor_friction
                          : run.tasks && !run.tasks->empty() ? run.tasks->front().floor_friction
                                                             : 1.0;
  return friction > 0.0 && friction <= 100.0 ? friction : 1.0;
}

namespace {

std::string why_it_sank(const StandingResult& stand) {
  if (stand.servos == 0)
    return " (none of its actuators is a position servo, so nothing holds that pose; the gait has "
           "torques of its own)";
  if (stand.commanded_elsewhere > 0)
    return fmt::format(
        " (in that pose {} of its servos are told another place, as by a keyframe home without "
        "ctrl; the gait has its own commands)",
        stand.commanded_elsewhere);
  return " (its servos are told that pose and give in: their gains or torques are too low for its "
         "weight, or its feet slip)";
}

}  // namespace

std::string describe(const StandingResult& stand) {
  std::string out = fmt::format(
      "Left to stand on the floor of scene.xml for {:.3g} s in its home pose: ", stand.seconds);
  if (stand.warnings.empty()) out += "no warning of the engine";
  for (std::size_t k = 0; k < stand.warnings.size(); ++k)
    out += fmt::format("{}{} ({} times, first at {:.3g} s)", k ? ", " : "", stand.warnings[k].text,
                       stand.warnings[k].count, stand.warnings[k].time);
  if (std::isfinite(stand.trunk_after))
    out += fmt::format("; its trunk's centre of mass went from {:.3f} to {:.3f} m",
                       stand.trunk_before, stand.trunk_after);
  if (stand.in_ground())
    out += fmt::format(" (it starts {:.3g} m deep in the ground)", stand.sunk_in);
  if (stand.flew() && stand.commanded_elsewhere > 0)
    out += fmt::format(
        " (it is thrown up to {:.3g} m: in that pose {} of its servos are told another place by "
        "the ctrl of its keyframe)",
        stand.highest, stand.commanded_elsewhere);
  else if (stand.flew())
    out += fmt::format(
        " (it is thrown up to {:.3g} m: that pose does not stand; give the robot's file a keyframe "
        "home in which its feet touch the ground and no links overlap)",
        stand.highest);
  else if (stand.sank())
    out += why_it_sank(stand);
  return out + ".";
}

ExportFacts facts_of(const ExportedRun& from, const fs::path& root, const std::string& name) {
  ExportFacts facts;
  facts.name = name;
  facts.model = from.after.morphology.name;
  facts.robot_file = without_folders(value_or_empty(from.run.files, "robot.xml"));
  facts.robot_sha256 = sha256_hex(from.before.files.main_text());
  facts.task_file = task_file_of(from.run);
  facts.task_sha256 = value_or_empty(from.run.sha256, "task.toml");
  facts.version = value_or_empty(from.run.versions, "legwright");
  facts.engine = value_or_empty(from.run.versions, "mujoco");
  for (const auto& [file, sum] : from.sums)
    if (file.ends_with("result/scene.xml")) facts.scenes.emplace_back(file, sum);
  facts.command = command_of(from.run);
  facts.status = from.run.status;
  for (int k = 0; k < from.before.space.size(); ++k) {
    const DesignParameter& p = from.before.space.parameters[k];
    facts.parameters.push_back(
        {p.name, p.unit, p.sentence, p.initial, from.after.space.parameters[k].initial});
  }
  facts.mass_before = from.before.morphology.total_mass();
  facts.mass_after = from.after.morphology.total_mass();
  add_verdicts(root, facts);
  facts.chosen_verdict = line_of_choice(from.run);
  if (from.run.task) facts.servo_kp = from.run.task->servo_kp;
  return facts;
}

std::vector<HomeTouch> home_touches(const ExportedRun& run) {
  return new_home_touches(*compile_mjcf(run.before.xml, run.before.file),
                          *compile_mjcf(run.after.xml, run.after.file), run.after.file);
}

}  // namespace legwright
