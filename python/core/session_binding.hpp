// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nanobind/nanobind.h>

namespace legwright {

/// Binds _core.Session and what it hands out. python/legwright/_session.py is its face.
void bind_session(nanobind::module_& module);

}  // namespace legwright
