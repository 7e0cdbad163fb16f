// SPDX-License-Identifier: Apache-2.0
#include "tools/viewer/follow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <system_error>

#include "tools/run/iteration_record.hpp"
#include "tools/run/run_lock.hpp"
#include "tools/run/run_record.hpp"
#include "tools/run/task_folders.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr const char* kScene = "scene.xml";

std::vector<fs::path> entries(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    found.push_back(entry->path());
  return found;
}

/// 0007, not .0007.tmp: a design has its number when it is whole.
bool is_number(const std::string& name) {
  return !name.empty() &&
         std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::string name_of(const fs::path& folder) {
  std::string number = folder.filename().string();
  if (!is_number(number)) return number == "result" ? number : "";
  number.erase(0, std::min(number.find_first_not_of('0'), number.size() - 1));
  const fs::path start = folder.parent_path().parent_path().parent_path();  // of a joint run
  const bool joint = start.parent_path().filename() == "starts";
  return joint ? fmt::format("iteration {} {}", number, start.filename().string())
               : "iteration " + number;
}

/// The record of a file; none where the file is not there, not written yet or another one.
template <class R>
std::optional<R> read_or_nothing(const fs::path& file) {
  try {
    return read_record_file<R>(file);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

bool has_ended(const fs::path& folder) {
  const auto run = read_or_nothing<RunRecord>(folder / "run.json");
  return run && run->status != "running";
}

fs::path without_slash(fs::path folder) {
  folder = folder.lexically_normal();
  return folder.has_filename() ? folder : folder.parent_path();
}

}  // namespace

WrittenDesign design_at(const fs::path& scene) {
  return {scene, name_of(fs::absolute(scene).parent_path()), false};
}

std::vector<Fact> facts_of(const WrittenDesign& design) {
  if (design.name.empty()) return {};
  std::vector<Fact> facts{{"design", design.name}};
  const auto metrics =
      read_or_nothing<IterationMetrics>(design.scene.parent_path() / "metrics.json");
  if (!metrics) return facts;
  if (std::isfinite(metrics->F + metrics->J))
    facts.push_back({"cost", fmt::format("{:.4g}", metrics->F + metrics->J)});
  if (metrics->speed_wanted > 0.0)
    facts.push_back(
        {"planned speed", fmt::format("{:.0f} % of wanted",
                                      100.0 * metrics->speed_reached / metrics->speed_wanted)});
  return facts;
}

RunFollower::RunFollower(fs::path run) : run_(without_slash(std::move(run))) {}

fs::path RunFollower::watched() const {
  const bool task = run_.parent_path().filename() == "tasks";
  const fs::path whole = task ? run_.parent_path().parent_path() : run_;
  const auto build = build_beside(whole.empty() ? "." : whole);
  if (!build) return run_;
  return task ? *build / "tasks" / run_.filename() : *build;
}

std::vector<fs::path> RunFollower::places(const fs::path& run) {
  const fs::path tasks = run.parent_path();
  if (tasks.filename() != "tasks") return {run / "iterations"};
  std::vector<fs::path> found;
  for (const fs::path& start : entries(tasks.parent_path() / "starts"))
    found.push_back(start / run.filename() / "iterations");
  // The run's own iterations are copies of those, made at the end.
  return found.empty() ? std::vector{run / "iterations"} : found;
}

std::optional<RunFollower::Candidate> RunFollower::newest(const fs::path& run) {
  std::optional<Candidate> best;
  for (const fs::path& place : places(run))
    for (const fs::path& folder : entries(place)) {
      std::error_code error;
      const auto written_at = fs::last_write_time(folder / kScene, error);
      if (error || !is_number(folder.filename().string())) continue;
      const Candidate candidate{written_at, folder};
      if (!best || candidate > *best) best = candidate;
    }
  return best;
}

std::optional<WrittenDesign> RunFollower::next() {
  const fs::path run = watched();
  ended_ = run == run_ && has_ended(run);
  std::error_code error;
  const fs::path result = run / "result";
  const auto written_at = fs::last_write_time(result / kScene, error);
  const bool found = ended_ && !error;
  const std::optional<Candidate> best = found ? Candidate{written_at, result} : newest(run);
  if (!best || best == shown_) return std::nullopt;
  shown_ = best;
  return WrittenDesign{best->folder / kScene, name_of(best->folder), found};
}

std::string RunFollower::waiting() const {
  if (shown_) return "";
  std::string text = "waiting for the first design of " + run_.string();
  try {
    for (const TaskFolder& task : task_folders_of(run_))
      text += "\n  a joint run: follow one of its tasks instead, legwright play --live " +
              (run_ / task.relative).string();
  } catch (const std::exception&) {  // no run yet
  }
  return text;
}

}  // namespace legwright
