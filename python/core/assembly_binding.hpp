// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nanobind/nanobind.h>

namespace legwright {

/// Binds what builds robots of modules.
void bind_assembly(nanobind::module_& module);

}  // namespace legwright
