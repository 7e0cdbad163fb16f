// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nanobind/nanobind.h>

#include <memory>

#include "tools/session/session.hpp"

namespace legwright {

struct CallsOfProcess;

/// A call from Python that gives up the interpreter's lock: the interpreter ends once it has the
/// lock again, as a thread that asks for the lock later is unwound by force. Once the interpreter
/// ends, calls of other threads are refused by SystemExit, which ends a thread without a word.
/// Made and gone with the lock.
class CallInFlight {
 public:
  CallInFlight();
  ~CallInFlight();
  CallInFlight(const CallInFlight&) = delete;

 private:
  CallsOfProcess* of_;  // a forked child has others
};

/// For nb::call_guard: gives up the lock for a call in flight.
struct Released {
  CallInFlight call;  // to the last
  nanobind::gil_scoped_release released;
};

/// Whether the interpreter ends, and not by this thread: what goes on here is to stop.
bool interpreter_ends();
/// Throws SystemExit there. Needs the lock.
void refuse_at_the_end();
/// Has a session closed before the interpreter ends.
void close_at_the_end(const std::shared_ptr<Session>& session);

/// Has Python end calls in flight before its interpreter ends.
void bind_calls(nanobind::module_& module);

}  // namespace legwright
