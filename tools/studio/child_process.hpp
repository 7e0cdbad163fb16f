// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace legwright {

/// A program that runs beside this one, whose death is its own.
class ChildProcess {
 public:
  /// Starts it without a shell, with an empty input. Throws std::system_error where it cannot.
  explicit ChildProcess(const std::vector<std::string>& words);
  /// Ends it.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Reads all that it says, to its end. @param tell called with each line of its messages
  /// @return exit status, or minus the signal that ended it
  int follow(const std::function<void(const std::string&)>& tell);
  /// Asks it to end; from any thread, at any time.
  void stop();

 private:
  std::mutex mutex_;
  pid_t child_ = -1;  // by mutex_; −1 once it is gone
  int messages_ = -1;
};

}  // namespace legwright
