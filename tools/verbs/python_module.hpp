// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace legwright {

/// Runs `python -m MODULE ARGUMENTS` with this program's own stdin, stdout and stderr and waits for
/// it. The interpreter is $LEGWRIGHT_PYTHON, or python3. Signals that ask to stop go on to it.
/// @param module of the package legwright, as "legwright.study"
/// @param extra of the package that the module needs, as "study"; for messages
/// @return its exit code. Throws IoError, with the way out, where there is no such interpreter or
/// it has no such module; std::runtime_error where a signal ended it.
int run_python_module(const std::string& module, const std::string& extra,
                      const std::vector<std::string>& arguments);

}  // namespace legwright
