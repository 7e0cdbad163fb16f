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

WhatStands StudioService::standing() const {
  std::shared_ptr<Workspace> space;
  WhatStands out;
  {
    const std::lock_guard lock(mutex_);
    space = workspace_;
    out.from = {opened_.origin, opened_.robot_file};
    out.label = opened_.label;
  }
  if (!space) throw InputError("nothing is open; open a robot, a task file or a run first");
  out.record = space->session().record();
  return out;
}

void StudioService::save(const WhatStands& what, const fs::path& run, bool force) const {
  options_.save(what.record, run, force, what.from);
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
  const auto now = std::make_shared<const WhatStands>(standing());
  judge_.start("judge", [this, now](JobRunner& job) {
    const auto work = kept_.begin_work("judged");
    const fs::path run = work->path() / "run";
    job.tell({{"words", "saving"}, {"done", 0}, {"of", 0}, {"lines", Json::array()}}, true);
    save(*now, run, true);
    play(job, run);
    Json told = verdict_lines(run);
    note_verdict(*now->record.state, told["verdict"]["word"]);
    told["judged"] = judged_json(*now->record.state);
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

Json StudioService::delete_judge(const StudioRequest&) {
  judge_.cancel();
  return Json::object();
}

/// `optimize` from the body that stands, which plays what it finds and hands back what passes: a
/// run of its own. The session stays as it is, whose motions are those of the task as written.
Json StudioService::post_optimize(const StudioRequest& request) {
  const fs::path path = paths_.to_write(needed<std::string>(request.body, "path"));
  if (fs::exists(path)) throw InputError(path.string() + ": exists already; name a new folder");
  const auto now = std::make_shared<const WhatStands>(standing());
  jobs_.start("optimize", [this, path, now](JobRunner& job) {
    const auto work = kept_.begin_work("asked");
    save(*now, work->path() / "run", true);
    const fs::path result = work->path() / "run" / "result", task = result / "task.toml";
    const std::string robot = plain_name(now->label) + ".xml";
    fs::copy_file(result / "robot.xml", result / robot, fs::copy_options::skip_existing);
    write_file(task, text_from_here(*now->record.state, robot));
    const bool passes = job.run("searching, with MuJoCo's verdicts",
                                {options_.program.string(), "optimize", task.string(), "-o",
                                 path.string(), "--no-pictures", "--no-reasons", "--progress"},
                                1);
    kept_.note_recent(path, session_name(now->label, path));
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
  const fs::path path = paths_.to_write(needed<std::string>(request.body, "path"));
  const bool saved = stands_in(path);
  if (!saved && fs::exists(path / "run.json"))
    throw InputError(path.string() +
                     ": holds another state than what stands; save that there first, in its place, "
                     "or name a new folder");
  const auto now = std::make_shared<const WhatStands>(standing());
  jobs_.start("report", [this, path, now, saved](JobRunner& job) {
    const std::string program = options_.program.string();
    if (!saved) save(*now, path, false);
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
  const auto run_asked = given_or<std::string>(request.body, "run", "");
  const fs::path as_it_is = run_asked.empty() ? fs::path() : paths_.to_read(run_asked);
  const fs::path path = paths_.to_write(needed<std::string>(request.body, "path"));
  if (fs::exists(path)) throw InputError(path.string() + ": exists already; name a new folder");
  const auto now = std::make_shared<const WhatStands>(standing());
  jobs_.start("export", [this, path, now, as_it_is](JobRunner& job) {
    const auto work = kept_.begin_work("exported");
    const fs::path from = as_it_is.empty() ? work->path() / "run" : as_it_is;
    if (as_it_is.empty()) {
      save(*now, from, true);
      play_if_it_goes(job, from);
    }
    job.run("exporting", {options_.program.string(), "export", from.string(), "-o", path.string()},
            1);
    job.tell({{"words", "written"}, {"path", path.string()}}, false);
    hub_.notice("done", "Exported: " + short_path(path));
  });
  return {{"path", path.string()}};
}

}  // namespace legwright
