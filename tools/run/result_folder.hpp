// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

namespace legwright {

class RunBuild;
class RunLock;

/// Whether a folder holds a run: a run.json that is Legwright's.
bool is_run(const std::filesystem::path& root);
/// Whether a name is that of something that a run consists of: "run.json", "iterations".
bool is_part_of_run(std::string_view name);

/// Where the files of a run are: run.json, inputs/, events.jsonl, iterations/NNNN/, result/.
class ResultFolder {
 public:
  static constexpr const char* kPicking = ".result-picking";

  /// Makes the folder of a new run, with inputs/ and iterations/ in it. Where `root` holds a run
  /// and `force` is to replace it, the new one is built in a hidden folder beside it, until
  /// stand(). Throws IoError, with a way out in its message, where it holds a run without `force`,
  /// or files of the same names that are no run, or, with `force`, somebody's own files, and where
  /// it cannot be written. While it and its copies live, no other process may write there
  /// (RunLock).
  static ResultFolder create(const std::filesystem::path& root, bool force);
  /// A run between two results, as a process that was killed while it picked one leaves it: record
  /// and result tell of different designs. Only picking again may open it.
  enum class BetweenResults { refused, taken_up };
  /// An existing run, to read. Throws IoError where `root` holds none.
  static ResultFolder open(const std::filesystem::path& root,
                           BetweenResults between = BetweenResults::refused);
  /// The same to write into: no other process may meanwhile. Throws IoError where one does.
  static ResultFolder open_to_write(const std::filesystem::path& root,
                                    BetweenResults between = BetweenResults::refused);

  /// Where its files are now.
  const std::filesystem::path& root() const;
  /// Where they are in the end, of a path that is below root().
  std::filesystem::path in_the_end(const std::filesystem::path& path) const;
  /// Throws IoError where the folder was removed or replaced since it was locked.
  void check_there() const;
  /// A run that replaces another takes its place. @return false where it has no result: then that
  /// one stays. Throws IoError, std::system_error.
  bool stand() const;
  std::filesystem::path run_json() const { return root() / "run.json"; }
  std::filesystem::path events() const { return root() / "events.jsonl"; }
  std::filesystem::path inputs() const { return root() / "inputs"; }
  std::filesystem::path iterations() const { return root() / "iterations"; }
  std::filesystem::path iteration(int index) const;  // iterations/0007
  std::filesystem::path result() const { return root() / "result"; }
  /// There while the run is between two results.
  std::filesystem::path picking() const { return root() / kPicking; }

 private:
  explicit ResultFolder(std::filesystem::path root) : root_(std::move(root)) {}
  std::filesystem::path root_;
  std::shared_ptr<const RunLock> lock_;  // none where it is only read
  std::shared_ptr<RunBuild> build_;      // of a run that replaces another
};

}  // namespace legwright
