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

/// Whether a limits file asks for other numerics; by default they are judged only where they are
/// played.
bool ask_for_numerics(const Limits& limits);
/// Whether judging by them needs disturbed roll-outs.
bool need_robustness(const Limits& limits);

}  // namespace legwright
