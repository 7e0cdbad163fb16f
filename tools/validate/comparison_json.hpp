// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "tools/files/json_file.hpp"
#include "tools/validate/comparison.hpp"

namespace legwright {

/// result/comparison.json: plan against physics over the cycle, of the initial design and of the
/// result; null where the robot fell before two cycles. Names carry units; curves and paths are
/// rounded to six digits, because hundreds of numbers per quantity are for looking at.
Json comparison_json(const std::optional<Comparison>& initial,
                     const std::optional<Comparison>& result);

}  // namespace legwright
