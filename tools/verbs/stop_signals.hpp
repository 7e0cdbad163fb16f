// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/verbs/handled_signals.hpp"

namespace legwright {

/// While one lives, signals that ask the program to end (HandledSignals) only ask to stop; a second
/// SIGINT ends the process at once. One at a time.
class StopSignals {
 public:
  StopSignals();

  /// The signal that came, or 0.
  static int received();
  /// Whether one came.
  static bool asked() { return received() != 0; }

 private:
  HandledSignals handled_;
};

}  // namespace legwright
