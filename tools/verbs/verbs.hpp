// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "tools/files/exit_code.hpp"
#include "tools/verbs/reading_options.hpp"

namespace legwright {

/// What a parsed command line asks for; returns an exit code. May throw InputError (2),
/// std::system_error and std::filesystem::filesystem_error (3), anything else (4): main() turns
/// them into a message and the code.
using Action = std::function<int()>;

/// A subcommand and the options that it is called with, to which its flags are bound; when it is
/// the one that was called, parsing makes `run` of them the action.
template <class Options>
std::pair<CLI::App*, std::shared_ptr<Options>> add_verb(CLI::App& program, Action& action,
                                                        const std::string& name,
                                                        const std::string& about,
                                                        int (*run)(const Options&)) {
  CLI::App* verb = program.add_subcommand(name, about);
  const auto options = std::make_shared<Options>();
  if constexpr (std::is_base_of_v<ReadingOptions, Options>)
    verb->add_flag("--confined", options->confined,
                   "read no file that a robot names outside of its folder");
  verb->callback([&action, options, run] { action = [options, run] { return run(*options); }; });
  return {verb, options};
}

// Each adds its subcommand with options and help to `program`; when it is the one that was called,
// parsing sets `action`.
void add_init(CLI::App& program, Action& action);
void add_check(CLI::App& program, Action& action);
void add_optimize(CLI::App& program, Action& action);
void add_pick(CLI::App& program, Action& action);
void add_validate(CLI::App& program, Action& action);
void add_render(CLI::App& program, Action& action);
void add_report(CLI::App& program, Action& action);
void add_curves(CLI::App& program, Action& action);
void add_play(CLI::App& program, Action& action);
void add_studio(CLI::App& program, Action& action);
void add_study(CLI::App& program, Action& action);
void add_parts(CLI::App& program, Action& action);
void add_gaits(CLI::App& program, Action& action);
void add_build(CLI::App& program, Action& action);
void add_modules(CLI::App& program, Action& action);
void add_export(CLI::App& program, Action& action);
void add_diff(CLI::App& program, Action& action);
void add_doctor(CLI::App& program, Action& action);

}  // namespace legwright
