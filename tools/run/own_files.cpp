// SPDX-License-Identifier: Apache-2.0
#include "tools/run/own_files.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "mjcf/text/robot_files.hpp"
#include "tools/files/licence.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/run/run_record.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// What the program writes below the parts of a run, besides the robot's files.
const std::set<std::string, std::less<>> kNames{
    "run.json",        "events.jsonl",         "report.html",  "robot.xml",       "scene.xml",
    "motion.csv",      "metrics.json",         "frame.png",    "task.toml",       "limits.toml",
    "session.jsonl",   "certificate.json",     "verdict.json", "comparison.json", "numerics.json",
    "robustness.json", "matrix.json",          "front.json",   "summary.md",      "overlay.png",
    "gait.webp",       "contact_timeline.png", "small.webp",   "begin.json",      "states.bin",
    "strength.json",   kTightenedTask};
constexpr std::array kHeads{"strip_", "still_", "playback_", "validation_", "compare_"};

bool is_left_over(const std::string& name) {
  return name == ".lock" || name == ".legwright-probe" ||
         (name.starts_with('.') && name.ends_with(".tmp")) || name.starts_with(".result-");
}

}  // namespace

bool is_name_of_runs(const std::string& name) {
  return kNames.contains(name) || is_left_over(name) ||
         std::any_of(kHeads.begin(), kHeads.end(),
                     [&](const char* head) { return name.starts_with(head); });
}

namespace {

/// Paths of the files of a run's robot below its folder, and its licences; none where they cannot
/// be told.
std::optional<std::set<fs::path>> robot_files(const fs::path& run) {
  std::set<fs::path> out;
  try {
    for (const char* folder : {"inputs", "result"}) {
      const fs::path robot = run / folder / "robot.xml";
      if (std::string(folder) != "inputs" && !fs::exists(robot)) continue;
      const RobotFiles files = RobotFiles::read(robot);
      for (const IncludedFile& part : files.includes()) out.insert(part.path);
      for (const AssetFile& asset : files.assets()) out.insert(asset.path);
    }
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    return std::nullopt;
  }
  for (const std::string& licence : licences_in(run / "inputs")) out.insert(licence);
  return out;
}

/// Whether a path ends in one of a robot's: its files stand in the folder of every design.
bool is_of_robot(const fs::path& relative, const std::set<fs::path>& robot) {
  fs::path rest = relative;
  while (!rest.empty()) {
    if (robot.contains(rest)) return true;
    rest = rest.lexically_relative(*rest.begin());
    if (rest == ".") break;
  }
  return false;
}

void add_below(const fs::path& run, const fs::path& part, const std::set<fs::path>& robot,
               std::vector<std::string>& own) {
  for (auto at = fs::recursive_directory_iterator(run / part);
       at != fs::recursive_directory_iterator(); ++at) {
    const std::string name = at->path().filename().string();
    if (at->is_directory() && !at->is_symlink()) {
      if (is_left_over(name)) at.disable_recursion_pending();
      continue;
    }
    const fs::path relative = at->path().lexically_relative(run);
    const bool regular = at->is_regular_file() && !at->is_symlink();
    if (!regular || !(is_name_of_runs(name) || is_of_robot(relative, robot)))
      own.push_back(relative.generic_string());
  }
}

}  // namespace

std::vector<std::string> own_files_in(const fs::path& run) {
  std::vector<std::string> own;
  const auto robot = robot_files(run);
  for (const auto& entry : fs::directory_iterator(run)) {
    const std::string name = entry.path().filename().string();
    const bool folder = entry.is_directory() && !entry.is_symlink();
    if (is_part_of_run(name)) {
      if (folder && robot) add_below(run, name, *robot, own);
    } else if (!is_left_over(name) && name != "report.html" &&
               !(name.starts_with("compare_") && name.ends_with(".html"))) {
      own.push_back(name);
    }
  }
  std::sort(own.begin(), own.end());
  return own;
}

}  // namespace legwright
