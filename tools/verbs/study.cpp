// SPDX-License-Identifier: Apache-2.0
// `legwright study` is the Python module legwright.study: Dask, which schedules it, is Python's.
#include <optional>

#include "tools/verbs/python_module.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

struct StudyOptions {
  std::string study, folder, scheduler;
  std::optional<int> workers;
  bool force = false, quiet = false, json = false;
};

int study(const StudyOptions& options) {
  std::vector<std::string> words;
  if (!options.folder.empty()) words.insert(words.end(), {"--output", options.folder});
  if (options.workers) words.insert(words.end(), {"--workers", std::to_string(*options.workers)});
  if (!options.scheduler.empty()) words.insert(words.end(), {"--scheduler", options.scheduler});
  if (options.force) words.emplace_back("--force");
  if (options.quiet) words.emplace_back("--quiet");
  if (options.json) words.emplace_back("--json");
  words.insert(words.end(), {"--", options.study});
  return run_python_module(study_part(), words);
}

}  // namespace

void add_study(CLI::App& program, Action& action) {
  const auto [verb, options] = add_verb(
      program, action, "study",
      "Co-design a robot for many tasks, or many robots: a grid or a list, on Dask", study);
  verb->add_option("STUDY", options->study, "study file (TOML): robots, tasks, what varies")
      ->required();
  verb->add_option("-o,--output", options->folder, "folder of the study; default: runs/NAME");
  auto* workers = verb->add_option("--workers", options->workers,
                                   "processes on this machine; default: one for each core")
                      ->check(CLI::Range(1, 1024));
  verb->add_option("--scheduler", options->scheduler,
                   "address of a Dask scheduler that runs, as tcp://host:8786; its workers do the "
                   "work")
      ->excludes(workers);
  verb->add_flag("--force", options->force, "run all points anew");
  verb->add_flag("--quiet", options->quiet, "say nothing but errors");
  verb->add_flag("--json", options->json, "print one JSON document instead of a summary");
  verb->footer(
      "Each point is a run folder, points/HASH, addressed by the hash of its inputs: a study that "
      "was stopped goes\n"
      "on where it stopped, and nothing runs twice. Writes study.parquet, a row for each point, "
      "and study.html,\n"
      "which compares them. Needs Python with the package: pip install \".[study]\" in a clone; "
      "LEGWRIGHT_PYTHON\n"
      "names the interpreter, default python3. docs/studies.md has the study file.\n"
      "Exit code: 0 every point has a design, 1 a point has none, 2 bad input, 3 files, Python or "
      "scheduler, 75 or\n"
      "130 stopped: what is done is kept.");
}

}  // namespace legwright
