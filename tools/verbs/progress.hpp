// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "optimizer/solve/codesign.hpp"
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

  Progress(Mode mode, const CodesignOptions& options, std::string unit);
  /// Before the first iteration, which takes longest.
  void start(const std::string& what);
  void iteration(const DesignIteration& iteration, const PlanQuality& quality);
  /// Ends the live line.
  void finish();

  const std::vector<double>& history() const { return history_; }

 private:
  Mode mode_;
  double tolerance_;
  int most_;
  std::string unit_;
  std::vector<double> history_;
  double seconds_per_iteration_ = 0.0;
};

}  // namespace legwright
