// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace legwright {

/// A part of Legwright that is Python's.
struct PythonPart {
  std::string module;   // of the package legwright, as "legwright.study"
  std::string library;  // that it needs beside the package, as "distributed"
  std::string extra;    // of the package that brings the library, as "study"
};

/// Runs `python -m MODULE ARGUMENTS` with this program's own stdin, stdout and stderr and waits for
/// it. The interpreter is $LEGWRIGHT_PYTHON; without that python3 or python, the first that has the
/// package of this program's version, with the library. Signals that ask to stop go on to it.
/// @return its exit code. Throws IoError, with the way out, where there is no such interpreter;
/// std::runtime_error where a signal ended it.
int run_python_module(const PythonPart& part, const std::vector<std::string>& arguments);

}  // namespace legwright
