// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "tools/validate/limits.hpp"

namespace legwright {

/// A limits file (README.md): one table per quantity, with low, high or both. What it does not
/// mention keeps its default. Throws InputError with every fault of the file, by line and key.
/// @param file for messages
Limits parse_limits(const std::string& text, const std::filesystem::path& file);
/// Throws InputError where it cannot be read, too.
Limits read_limits(const std::filesystem::path& file);

/// Throws InputError, with line and key, where the file asks for a margin of the floor's friction
/// on the wrong side of what the task plans: other margins are known to be so without one.
void check_friction_margin(const Limits& limits, const std::filesystem::path& file, double planned);

/// Whether a limits file asks for other numerics; by default they are judged only where they are
/// played.
bool ask_for_numerics(const Limits& limits);
/// Whether judging by them needs disturbed roll-outs.
bool need_robustness(const Limits& limits);

}  // namespace legwright
