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

}  // namespace legwright
