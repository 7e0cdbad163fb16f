// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tools/run/verdict_record.hpp"

namespace legwright {

/// What a row of a verdict measures, in words for whoever has not read the glossary.
std::string plain_name_of(const LimitRow& row);
/// The same with its value.
std::string plain_value_of(const LimitRow& row);
/// The same with its value, where it was and what passes, each with its unit: shares in %.
std::string plain_words_of(const LimitRow& row);
/// What the row is called in files and in the field.
std::string term_of(const LimitRow& row);

}  // namespace legwright
