// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/files/json_file.hpp"
#include "tools/validate/validation.hpp"

namespace legwright {

/// Everything that was measured in one roll-out; SI units in the names. What could not be measured
/// is null.
Json measurements_json(const Measurements& measurements);
/// {"half": {…}, "default": {…}, "double": {…}}
Json gains_json(const SceneValidation& validation);
/// {"pass": …, "line": …, "reasons": […]}
Json verdict_json(const Verdict& verdict);
/// The limits that the verdict was judged by.
Json limits_json(const Limits& limits);

}  // namespace legwright
