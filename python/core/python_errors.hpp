// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nanobind/nanobind.h>

#include "mjcf/text/input_error.hpp"

namespace legwright {

/// Lets the errors of the project arrive in Python as the classes of legwright/_errors.py.
void translate_errors();

/// The error as an instance of its class there, not raised. Needs the lock.
nanobind::object python_error(const InputError& error);

}  // namespace legwright
