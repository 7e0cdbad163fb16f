// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "optimizer/solve/multistart.hpp"
#include "tools/io/design_folder.hpp"

namespace legwright {

/// How many design iterations are still to come, guessed from how fast F settles; `most` at most.
/// @param history F of each iteration so far @param tolerance relative decrease over three
/// iterations that ends it
int iterations_left(const std::vector<double>& history, double tolerance, int most);

/// Tells on stderr how an optimization goes: one live line on a terminal, a line per iteration
/// elsewhere.
class Progress {
 public:
  enum class Mode { quiet, lines, live };
  /// Live where stderr is a terminal.
  static Mode mode_for_stderr(bool quiet);

  /// @param names of the tasks @param units of their speeds
  Progress(Mode mode, const CodesignOptions& options, std::vector<std::string> names,
           std::vector<std::string> units);
  /// Before the first iteration, which takes longest.
  void start(const std::string& what);
  void iteration(const RunLabel& label, const DesignIteration& iteration,
                 const std::vector<PlanQuality>& qualities);
  /// Ends the live line.
  void finish();

 private:
  Mode mode_;
  double tolerance_;
  int most_;
  std::vector<std::string> names_, units_;
  std::vector<double> history_;  // F of the run that is going on
  double seconds_per_iteration_ = 0.0;
};

}  // namespace legwright
