// SPDX-License-Identifier: Apache-2.0
#include "tools/run/scene_sums.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "mjcf/text/input_error.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/checksum.hpp"
#include "tools/files/json_file.hpp"
#include "tools/run/task_folders.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSceneName = "scene.xml";

/// Ways to the folders of all designs of a run from there, in order; those of tasks are runs of
/// their own. What is hidden is not finished.
std::vector<fs::path> designs_of(const fs::path& root) {
  std::vector<fs::path> out;
  for (const char* part : {"candidates", "front", "iterations", "result", "starts"}) {
    if (!fs::is_directory(root / part)) continue;
    if (fs::is_regular_file(root / part / kSceneName)) out.emplace_back(part);
    for (auto at = fs::recursive_directory_iterator(root / part); at != end(at); ++at) {
      if (!at->is_directory()) continue;
      if (at->path().filename().string().starts_with('.'))
        at.disable_recursion_pending();
      else if (fs::is_regular_file(at->path() / kSceneName))
        out.push_back(at->path().lexically_relative(root));
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::string name_of_scene(const fs::path& design) { return (design / kSceneName).generic_string(); }

std::string sum_of_scene(const fs::path& root, const fs::path& design) {
  return sha256_hex(read_file(root / design / kSceneName));
}

void note_own_scenes(const fs::path& root, RunRecord& run) {
  run.scenes.emplace();
  for (const fs::path& design : designs_of(root))
    run.scenes->of(name_of_scene(design)) = sum_of_scene(root, design);
}

void check_own_scene(const fs::path& root, const RunRecord& run, const fs::path& design) {
  const std::string* const wanted = run.scenes ? run.scenes->find(name_of_scene(design)) : nullptr;
  const fs::path scene = root / design / kSceneName;
  if (wanted == nullptr || !fs::is_regular_file(scene) || *wanted == sum_of_scene(root, design))
    return;
  throw InputError(
      scene.string(), 0, "",
      "was edited since the run wrote it (its SHA-256 in run.json is another) and would be taken "
      "for the run's. For other masses, gains or friction change the file of the robot or of the "
      "task and run `legwright optimize` again; `legwright play` shows an edited scene; `legwright "
      "pick` puts a design of the run in the place of an edited result");
}

}  // namespace

void note_scenes(const ResultFolder& folder, RunRecord& run) {
  for (const TaskFolder& task : task_folders(run)) {
    const fs::path own = folder.root() / task.relative;
    if (!fs::is_regular_file(own / "run.json")) continue;  // stopped before it had a result
    auto task_run = read_record_file<RunRecord>(own / "run.json");
    note_own_scenes(own, task_run);
    write_json(own / "run.json", json_of(task_run));
  }
  note_own_scenes(folder.root(), run);
}

void note_result_scene(const fs::path& root, RunRecord& run) {
  if (!run.scenes) run.scenes.emplace();
  run.scenes->of(name_of_scene("result")) = sum_of_scene(root, "result");
}

void check_scene(const fs::path& root, const RunRecord& run, const fs::path& design) {
  for (const TaskFolder& task : task_folders(run)) {
    const fs::path below = design.lexically_relative(task.relative);
    if (below.empty() || *below.begin() == "..") continue;
    const fs::path own = root / task.relative;
    check_own_scene(own, read_record_file<RunRecord>(own / "run.json"), below);
    return;
  }
  check_own_scene(root, run, design);
}

void check_result_scenes(const fs::path& root, const RunRecord& run) {
  check_scene(root, run, "result");
  for (const TaskFolder& task : task_folders(run)) check_scene(root, run, task.relative / "result");
}

void check_scenes(const fs::path& root) {
  const auto run = read_record_file<RunRecord>(ResultFolder::open(root).run_json());
  for (const fs::path& design : designs_of(root)) check_own_scene(root, run, design);
}

}  // namespace legwright
