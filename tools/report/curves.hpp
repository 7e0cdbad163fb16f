// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tools/files/json_file.hpp"
#include "tools/report/curves_data.hpp"

namespace legwright {

/// Schema legwright/curves: variants, their runs by rising wanted speed, and what was measured of
/// each. SI units in the names; null where a robot fell.
Json curves_json(const Curves& curves);

/// The same as one self-contained HTML page: a card for each variant, charts against wanted speed,
/// a table.
std::string curves_page(const Curves& curves);

/// One drawing as SVG, a file of its own: F of the optimum against wanted speed, a line for each
/// variant, a dot where MuJoCo passes what was handed back and a ring where it fails it. Empty with
/// nothing to draw.
std::string curves_picture(const Curves& curves);

}  // namespace legwright
