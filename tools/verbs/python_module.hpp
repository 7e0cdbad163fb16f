// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace legwright {

/// A part of Legwright that is Python's.
struct PythonPart {
  std::string module;                  // of the package legwright, as "legwright.study"
  std::vector<std::string> libraries;  // that it needs beside the package, as "distributed"
  std::string extra;                   // of the package that brings them, as "study"
  std::string when_ended;              // what to do where a signal ended it
};

PythonPart study_part();
PythonPart drake_part();
PythonPart parts_part();

/// The interpreter that would run a part, or what is wrong with each that was tried.
struct PythonFound {
  std::string python;  // empty where there is none
  std::string lacks;
};

/// $LEGWRIGHT_PYTHON; without that python3 or python, the first that has the package of this
/// program's version, with the libraries.
PythonFound look_for_python(const PythonPart& part);

/// How to get the libraries of a part.
std::string python_cure(const PythonPart& part);

/// Runs `python -m MODULE ARGUMENTS` with this program's own stdin, stdout and stderr and waits for
/// it, by the interpreter of look_for_python(). Signals that ask to stop go on to it; where this
/// process is killed, it gets SIGTERM.
/// @return its exit code. Throws IoError, with the way out, where there is no such interpreter and
/// where a signal ended it.
int run_python_module(const PythonPart& part, const std::vector<std::string>& arguments);

}  // namespace legwright
