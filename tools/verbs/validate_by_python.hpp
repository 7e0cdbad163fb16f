// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace legwright {

/// What `legwright validate --engine drake` hands on.
struct PythonValidation {
  std::string run, engine, limits;  // no limits file: empty
  int cycles = 20;
  bool json = false;
};

/// Runs the validation of another engine, which is part of the Python package, in a process of its
/// own with this program's stdin, stdout and stderr. @return its exit code. Throws IoError, with
/// the way to get it, where no Python has the package of this program with that engine:
/// $LEGWRIGHT_PYTHON, without one python3 and python.
int validate_by_python(const PythonValidation& asked);

}  // namespace legwright
