// SPDX-License-Identifier: Apache-2.0
#include "tools/files/unfinished_path.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace legwright {
namespace {

namespace fs = std::filesystem;

struct UnfinishedPaths {
  std::recursive_mutex mutex;
  std::vector<const UnfinishedPath*> of;
};

/// Never destroyed: static objects may still write files when the program ends.
UnfinishedPaths& unfinished_paths() {
  static auto* const paths = new UnfinishedPaths;
  return *paths;
}

/// Threads go on writing into a folder while it is removed.
void remove_though_written(const fs::path& path) {
  constexpr int kTries = 100;
  std::error_code error;
  for (int n = 0; n < kTries; ++n) {
    fs::remove_all(path, error);
    if (!error) return;
  }
}

}  // namespace

UnfinishedPath::UnfinishedPath(fs::path path) : path_(std::move(path)) {
  UnfinishedPaths& paths = unfinished_paths();
  const std::lock_guard lock(paths.mutex);
  paths.of.push_back(this);
}

UnfinishedPath::~UnfinishedPath() {
  const std::lock_guard lock(unfinished_paths().mutex);
  forget();
}

std::error_code UnfinishedPath::rename_to(const fs::path& target) {
  const std::lock_guard lock(unfinished_paths().mutex);
  std::error_code error;
  fs::rename(path_, target, error);
  if (!error) forget();
  return error;
}

void UnfinishedPath::forget() {
  std::vector<const UnfinishedPath*>& of = unfinished_paths().of;
  of.erase(std::remove(of.begin(), of.end(), this), of.end());
}

WholeChange::WholeChange() : held_(unfinished_paths().mutex) {}

void remove_unfinished() noexcept {
  UnfinishedPaths& paths = unfinished_paths();
  paths.mutex.lock();  // for good
  for (auto at = paths.of.rbegin(); at != paths.of.rend(); ++at)
    remove_though_written((*at)->path());
}

}  // namespace legwright
