// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "optimizer/solve/multistart.hpp"
#include "tools/run/design_folder.hpp"

namespace legwright {

/// How many design iterations are still to come, guessed from how fast F settles; `most` at most.
/// @param history F of each iteration so far @param tolerance relative decrease over three
/// iterations that ends it
int iterations_left(const std::vector<double>& history, double tolerance, int most);

/// Seconds until a run ends, guessed from its last few iterations by medians: single guesses jump
/// by factors.
class TimeLeft {
 public:
  TimeLeft(double tolerance, int most) : tolerance_(tolerance), most_(most) {}
  /// @param index of an iteration; 0 starts anew @param value its F @param seconds that it took
  /// Nothing until there is a trend.
  std::optional<double> after(int index, double value, double seconds);
  /// How many iterations there will be, guessed after each.
  int iterations() const;

 private:
  double tolerance_;
  int most_;
  std::vector<double> history_, ends_, seconds_;  // F; guessed last iteration; time of each
};

/// Writes a line of JSON to stderr, {"stage", "done", "total"}: for programs that follow.
void print_progress(const std::string& stage, int done, int total);

/// Tells on stderr how an optimization goes: one live line on a terminal, a line per iteration
/// elsewhere, or one of JSON.
class Progress {
 public:
  enum class Mode { quiet, lines, live, json };
  /// Live where stderr is a terminal.
  static Mode mode_for_stderr(bool quiet);

  /// @param names of the tasks @param units of their speeds @param cost what falls: "F", "F + J"
  Progress(Mode mode, const CodesignOptions& options, std::vector<std::string> names,
           std::vector<std::string> units, std::string cost = "F");
  /// Before the first iteration, which takes longest.
  void start(const std::string& what);
  void iteration(const RunLabel& label, const DesignIteration& iteration,
                 const std::vector<PlanQuality>& qualities);
  /// Ends the live line.
  void finish();

 private:
  Mode mode_;
  TimeLeft time_left_;
  std::vector<std::string> names_, units_;
  std::string cost_;
};

}  // namespace legwright
