// SPDX-License-Identifier: Apache-2.0
// What the studio does in processes of its own: judge, optimize, report, export.
#include <fmt/format.h>

#include "mjcf/text/input_error.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/files/json_values.hpp"
#include "tools/studio/session_names.hpp"
#include "tools/studio/studio_service.hpp"
#include "tools/studio/verdict_lines.hpp"
#include "tools/task/task_text.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// A run that was saved for a piece of work alone, and goes with it.
class PassingRun {
 public:
  explicit PassingRun(fs::path folder) : folder_(std::move(folder)) {}
  ~PassingRun() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  PassingRun(const PassingRun&) = delete;
  PassingRun& operator=(const PassingRun&) = delete;
  const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
};

/// The task file of a state whose body is that of `robot` beside it: with the state's weights and
/// bounds, what is locked frozen, and the body that was given to begin with.
std::string text_from_here(const SessionState& state, const std::string& robot) {
  const TaskSet& set = state.problem->set;
  std::string frozen, bounds, given;
  for (int k = 0; k < state.s().size(); ++k) {
    const auto at = static_cast<std::size_t>(k);
    const std::string name = to_line(Json(state.problem->robot.space.parameters[at].name));
    if (state.frozen[at])
      frozen += (frozen.empty() ? "" : ", ") + name;
    else
      bounds += fmt::format("{}{} = [{}, {}]", bounds.empty() ? "" : ", ", name, state.lower[k],
                            state.upper[k]);
    if (state.given[k] != state.s()[k])
      given += fmt::format("{}{} = {}", given.empty() ? "" : ", ", name, state.given[k]);
  }
  std::string text = set.joint() ? with_weights(set.text, state.weights) : set.text;
  text = with_key(text, {"robot"}, to_line(Json(robot)));
  text = with_key(text, {"design", "freeze"}, "[" + frozen + "]");
  text = with_key(text, {"design", "bounds"}, "{ " + bounds + " }");
  return with_key(text, {"design", "given"}, "{ " + given + " }");
}

/// What a page tells of a path: the folder that it is in, and its name.
std::string short_path(const fs::path& path) {
  return (path.parent_path().filename() / path.filename()).string();
}

/// What a verdict is of.
Json judged_json(const SessionState& state) {
  return {{"s", std::vector<double>(state.s().begin(), state.s().end())},
          {"task_text", state.problem->set.text}};
}

}  // namespace

fs::path StudioService::scratch(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  if (!folder_) throw InputError("nothing is open; open a robot, a task file or a run first");
  return folder_->path() / name;
}

void StudioService::save(const SessionRecord& record, const fs::path& run, bool force) const {
  SavedFrom from;
  {
    const std::lock_guard lock(mutex_);
    from = {opened_.origin, opened_.robot_file};
  }
  options_.save(record, run, force, from);
}

/// A run's verdict at three gains, written into it.
void StudioService::play(JobRunner& job, const fs::path& run) const {
  job.run("playing", {options_.program.string(), "validate", run.string(), "--quick", "--progress"},
          1);
}

/// The same where the work is of worth without it.
void StudioService::play_if_it_goes(JobRunner& job, const fs::path& run) {
  try {
    play(job, run);
  } catch (const std::exception& error) {
    if (!job.cancelled()) hub_.notice("warning", fmt::format("Not judged: {}", error.what()));
  }
}

/// Saves what stands now, plays it at three gains in a process of its own, and tells the verdict.
Json StudioService::post_judge(const StudioRequest&) {
  const auto space = workspace();
  const fs::path folder = scratch("judged");
  auto record = std::make_shared<SessionRecord>(space->session().record());
  judge_.start("judge", [this, folder, record](JobRunner& job) {
    const PassingRun run(folder);
    job.tell({{"words", "saving"}, {"done", 0}, {"of", 0}, {"lines", Json::array()}}, true);
    save(*record, run.folder(), true);
    play(job, run.folder());
    Json told = verdict_lines(run.folder());
    note_verdict(*record->state, told["verdict"]["word"]);
    told["judged"] = judged_json(*record->state);
    told["done"] = told["of"] = 1;
    job.tell(std::move(told), false);
  });
  return Json::object();
}

void StudioService::tell_verdict_of(const fs::path& run) {
  Json told;
  try {
    told = verdict_lines(run);
  } catch (const std::exception&) {
    return;  // nobody judged it, or only some of its tasks
  }
  if (told["verdict"]["word"] == kUnknownVerdict) return;
  const StatePointer state = workspace()->session().snapshot()->state;
  note_verdict(*state, told["verdict"]["word"]);
  told["judged"] = judged_json(*state);
  told["what"] = "judge";
  told["running"] = false;
  hub_.publish("judge", to_line(told));
}

void StudioService::note_verdict(const SessionState& state, const std::string& word) {
  const std::lock_guard lock(mutex_);
  std::erase_if(judged_, [](const Judged& each) { return each.problem.expired(); });
  judged_.push_back({state.s(), state.problem, word});
}

Json StudioService::verdict_on(const SessionState& state) const {
  const std::lock_guard lock(mutex_);
  for (auto each = judged_.rbegin(); each != judged_.rend(); ++each)
    if (each->s == state.s() && each->problem.lock() == state.problem) return each->word;
  return nullptr;
}

std::string StudioService::label() const {
  const std::lock_guard lock(mutex_);
  return opened_.label;
}

Json StudioService::delete_judge(const StudioRequest&) {
  judge_.cancel();
  return Json::object();
}

/// `optimize` from the body that stands, which plays what it finds and hands back what passes: a
/// run of its own. The session stays as it is, whose motions are those of the task as written.
Json StudioService::post_optimize(const StudioRequest& request) {
  const auto space = workspace();
  const fs::path path = paths_.to_write(needed<std::string>(request.body, "path"));
  if (fs::exists(path)) throw InputError(path.string() + ": exists already; name a new folder");
  const fs::path folder = scratch("asked");
  const std::string name = session_name(label(), path), robot = plain_name(label()) + ".xml";
  auto record = std::make_shared<SessionRecord>(space->session().record());
  jobs_.start("optimize", [this, path, folder, record, name, robot](JobRunner& job) {
    const PassingRun run(folder);
    save(*record, run.folder(), true);
    const fs::path result = run.folder() / "result", task = result / "task.toml";
    fs::copy_file(result / "robot.xml", result / robot, fs::copy_options::skip_existing);
    write_file(task, text_from_here(*record->state, robot));
    const bool passes = job.run("searching, with MuJoCo's verdicts",
                                {options_.program.string(), "optimize", task.string(), "-o",
                                 path.string(), "--no-pictures", "--no-reasons", "--progress"},
                                1);
    kept_.note_recent(path, name);
    if (passes) play_if_it_goes(job, path);  // its own verdict, for its report and export
    job.tell({{"words", "written"}, {"path", path.string()}, {"passes", passes}}, false);
    hub_.notice(passes ? "done" : "error",
                fmt::format("{} Its folder: {}",
                            passes ? "One that MuJoCo passes was found: open it under Verdict."
                                   : "No body was found that passes; the best one was kept.",
                            short_path(path)));
  });
  return {{"path", path.string()}};
}

Json StudioService::delete_job(const StudioRequest&) {
  jobs_.cancel();
  return Json::object();
}

/// Saves a run, validates it and draws it, so that its report has all that reports have.
Json StudioService::post_report(const StudioRequest& request) {
  const auto space = workspace();
  const fs::path path = paths_.to_write(needed<std::string>(request.body, "path"));
  const bool saved = stands_in(path);
  if (!saved && fs::exists(path / "run.json"))
    throw InputError(path.string() +
                     ": holds another state than what stands; save that there first, in its place, "
                     "or name a new folder");
  auto record = std::make_shared<SessionRecord>(space->session().record());
  jobs_.start("report", [this, path, record, saved](JobRunner& job) {
    const std::string program = options_.program.string();
    if (!saved) save(*record, path, false);
    play(job, path);
    job.run("drawing", {program, "render", path.string()});
    job.run("writing the report", {program, "report", path.string()});
    job.tell({{"words", "written"}, {"path", (path / "report.html").string()}}, false);
    hub_.notice("done", "The report is written: " + short_path(path / "report.html"));
  });
  return {{"path", (path / "report.html").string()}};
}

/// The robot and its gait for stock MuJoCo, in a new folder: of what stands, judged for it, or of a
/// run as it is.
Json StudioService::post_export(const StudioRequest& request) {
  const auto space = workspace();
  const auto run_asked = given_or<std::string>(request.body, "run", "");
  const fs::path as_it_is = run_asked.empty() ? fs::path() : paths_.to_read(run_asked);
  const fs::path path = paths_.to_write(needed<std::string>(request.body, "path"));
  if (fs::exists(path)) throw InputError(path.string() + ": exists already; name a new folder");
  const fs::path folder = scratch("exported");
  auto record = std::make_shared<SessionRecord>(space->session().record());
  jobs_.start("export", [this, path, folder, record, as_it_is](JobRunner& job) {
    const PassingRun run(folder);
    if (as_it_is.empty()) {
      save(*record, run.folder(), true);
      play_if_it_goes(job, run.folder());
    }
    const fs::path& from = as_it_is.empty() ? run.folder() : as_it_is;
    job.run("exporting", {options_.program.string(), "export", from.string(), "-o", path.string()},
            1);
    job.tell({{"words", "written"}, {"path", path.string()}}, false);
    hub_.notice("done", "Exported: " + short_path(path));
  });
  return {{"path", path.string()}};
}

}  // namespace legwright
