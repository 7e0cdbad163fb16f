// SPDX-License-Identifier: Apache-2.0
#include "tools/run/result_folder.hpp"

#include <fmt/format.h>

#include <array>
#include <system_error>

#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/run/run_lock.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

// Everything a run consists of; --force removes these and nothing else.
constexpr std::array<const char*, 9> kEntries{"run.json",   "events.jsonl", "inputs",
                                              "iterations", "starts",       "tasks",
                                              "candidates", "front",        "result"};
constexpr const char* kReport = "report.html";  // of `legwright report`; goes with the run

bool holds_any_entry(const fs::path& root) {
  std::error_code error;
  for (const char* name : kEntries)
    if (fs::exists(fs::symlink_status(root / name, error))) return true;
  return false;
}

void remove_run(const fs::path& root) {
  // run.json last: what is left after an interruption still counts as a run.
  fs::remove(root / kReport);
  for (auto name = kEntries.rbegin(); name != kEntries.rend(); ++name) fs::remove_all(root / *name);
}

[[noreturn]] void refuse(const fs::path& root, const std::string& why, const std::string& fix) {
  throw IoError(fmt::format("{}: {}; {}", root.string(), why, fix));
}

[[noreturn]] void refuse_unwritable(const fs::path& root, const std::system_error& failure) {
  refuse(root, "cannot be written: " + failure.code().message(),
         "choose another folder, or mend its permissions or the disk");
}

/// Where a run may come into being. Throws IoError where something else stands there.
void check_free(const fs::path& root, bool force) {
  if (!holds_any_entry(root)) return;
  if (!is_run(root))
    refuse(root, "holds files of the names of a run that are not Legwright's",
           "choose another folder");
  if (!force)
    refuse(root, "already holds a run",
           "choose another folder, or replace that run with --force (in Python force=True)");
}

/// Throws IoError where another process writes into a run.
std::shared_ptr<const RunLock> locked(const fs::path& root) {
  try {
    return std::make_shared<const RunLock>(root);
  } catch (const std::system_error& failure) {
    refuse_unwritable(root, failure);
  }
}

}  // namespace

bool is_run(const fs::path& root) {
  std::error_code error;
  if (!fs::is_regular_file(root / "run.json", error)) return false;
  try {
    const Json run = read_json(root / "run.json");
    return run.is_object() && run.value("schema", "") == "legwright/run";
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
    check_free(root, force);
    // Probe before anything is removed: a folder that cannot be written must keep its old run.
    const fs::path probe = root / ".legwright-probe";
    write_file(probe, "probe\n");
    fs::remove(probe);
    if (force) remove_run(root);
    fs::create_directory(folder.inputs());
    fs::create_directory(folder.iterations());
    return folder;
  } catch (const std::system_error& failure) {
    refuse_unwritable(root, failure);
  }
}

ResultFolder ResultFolder::open_to_write(const fs::path& root) {
  ResultFolder folder = open(root);
  folder.lock_ = locked(root);
  (void)open(root);  // who held it until now may have removed the run
  return folder;
}

ResultFolder ResultFolder::open(const fs::path& root) {
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
  return ResultFolder(root);
}

fs::path ResultFolder::iteration(int index) const {
  return iterations() / fmt::format("{:04}", index);
}

}  // namespace legwright
