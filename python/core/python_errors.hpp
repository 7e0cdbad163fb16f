// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace legwright {

/// Lets the errors of the project arrive in Python as the classes of legwright/_errors.py.
void translate_errors();

}  // namespace legwright
