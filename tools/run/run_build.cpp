// SPDX-License-Identifier: Apache-2.0
#include "tools/run/run_build.hpp"

#include <fmt/format.h>
#include <sys/random.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <functional>
#include <string>
#include <system_error>

#include "mjcf/text/listed.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/replace_folder.hpp"
#include "tools/run/checkpoint_file.hpp"
#include "tools/run/own_files.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// Head of the names of builds of a run.
std::string build_head(const fs::path& target) {
  return "." + target.filename().string().substr(0, 180) + ".new-";
}

[[noreturn]] void refuse_to_replace(const fs::path& run, const std::string& why) {
  throw IoError(fmt::format("{}: {}", run.string(), why));
}

void check_replaceable(const fs::path& named, const fs::path& target) {
  const std::vector<std::string> own = own_files_in(target);
  if (!own.empty()) {
    constexpr std::size_t kTold = 5;
    refuse_to_replace(
        named, fmt::format("holds files that are not of the run: {}; move them elsewhere, or "
                           "choose another folder",
                           listed(own, kTold)));
  }
  struct stat here {};
  struct stat around {};
  if (::stat(target.c_str(), &here) == 0 && ::stat(target.parent_path().c_str(), &around) == 0 &&
      here.st_dev != around.st_dev)
    refuse_to_replace(
        named, "is a mount point, which no other folder can replace; choose a folder below it");
  std::error_code error;
  const fs::path below = fs::current_path(error).lexically_relative(target);
  if (!error && !below.empty() && *below.begin() != "..")
    refuse_to_replace(
        named,
        "is the folder in which this process works, and would go away with the old run; "
        "start it from elsewhere");
}

/// A hidden folder of a new name beside a run.
fs::path new_folder_beside(const fs::path& target) {
  for (;;) {
    std::uint64_t random = 0;
    if (::getrandom(&random, sizeof random, 0) != sizeof random)
      throw std::system_error(errno, std::generic_category(), "getrandom");
    fs::path path = target.parent_path() / fmt::format("{}{:016x}.tmp", build_head(target), random);
    if (fs::create_directory(path)) return path;
  }
}

/// Each build of a killed process.
void for_dead_builds(const fs::path& target, const std::function<void(const fs::path&)>& work) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(target.parent_path(), ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(build_head(target)) || !name.ends_with(".tmp")) continue;
    if (!fs::is_directory(entry.symlink_status(ignored))) continue;
    try {
      const RunLock lock(entry.path(), RunLock::Extent::this_folder);
      work(entry.path());
    } catch (const std::exception&) {  // of a process whose run was removed meanwhile
    }
  }
}

/// The checkpoint of a build, where it is whole, takes the place of the run's.
void move_checkpoint(const fs::path& build, const fs::path& run) {
  std::error_code ignored;
  const fs::path from = checkpoint_folder(build), to = checkpoint_folder(run);
  if (!has_checkpoint(build)) return;
  if (fs::exists(to, ignored))
    replace_folder(from, to);
  else
    fs::rename(from, to);
}

/// Builds of killed processes, and the run that one of them had replaced.
void sweep_builds(const fs::path& target) {
  std::error_code ignored;
  for_dead_builds(target, [&](const fs::path& build) { fs::remove_all(build, ignored); });
  fs::remove_all(target.parent_path() / ("." + target.filename().string() + "-replaced"), ignored);
}

/// ".verdict.json.0123456789abcdef.tmp", as write_file() makes them.
bool is_temporary(const std::string& name) {
  constexpr std::size_t kTail = 21;  // a dot, sixteen digits, ".tmp"
  if (!name.starts_with('.') || !name.ends_with(".tmp") || name.size() <= kTail) return false;
  const std::string digits = name.substr(name.size() - kTail + 1, 16);
  return name[name.size() - kTail] == '.' &&
         digits.find_first_not_of("0123456789abcdef") == std::string::npos;
}

}  // namespace

RunBuild::RunBuild(const fs::path& run, std::shared_ptr<const RunLock> lock)
    : named_(run), target_(fs::canonical(run)), old_lock_(std::move(lock)) {
  check_replaceable(named_, target_);
  sweep_builds(target_);
  at_ = new_folder_beside(target_);
  lock_ = std::make_unique<RunLock>(at_, RunLock::Extent::this_folder);
  old_lock_->note(at_.filename().string());
}

RunBuild::~RunBuild() {
  if (stands_) return;
  std::error_code ignored;
  try {
    old_lock_->note("");
    if (old_lock_->stands()) move_checkpoint(at_, target_);
  } catch (const std::exception&) {  // then the search begins anew
  }
  fs::remove_all(at_, ignored);
}

bool RunBuild::is_there() const { return lock_->stands() && (stands_ || old_lock_->stands()); }

void RunBuild::stand() {
  fs::path old;
  try {
    old = exchange_folders(at_, target_);
  } catch (const std::system_error& failure) {
    const fs::path kept = target_.parent_path() / at_.filename().string().substr(1);
    fs::rename(at_, kept);  // under a name that no sweep removes
    stands_ = true;
    refuse_to_replace(named_, fmt::format("cannot be replaced: {}; the new run stands in {}",
                                          failure.code().message(), kept.string()));
  }
  stands_ = true;
  lock_->moved_to(target_);
  at_ = named_;
  sync_folder(target_.parent_path());
  std::error_code ignored;  // what cannot be removed now is swept by the next run
  fs::remove_all(old, ignored);
}

void rescue_checkpoint(const fs::path& run) {
  std::error_code error;
  const fs::path target = fs::canonical(run, error);
  if (error) return;
  for_dead_builds(target, [&](const fs::path& build) {
    if (!has_checkpoint(build)) return;
    const RunLock lock(target);  // nobody's who is at work there
    if (!has_checkpoint(target) || last_kept(build) > last_kept(target))
      move_checkpoint(build, target);
  });
}

void sweep_leftovers(const fs::path& run) {
  std::error_code ignored;
  for (const fs::path& folder : {run, run / "result", run / "inputs"})
    for (const auto& entry : fs::directory_iterator(folder, ignored))
      if (is_temporary(entry.path().filename().string()) &&
          fs::is_regular_file(entry.symlink_status(ignored)))
        fs::remove(entry.path(), ignored);
}

}  // namespace legwright
