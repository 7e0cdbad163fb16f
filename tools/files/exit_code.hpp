// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace legwright {

/// Exit codes of the program.
enum ExitCode : int {
  kOk = 0,
  kInfeasible = 1,  // not feasible, or verdict fail
  kBadInput = 2,
  kIoError = 3,
  kInternal = 4,
  kStoppedEarly = 75,
  kInterrupted = 130,
};

}  // namespace legwright
