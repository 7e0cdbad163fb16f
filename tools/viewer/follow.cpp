// SPDX-License-Identifier: Apache-2.0
#include "tools/viewer/follow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <system_error>

#include "tools/run/iteration_record.hpp"
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

fs::path without_slash(fs::path folder) {
  folder = folder.lexically_normal();
  return folder.has_filename() ? folder : folder.parent_path();
}

}  // namespace

LandedDesign design_at(const fs::path& scene) {
  return {scene, name_of(fs::absolute(scene).parent_path()), false};
}

std::vector<Fact> facts_of(const LandedDesign& design) {
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

std::vector<fs::path> RunFollower::places() const {
  const fs::path tasks = run_.parent_path();
  if (tasks.filename() != "tasks") return {run_ / "iterations"};
  std::vector<fs::path> found;
  for (const fs::path& start : entries(tasks.parent_path() / "starts"))
    found.push_back(start / run_.filename() / "iterations");
  // The run's own iterations are copies of those, made at the end.
  return found.empty() ? std::vector{run_ / "iterations"} : found;
}

std::optional<RunFollower::Candidate> RunFollower::newest() const {
  std::optional<Candidate> best;
  for (const fs::path& place : places())
    for (const fs::path& folder : entries(place)) {
      std::error_code error;
      const auto landed = fs::last_write_time(folder / kScene, error);
      if (error || !is_number(folder.filename().string())) continue;
      const Candidate candidate{landed, folder};
      if (!best || candidate > *best) best = candidate;
    }
  return best;
}

bool RunFollower::run_has_ended() const {
  const auto run = read_or_nothing<RunRecord>(run_ / "run.json");
  return run && run->status != "running";
}

std::optional<LandedDesign> RunFollower::next() {
  ended_ = run_has_ended();
  std::error_code error;
  const fs::path result = run_ / "result";
  const auto landed = fs::last_write_time(result / kScene, error);
  const bool found = ended_ && !error;
  const std::optional<Candidate> best = found ? Candidate{landed, result} : newest();
  if (!best || best == shown_) return std::nullopt;
  shown_ = best;
  return LandedDesign{best->folder / kScene, name_of(best->folder), found};
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
