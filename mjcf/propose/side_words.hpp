// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace legwright {

/// A name without the words that tell left from right and front from hind: "FL_thigh" and
/// "thigh_front_left" are both a thigh. Empty where nothing is left.
std::string without_side(const std::string& name);

}  // namespace legwright
