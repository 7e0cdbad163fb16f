// SPDX-License-Identifier: Apache-2.0
#include "tools/run/result_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <system_error>

#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/run/checkpoint_file.hpp"
#include "tools/run/run_build.hpp"
#include "tools/run/run_lock.hpp"
#include "tools/run/run_reach.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

// Everything a run consists of, besides its report.
constexpr std::array<const char*, 10> kEntries{
    "run.json", "events.jsonl", "inputs", "iterations", "starts",
    "tasks",    "candidates",   "front",  "result",     "checkpoint"};
/// Empty folders are nobody's loss: a process that was killed before it wrote run.json leaves some.
bool holds_any_entry(const fs::path& root) {
  std::error_code error;
  for (const char* name : kEntries) {
    const fs::file_status entry = fs::symlink_status(root / name, error);
    if (fs::exists(entry) && !(fs::is_directory(entry) && fs::is_empty(root / name, error)))
      return true;
  }
  return false;
}

[[noreturn]] void refuse(const fs::path& root, const std::string& why, const std::string& fix) {
  throw IoError(fmt::format("{}: {}; {}", root.string(), why, fix));
}

[[noreturn]] void refuse_unwritable(const fs::path& root, const std::system_error& failure) {
  refuse(root, "cannot be written: " + failure.code().message(),
         "choose another folder, or mend its permissions or the disk");
}

/// Whether a run was broken off before it had a design, or a state to go on from: nobody's loss.
bool never_began(const fs::path& root) {
  std::error_code error;
  if (has_checkpoint(root)) return false;
  for (const char* designs : {"iterations", "starts", "tasks", "candidates", "front", "result"})
    for (const auto& entry : fs::directory_iterator(root / designs, error))
      if (!entry.path().filename().string().starts_with('.')) return false;  // else unfinished
  const Json run = read_json(root / "run.json");
  const auto status = run.find("status");
  return status != run.end() && (*status == "running" || *status == "failed");
}

/// Where a run may come into being. Throws IoError where something else stands there.
/// @return whether a run is there, which the new one replaces
bool check_free(const fs::path& root, bool force) {
  if (!holds_any_entry(root)) return false;
  if (!is_run(root))
    refuse(root, "holds files of the names of a run that are not Legwright's",
           "choose another folder");
  if (!force && !never_began(root))
    refuse(root, "already holds a run",
           (has_checkpoint(root)
                ? "go on with its search with `legwright optimize --resume " + root.string() + "`, "
                : "") +
               "choose another folder, or replace that run with --force (in Python force=True)");
  return true;
}

/// Throws IoError where another process writes into a run.
std::shared_ptr<const RunLock> locked(const fs::path& root) {
  try {
    return std::make_shared<const RunLock>(root);
  } catch (const std::system_error& failure) {
    refuse_unwritable(root, failure);
  }
}

std::shared_ptr<RunBuild> build_of(const fs::path& root, std::shared_ptr<const RunLock> lock) {
  try {
    return std::make_shared<RunBuild>(root, std::move(lock));
  } catch (const std::system_error& failure) {
    refuse(fs::canonical(root).parent_path(), "cannot be written: " + failure.code().message(),
           "the new run is built there beside the old one: mend its permissions or the disk, or "
           "choose another folder");
  }
}

}  // namespace

bool is_part_of_run(std::string_view name) {
  return std::find(kEntries.begin(), kEntries.end(), name) != kEntries.end();
}

bool is_run(const fs::path& root) {
  std::error_code error;
  if (!fs::is_regular_file(root / "run.json", error)) return false;
  try {
    const Json run = read_json(root / "run.json");
    return run.is_object() && run.value("schema", "") == "legwright/run";
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    return false;  // whatever it is, it is not ours
  }
}

ResultFolder ResultFolder::create(const fs::path& root, bool force) {
  std::error_code error;
  const bool existed = fs::exists(root, error);
  if (existed && !fs::is_directory(root, error))
    refuse(root, "is a file, not a folder", "choose another folder");
  // Nothing is put beside somebody's own files; a run that is just being made has its lock first.
  if (holds_any_entry(root) && !fs::exists(root / RunLock::kFile, error)) check_free(root, true);
  try {
    fs::create_directories(root);
    ResultFolder folder(root);
    folder.lock_ = locked(root);  // before a run is told of that is being written
    if (check_free(root, force)) folder.build_ = build_of(root, folder.lock_);
    sweep_leftovers(root);
    const fs::path probe = folder.root() / ".legwright-probe";
    write_file(probe, "probe\n");
    fs::remove(probe);
    fs::create_directory(folder.inputs());
    fs::create_directory(folder.iterations());
    return folder;
  } catch (const std::system_error& failure) {
    refuse_unwritable(root, failure);
  }
}

ResultFolder ResultFolder::open_to_write(const fs::path& root, BetweenResults between) {
  ResultFolder folder = open(root, between);
  folder.lock_ = locked(root);
  (void)open(root, between);  // who held it until now may have removed the run
  check_no_links(root);
  sweep_leftovers(root);
  return folder;
}

ResultFolder ResultFolder::open(const fs::path& root, BetweenResults between) {
  std::error_code error;
  if (fs::is_regular_file(root, error))
    refuse(root, "is a file, not the folder of a run",
           root.extension() == ".toml"
               ? "`legwright optimize` makes a run of a task; give the folder that it wrote"
               : "give a folder that `legwright optimize` wrote");
  if (fs::exists(root / "run.json", error) && !is_run(root))
    refuse(root / "run.json", "is damaged, or not of Legwright",
           "run `legwright optimize`, which writes it again, or give another folder");
  if (!is_run(root)) refuse(root, "holds no run", "give a folder that `legwright optimize` wrote");
  ResultFolder folder(root);
  if (between == BetweenResults::refused && fs::exists(folder.picking(), error))
    refuse(root, "is between two results: a `legwright pick` was stopped on the way, or is at work",
           "pick one of its designs (again)");
  return folder;
}

const fs::path& ResultFolder::root() const { return build_ ? build_->at() : root_; }

fs::path ResultFolder::in_the_end(const fs::path& path) const {
  return build_ ? root_ / path.lexically_relative(root()) : path;
}

void ResultFolder::check_there() const {
  if (build_ ? build_->is_there() : !lock_ || lock_->stands()) return;
  throw IoError(
      fmt::format("{}: was removed or replaced while it was written; the run ends, choose "
                  "a folder that stays",
                  root_.string()));
}

bool ResultFolder::stand() const {
  if (!build_) return true;
  check_there();
  if (!fs::exists(result())) return false;
  build_->stand();
  return true;
}

fs::path ResultFolder::iteration(int index) const {
  return iterations() / fmt::format("{:04}", index);
}

}  // namespace legwright
