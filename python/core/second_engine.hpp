// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nanobind/nanobind.h>

namespace legwright {

/// Binds what lets Python play a gait in an engine of its own, and judge it as the program does.
void bind_engine(nanobind::module_& module);

}  // namespace legwright
