// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "mjcf/text/xml.hpp"

namespace legwright {

/// `build` calls so the <text data="bed 0.22 0.22 m margin 0.004 m"> of a robot whose parts are to
/// be printed on that bed, and leave so much of it free at each side.
inline constexpr std::string_view kPrintText = "legwright_print";

/// Why the axis of a joint of such a robot is no design parameter where no servo turns with it.
inline constexpr const char* kAxesStay =
    "the parts are to be printed, and its servo does not turn with the axis, so that the next part "
    "would not lie on its horn; `turn` under [print] of the assembly lets axis and servo turn";

/// Whether a robot's file has that text.
inline bool is_to_be_printed(const XmlFile& xml) {
  return find_named(xml.root(), "text", kPrintText) != nullptr;
}

}  // namespace legwright
