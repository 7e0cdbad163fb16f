// SPDX-License-Identifier: Apache-2.0
#include "tools/run/judged_sums.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <map>
#include <utility>

#include "mjcf/text/robot_files.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/checksum.hpp"
#include "tools/files/io_error.hpp"
#include "tools/run/run_record.hpp"
#include "tools/run/task_folders.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = std::size_t{1} << 30;  // of a file: what a robot may have

/// Adds sums of files below a folder. Meshes that designs share are read once.
class SumsBelow {
 public:
  explicit SumsBelow(fs::path root) : root_(std::move(root)) {}

  void add_file(const fs::path& relative) {
    struct stat about {};
    const fs::path file = root_ / relative;
    if (::stat(file.c_str(), &about) != 0 || !S_ISREG(about.st_mode)) return;
    std::string& sum = known_[{about.st_dev, about.st_ino}];
    if (sum.empty()) sum = sum_or_word(file);
    sums_.of(relative.generic_string()) = sum;
  }
  /// scene.xml, motion.csv and the robot's files of a design.
  void add_design(const fs::path& folder) {
    for (const char* name : {"scene.xml", "motion.csv", "robot.xml"}) add_file(folder / name);
    for (const fs::path& file : files_of_robot(root_ / folder / "robot.xml"))
      add_file(folder / file);
  }
  void add_run(const fs::path& run, bool initial) {
    for (const char* name : {"task.toml", "robot.xml"}) add_file(run / "inputs" / name);
    if (initial) add_design(run / "iterations" / "0000");
    add_design(run / "result");
  }
  JudgedSums take() { return std::move(sums_); }

 private:
  static std::string sum_or_word(const fs::path& file) {
    try {
      return sha256_hex(read_file(file, kMostBytes));
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception&) {
      return "unreadable";
    }
  }
  /// Besides the main one. A robot that cannot be read has none: its main file has a sum.
  static std::vector<fs::path> files_of_robot(const fs::path& robot) {
    std::vector<fs::path> files;
    try {
      const RobotFiles read = RobotFiles::read(robot);
      for (const IncludedFile& part : read.includes()) files.push_back(part.path);
      for (const AssetFile& asset : read.assets()) files.push_back(asset.path);
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception&) {
    }
    return files;
  }

  fs::path root_;
  JudgedSums sums_;
  std::map<std::pair<dev_t, ino_t>, std::string> known_;
};

JudgedSums files_alone(JudgedSums sums) {
  std::erase_if(sums, [](const auto& sum) { return sum.first == kLimitsSum; });
  std::sort(sums.begin(), sums.end());
  return sums;
}

}  // namespace

JudgedSums sums_of_run(const fs::path& run) {
  SumsBelow sums(run);
  sums.add_run("", true);
  return sums.take();
}

JudgedSums sums_of_result(const fs::path& run) {
  SumsBelow sums(run);
  sums.add_run("", false);
  return sums.take();
}

JudgedSums sum_of_scene(const fs::path& folder) {
  SumsBelow sums(folder);
  sums.add_file("scene.xml");
  return sums.take();
}

JudgedSums sums_of_joint_run(const fs::path& root, const RunRecord& run) {
  SumsBelow sums(root);
  const std::vector<TaskFolder> tasks = task_folders(run);
  for (const TaskFolder& task : tasks) sums.add_run(task.relative, true);
  for (const TaskFolder& alone : tasks)
    for (const TaskFolder& task : tasks)
      sums.add_design(fs::path("starts") / ("from-" + alone.name) / task.name / "iterations" /
                      "0000");
  return sums.take();
}

JudgedSums sums_of(const fs::path& root, const RunRecord& run) {
  return run.joint() ? sums_of_joint_run(root, run) : sums_of_run(root);
}

Standing standing_of(const std::optional<JudgedSums>& of, const JudgedSums& here) {
  if (!of) return Standing::without_sums;
  return files_alone(*of) == files_alone(here) ? Standing::of_this : Standing::of_another;
}

std::string origin_text(const JudgedSums& of) { return to_line(json_of(of)); }

Standing standing_of_picture(const std::string& origin, const fs::path& folder,
                             const JudgedSums& here) {
  if (origin.empty()) return Standing::without_sums;
  const auto unchanged = [&](const auto& named) {
    if (!named.value().is_string()) return false;
    const std::string sum = named.value().template get<std::string>();
    if (const std::string* const known = here.find(named.key())) return *known == sum;
    return names_bytes({{named.key(), sum}}, named.key(), folder / named.key());
  };
  const Json of = Json::parse(origin, nullptr, false);
  if (!of.is_object() || of.empty()) return Standing::of_another;
  for (const auto& named : of.items())
    if (!unchanged(named)) return Standing::of_another;
  return Standing::of_this;
}

bool names_bytes(const JudgedSums& with, const std::string& name, const fs::path& file) {
  const std::string* const sum = with.find(name);
  return sum != nullptr && fs::is_regular_file(file) &&
         *sum == sha256_hex(read_file(file, kMostBytes));
}

void check_unchanged(const fs::path& root, const JudgedSums& before, const JudgedSums& now,
                     const char* what) {
  if (standing_of(before, now) == Standing::of_this) return;
  throw IoError(fmt::format("{}: the run was replaced meanwhile: {} again", root.string(), what));
}

void of_field(Fields& f, std::optional<JudgedSums>& of) {
  f("of", of,
    "SHA-256 sums of what was judged: files by their paths in the run's folder, \"limits\" of the "
    "limits in force; absent in older files");
}

}  // namespace legwright
