// SPDX-License-Identifier: Apache-2.0
#include "python/core/calls.hpp"

#include <pthread.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace nb = nanobind;
using namespace nb::literals;

namespace legwright {

struct CallsOfProcess {
  std::mutex mutex;  // of all below
  std::condition_variable fewer;
  int in_flight = 0;
  bool ending = false;
  std::thread::id ender;
  std::vector<std::weak_ptr<Session>> sessions;
};

namespace {

/// Longer than a run takes to stop. A callback that does not return holds up no more than that.
constexpr std::chrono::seconds kLongest{10};

CallsOfProcess*& calls() {
  static auto* now = new CallsOfProcess;  // threads may outlive what ends at exit
  return now;
}

/// A forked child has the calls of one thread, and the sessions of none.
void begin_anew() { calls() = new CallsOfProcess; }

/// Stops what goes on in other threads, and waits until they have left.
void end_calls() {
  CallsOfProcess& all = *calls();
  std::vector<std::weak_ptr<Session>> sessions;
  {
    const std::lock_guard lock(all.mutex);
    all.ending = true;
    all.ender = std::this_thread::get_id();
    sessions.swap(all.sessions);
  }
  const nb::gil_scoped_release released;
  for (const std::weak_ptr<Session>& each : sessions)
    if (const std::shared_ptr<Session> session = each.lock()) session->close();
  std::unique_lock lock(all.mutex);
  all.fewer.wait_for(lock, kLongest, [&] { return all.in_flight == 0; });
}

}  // namespace

CallInFlight::CallInFlight() : of_(calls()) {
  refuse_at_the_end();
  const std::lock_guard lock(of_->mutex);
  ++of_->in_flight;
}

CallInFlight::~CallInFlight() {
  const std::lock_guard lock(of_->mutex);
  --of_->in_flight;
  of_->fewer.notify_all();
}

bool interpreter_ends() {
  CallsOfProcess& all = *calls();
  const std::lock_guard lock(all.mutex);
  return all.ending && all.ender != std::this_thread::get_id();
}

void refuse_at_the_end() {
  if (!interpreter_ends()) return;
  PyErr_SetNone(PyExc_SystemExit);
  nb::raise_python_error();
}

void close_at_the_end(const std::shared_ptr<Session>& session) {
  CallsOfProcess& all = *calls();
  const std::lock_guard lock(all.mutex);
  const auto gone = [](const std::weak_ptr<Session>& each) { return each.expired(); };
  all.sessions.erase(std::remove_if(all.sessions.begin(), all.sessions.end(), gone),
                     all.sessions.end());
  all.sessions.push_back(session);
}

void bind_calls(nb::module_& module) {
  (void)calls();
  pthread_atfork(nullptr, nullptr, begin_anew);
  module.def("end_calls", &end_calls,
             "Ends calls of other threads, before the interpreter does; later ones are refused.");
  nb::module_::import_("atexit").attr("register")(module.attr("end_calls"));
}

}  // namespace legwright
