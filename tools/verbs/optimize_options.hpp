// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

#include "optimizer/solve/first_motion.hpp"
#include "optimizer/solve/multistart.hpp"
#include "tools/choose/choose_design.hpp"
#include "tools/run/record.hpp"
#include "tools/verbs/close_gap.hpp"
#include "tools/verbs/reading_options.hpp"
#include "tools/verbs/stop_asked.hpp"

namespace legwright {

/// What `legwright optimize` was asked for.
struct OptimizeOptions : ReadingOptions {
  std::string task, robot, run;
  bool motion_only = false, no_pictures = false, quiet = false, json = false, force = false;
  bool few = false, one_start = false, lbfgs = false, bilevel = false, plan_only = false;
  bool no_certificate = false, no_reasons = false, progress = false;
  double few_keeps = 95.0;  // percent of the fall of F
  int max_iterations = CodesignOptions{}.max_iterations;
  int starts = 0, threads = 0, front = 0, physics_steps = 0;
  std::uint64_t seed = 1;
  std::optional<double> stop_at;  // F
  std::string resume;             // folder of a run whose search goes on
  bool anyway = false;            // though another version of the program began it
};

/// What a search depends on, and what it shows: as a checkpoint keeps it.
void fields(Fields& f, OptimizeOptions& options);

/// Binds the options of the command line, with their help.
void add_options(CLI::App& verb, OptimizeOptions& options);

/// What the solvers, and the choice among what they find, take from them. @param stop ends them
MultistartOptions settings_of(const OptimizeOptions& options, int task_count,
                              const StopAsked& stop);
FirstMotionOptions first_motion_of(const OptimizeOptions& options, const StopAsked& stop);
CloseGapOptions gap_options(const OptimizeOptions& options, const StopAsked& stop);
ChoiceOptions choice_options(const OptimizeOptions& options, const MultistartOptions& settings,
                             const StopAsked& stop);

}  // namespace legwright
