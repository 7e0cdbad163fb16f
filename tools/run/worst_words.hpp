// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/run/verdict_record.hpp"

namespace legwright {

/// "; worst FL_knee and FR_knee"; of two bodies that touch "; hardest between A and B". Empty where
/// there are none.
/// @param value_words of a part, put in brackets where there are several; "" says nothing of it
std::string worst_words(const std::vector<WorstPart>& worst,
                        const std::function<std::string(const WorstPart&)>& value_words = {});

}  // namespace legwright
