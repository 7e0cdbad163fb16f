// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nanobind/nanobind.h>

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>

namespace legwright {

/// How the threads of a run have Python asked on the thread that called: one question at a time.
class Conversation {
 public:
  /// A run's thread: has `work` done on the calling thread, with the interpreter's lock, and waits
  /// for it. @return whether it came to an end; else it has raised, or was refused
  bool ask(const std::function<void()>& work);
  /// The run's thread: nothing more will come.
  void end();

  /// The calling thread: waits for work, the end, or a while. @return null without work
  const std::function<void()>* wait();
  void answer(bool done);
  /// The calling thread: does no work any more.
  void refuse();
  bool ended();

 private:
  std::mutex one_at_a_time_, mutex_;
  std::condition_variable changed_;
  const std::function<void()>* work_ = nullptr;
  std::optional<bool> done_;
  bool ended_ = false, refused_ = false;
};

/// What was thrown on the calling thread, kept until the run has stopped; only the first.
class KeptError {
 public:
  void keep(nanobind::python_error&& error) {
    if (!error_ && !other_) error_.emplace(std::move(error));
  }
  /// Calls `work`. @return whether it threw something
  template <class Work>
  bool caught(Work&& work) {
    try {
      work();
      return false;
    } catch (nanobind::python_error& error) {
      keep(std::move(error));
    } catch (const std::exception&) {  // not `...`, by which a thread may be unwound
      if (!error_ && !other_) other_ = std::current_exception();
    }
    return true;
  }
  void raise_if_any() {
    if (error_) throw std::move(*error_);
    if (other_) std::rethrow_exception(other_);
  }

 private:
  std::optional<nanobind::python_error> error_;
  std::exception_ptr other_;
};

}  // namespace legwright
