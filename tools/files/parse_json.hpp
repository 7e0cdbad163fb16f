// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "tools/files/json_file.hpp"

namespace legwright {

/// The document, or a discarded one (`is_discarded()`) where the text is no JSON or nests more than
/// 64 deep: each level costs memory many thousand times its bracket.
Json parse_json(std::string_view text);

}  // namespace legwright
