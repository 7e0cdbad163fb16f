// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

namespace legwright {

class RunLock;

/// Whether a folder holds a run: a run.json that is Legwright's.
bool is_run(const std::filesystem::path& root);

/// Where the files of a run are: run.json, inputs/, events.jsonl, iterations/NNNN/, result/.
class ResultFolder {
 public:
  /// Makes the folder of a new run, with inputs/ and iterations/ in it. Throws IoError, with a way
  /// out in its message, where it holds a run (unless `force`: then run.json, events.jsonl,
  /// inputs/, iterations/, starts/, tasks/,
  /// candidates/, front/, result/ and report.html are removed first, and no other file) or files
  /// of the same names that are no run (never removed), and where it cannot be written. It throws
  /// before it removes anything, but for a removal that itself fails halfway. While it and its
  /// copies live, no other process may write there (RunLock).
  static ResultFolder create(const std::filesystem::path& root, bool force);
  /// An existing run, to read. Throws IoError where `root` holds none.
  static ResultFolder open(const std::filesystem::path& root);
  /// The same to write into: no other process may meanwhile. Throws IoError where one does.
  static ResultFolder open_to_write(const std::filesystem::path& root);

  const std::filesystem::path& root() const { return root_; }
  std::filesystem::path run_json() const { return root_ / "run.json"; }
  std::filesystem::path events() const { return root_ / "events.jsonl"; }
  std::filesystem::path inputs() const { return root_ / "inputs"; }
  std::filesystem::path iterations() const { return root_ / "iterations"; }
  std::filesystem::path iteration(int index) const;  // iterations/0007
  std::filesystem::path result() const { return root_ / "result"; }

 private:
  explicit ResultFolder(std::filesystem::path root) : root_(std::move(root)) {}
  std::filesystem::path root_;
  std::shared_ptr<const RunLock> lock_;  // none where it is only read
};

}  // namespace legwright
