// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace legwright {

/// `text` as valid UTF-8 without control characters (tab and line break become blanks); what is not
/// becomes U+FFFD.
std::string clean_utf8(std::string_view text);

/// The same line by line, for a terminal: names in a file may hold escape sequences.
std::string terminal_text(std::string_view text);

}  // namespace legwright
