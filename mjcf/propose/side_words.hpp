// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace legwright {

/// A name without the words that tell left from right and front from hind: "FL_thigh" and
/// "thigh_front_left" are both a thigh, as are "FrontLeftThigh" and "FLthigh". Empty where
/// nothing is left.
std::string without_side(const std::string& name);

/// 1 where a word of a name says front ("FL_thigh"), −1 where one says hind ("rear_left"), 0 where
/// none or both do.
int row_word(const std::string& name);

/// 1 where a word of a name says left ("FL_thigh", "arm_l", "LHip"), −1 where one says right, 0
/// where none or both do. A single letter within a name counts; of rows it may be anything.
int lateral_word(const std::string& name);

}  // namespace legwright
