// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "optimizer/solve/checkpoint.hpp"
#include "tools/run/record.hpp"

namespace legwright {

/// checkpoint/begin.json: of what a search was begun. One that is taken up begins likewise.
struct CheckpointBegin {
  static constexpr RecordKind kKind{"legwright/checkpoint", 1, "optimize"};
  std::string folder;            // in which the process worked: paths start there
  ByName<std::string> options;   // of the verb, each as JSON
  ByName<std::string> versions;  // of the program and its libraries
  std::string factor;            // how Hessians are factored, which last bits depend on
  ByName<std::string> inputs;    // CRC-32 of each file of inputs/
};

void fields(Fields& f, CheckpointBegin& begin);

/// Of the files in a run's inputs/, by their paths in the run.
ByName<std::string> sums_of_inputs(const std::filesystem::path& run);

using CheckpointStates = std::map<std::string, std::vector<double>>;

/// A search that ended on the way.
struct ReadCheckpoint {
  CheckpointBegin begin;
  CheckpointStates states;
};

/// Where a run has its checkpoint while there is no result, or none of a whole search.
std::filesystem::path checkpoint_folder(const std::filesystem::path& run);

/// Whether a run has a whole one: begin.json is written last.
bool has_checkpoint(const std::filesystem::path& run);
/// When a state was last kept there.
std::filesystem::file_time_type last_kept(const std::filesystem::path& run);

/// Reads the states up to the first that a killed process tore. Nothing where a run has no
/// checkpoint. Throws IoError where begin.json is damaged.
std::optional<ReadCheckpoint> read_checkpoint(const std::filesystem::path& run);

/// Writes the states of a search into checkpoint/ of its run as they come: each is one write, so a
/// process that dies has it there. When superseded ones take most of the file, it is written anew.
class CheckpointFile final : public CheckpointStore {
 public:
  /// @param earlier what another process had come to: goes into the file first, and is what find()
  /// finds. Throws std::system_error where the files cannot be written.
  CheckpointFile(const std::filesystem::path& run, const CheckpointBegin& begin,
                 CheckpointStates earlier);
  ~CheckpointFile() override;
  CheckpointFile(const CheckpointFile&) = delete;
  CheckpointFile& operator=(const CheckpointFile&) = delete;

  std::vector<double> find(const std::string& name) override;
  /// Throws std::system_error, for instance on a full disk.
  void keep(const std::string& name, const std::vector<double>& state) override;
  /// Removes the files of a search that is done.
  void remove();

 private:
  void write_anew();
  void append(const std::string& bytes);

  std::filesystem::path folder_;
  const CheckpointStates earlier_;
  std::mutex mutex_;
  CheckpointStates latest_;
  std::size_t file_bytes_ = 0, latest_bytes_ = 0;
  int descriptor_ = -1;
};

}  // namespace legwright
