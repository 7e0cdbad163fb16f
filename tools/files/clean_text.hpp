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

/// A name for a file or folder: of letters, digits, `_` and `-` only, others become `_`; at most
/// 64. A model may be named anything, "../x" included.
std::string plain_name(std::string_view name);

}  // namespace legwright
