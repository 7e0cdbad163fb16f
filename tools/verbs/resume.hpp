// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "tools/run/checkpoint_file.hpp"
#include "tools/verbs/optimize_options.hpp"

namespace legwright {

/// What a checkpoint says of a search that begins here and now. @param options as they were asked
CheckpointBegin begin_of(const OptimizeOptions& options);

/// The search of a run that was stopped or killed, also of one that was to replace it. Throws
/// IoError where there is none, InputError where another version of the program began it, unless
/// `anyway`.
ReadCheckpoint unfinished_search(const std::filesystem::path& run, bool anyway);

/// Throws InputError where options are given beside --resume: those of the beginning hold.
void check_alone(const OptimizeOptions& asked);

/// The options that it was begun with, paths as they are from here. Throws InputError where it was
/// begun in Python, whose tasks and objectives are in no file.
OptimizeOptions options_of(const ReadCheckpoint& search, const std::filesystem::path& run);

/// Throws InputError where task or robot are not those that a search was begun with.
void check_same_inputs(const std::filesystem::path& run, const ByName<std::string>& begun,
                       const ByName<std::string>& now);

/// Throws InputError where a search was begun with other options than these.
void check_same_options(const ReadCheckpoint& search, const OptimizeOptions& options,
                        const std::filesystem::path& run);

}  // namespace legwright
