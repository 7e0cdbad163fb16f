// SPDX-License-Identifier: Apache-2.0
// What MuJoCo's refusals of a text mean to who has to mend it.
#pragma once

#include <string>
#include <string_view>

#include "mjcf/text/refusals.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// All elements and attributes of a text that MuJoCo's schema does not have anywhere, each with its
/// line and the word that it is a slip of: MuJoCo's parser tells the first alone, and no word. Of
/// very many the first, and how many follow. A known word in the wrong place is left to MuJoCo.
Refusals unknown_words(const XmlFile& xml);

/// The text with the words that are meant, each on its line; attributes that are none are blanks.
/// Elements that are a slip of none stay.
std::string with_known_words(const XmlFile& xml);

/// How to mend what MuJoCo refuses with this message: a mesh file that it cannot read, or anything.
std::string cure_of_refusal(std::string_view message);

}  // namespace legwright
