// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tools/choose/tightening.hpp"

namespace legwright {

/// The problem's task file with the keys that make its tasks as tightened: F's numbers are the same
/// but for their last bits. Everything else stays as with_key() leaves it; a file without a name
/// gets that which it had. Empty where a number is out of the range of its key: levers know no
/// ranges. @param tightening of each task, in their order.
/// @param robot as the file shall name it
std::string tightened_text(const CodesignProblem& problem,
                           const std::vector<Tightening>& tightening, const std::string& robot);

}  // namespace legwright
