// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace legwright {

/// A finished design of a run, ready to be shown.
struct WrittenDesign {
  std::filesystem::path scene;  // scene.xml of the design
  std::string name;             // "iteration 7", "result"
  bool result = false;          // the run has ended, and this is what it found
};

/// One line of what is known about a design: what it is, and the value.
struct Fact {
  std::string what, value;
};

/// The design that a scene belongs to, by the name of its folder; nameless elsewhere.
WrittenDesign design_at(const std::filesystem::path& scene);

/// Cost and planned speed of a design from the metrics.json beside its scene; without them where
/// that cannot be read, empty for a nameless one.
std::vector<Fact> facts_of(const WrittenDesign& design);

/// Watches the folder of a run, which need not exist yet, for designs that land there. A folder
/// tasks/NAME of a joint run, which appears only at the end, stands for the designs of its task in
/// all starts. Of a run that is being replaced (`optimize --force`) the designs of the new one are
/// watched, which is built beside it. Nothing here throws because of files that are missing, half
/// there or vanish.
class RunFollower {
 public:
  explicit RunFollower(std::filesystem::path run);

  /// The design that landed last, or the result once the run has ended, where it is not the one
  /// that the last call gave; designs that came and went between two calls are passed over.
  std::optional<WrittenDesign> next();

  /// Whether the last call of next() found the run ended.
  bool ended() const { return ended_; }

  /// What there is to wait for, in a sentence for the user; empty once a design was found.
  std::string waiting() const;

 private:
  struct Candidate {
    std::filesystem::file_time_type written_at;
    std::filesystem::path folder;
    auto operator<=>(const Candidate&) const = default;
  };
  std::filesystem::path watched() const;
  static std::vector<std::filesystem::path> places(const std::filesystem::path& run);
  static std::optional<Candidate> newest(const std::filesystem::path& run);

  std::filesystem::path run_;
  std::optional<Candidate> shown_;
  bool ended_ = false;
};

}  // namespace legwright
