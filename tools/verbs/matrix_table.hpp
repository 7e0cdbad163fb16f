// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tools/run/matrix_record.hpp"

namespace legwright {

/// What `validate` tells people of several tasks: a line per design, a column per task with F and
/// what physics says. Columns are as wide as the longest name.
std::string matrix_table(const MatrixRecord& matrix);

}  // namespace legwright
