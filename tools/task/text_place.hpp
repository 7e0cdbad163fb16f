// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include <toml++/toml.h>

namespace legwright {

/// Where a position of the TOML parser, which counts code points, is in the text [bytes].
std::size_t text_offset(const std::string& text, const toml::source_position& position);

/// The text with other bytes in the place of a value.
std::string with_value_at(const std::string& text, const toml::node& value, const std::string& by);

}  // namespace legwright
