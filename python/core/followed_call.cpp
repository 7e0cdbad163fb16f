// SPDX-License-Identifier: Apache-2.0
#include "python/core/followed_call.hpp"

#include <csignal>
#include <exception>
#include <thread>
#include <utility>

#include "python/core/calls.hpp"

namespace nb = nanobind;

namespace legwright {
namespace {

/// The thread of a call, which ends with it whatever is thrown there.
class WorkThread {
 public:
  WorkThread(FollowedCall& call, std::function<void()> work)
      : call_(call), thread_(std::move(work)) {}
  ~WorkThread() {
    call_.signal = SIGINT;
    call_.conversation.refuse();
    thread_.join();
  }
  WorkThread(const WorkThread&) = delete;

 private:
  FollowedCall& call_;
  std::thread thread_;
};

}  // namespace

void follow(FollowedCall& call, const std::function<void()>& work) {
  std::exception_ptr failure;
  {
    const Released released;
    const WorkThread thread(call, [&] {
      try {
        work();
      } catch (...) {
        failure = std::current_exception();
      }
      call.conversation.end();
    });
    while (!call.conversation.ended()) {
      const std::function<void()>* const asked = call.conversation.wait();
      const nb::gil_scoped_acquire held;
      const bool stopped = call.kept.caught([] {
        if (PyErr_CheckSignals() != 0) nb::raise_python_error();
      });
      if (stopped || interpreter_ends()) call.signal = SIGINT;
      if (asked != nullptr) call.conversation.answer(!call.kept.caught(*asked));
    }
  }
  call.kept.raise_if_any();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace legwright
