// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "optimizer/solve/fewest_changes.hpp"
#include "tools/choose/candidate.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/run/run_record.hpp"
#include "tools/task/problem.hpp"
#include "tools/verbs/stop_asked.hpp"

namespace legwright {

/// Why the body of a run changed: what each change buys, how few would do, and what physics says of
/// these bodies within a few cycles.
class ChangeReasons {
 public:
  /// @param threads 0: all cores @param share of the fall of F that few changes shall keep
  /// @param physics whether to ask it at all
  /// @param checkpoint of what it solves
  ChangeReasons(const CodesignProblem& problem, int threads, double share, bool physics,
                StopAsked stop, Checkpoint checkpoint);
  ~ChangeReasons();

  using OnIteration = std::function<bool(const RunLabel&, const DesignIteration&)>;
  /// optimize --few: makes the design with the fewest changes that keeps the share of the fall of F
  /// the result, as one more iteration of the start that won.
  void keep_fewest(MultistartResult& found, const OnIteration& on_iteration);
  /// The space of that design: its changes alone may move. Nothing where it was not made.
  std::optional<DesignSpace> space_of_fewest() const;
  /// Into run.json and, of a joint run, what each change buys into that of each task. Nothing where
  /// the body stayed. @param chosen the result, of whose F it is: that of its search
  void write(const ResultFolder& folder, const MultistartResult& found, const Candidate& chosen,
             RunRecord& run);

 private:
  class CostsByThread;
  const CostsByThread& costs();
  std::vector<PutBack> rows_of(const DesignIteration& design);
  void find_fewest(double initial_F, const DesignIteration& best, const std::vector<PutBack>& rows);
  std::vector<std::optional<PlayedCandidate>> play(
      const Candidate& chosen, const std::vector<std::optional<DesignIteration>>& designs);
  void play_fewest(const Candidate& chosen, const std::optional<ChoiceRecord>& choice);

  const CodesignProblem& problem_;
  const int threads_;
  const bool physics_;
  const StopAsked stop_;
  const Checkpoint checkpoint_;
  // Lists of rows and sequences so far, and of plays: the names of their checkpoints.
  int solved_ = 0, plays_ = 0;
  std::unique_ptr<CostsByThread> costs_;
  FewestChangesRecord fewest_;
  std::vector<FewerChanges> designs_;
};

}  // namespace legwright
