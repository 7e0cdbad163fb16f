// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace legwright {

/// A message, cleaned, in lines of at most 60 characters, broken at blanks where there are any.
/// @param size longest result [bytes]; a longer one is cut after a whole character and ends in
/// " ..."
std::string in_lines(const std::string& message, std::size_t size);

/// The lines of a message, each but once: MuJoCo and a plugin may both tell the same fault twice.
std::string without_repeats(const std::string& message);

}  // namespace legwright
