// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "tools/files/exit_code.hpp"

namespace legwright {

/// What a parsed command line asks for; returns an exit code. May throw InputError (2),
/// std::system_error and std::filesystem::filesystem_error (3), anything else (4): main() turns
/// them into a message and the code.
using Action = std::function<int()>;

// Each adds its subcommand with options and help to `program`; when it is the one that was called,
// parsing sets `action`.
void add_init(CLI::App& program, Action& action);
void add_check(CLI::App& program, Action& action);
void add_optimize(CLI::App& program, Action& action);
void add_validate(CLI::App& program, Action& action);
void add_render(CLI::App& program, Action& action);
void add_report(CLI::App& program, Action& action);
void add_curves(CLI::App& program, Action& action);
void add_play(CLI::App& program, Action& action);
void add_gaits(CLI::App& program, Action& action);
void add_export(CLI::App& program, Action& action);
void add_diff(CLI::App& program, Action& action);
void add_doctor(CLI::App& program, Action& action);

}  // namespace legwright
