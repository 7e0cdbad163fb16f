// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tools/files/json_file.hpp"
#include "tools/studio/child_process.hpp"
#include "tools/studio/event_hub.hpp"

namespace legwright {

/// Long work in the background, one piece at a time, in processes of its own: a crash there is told
/// and harms nobody. Any thread may call.
class JobRunner {
 public:
  /// What a piece of work has: it is called on a thread of its own, and may throw.
  using Work = std::function<void(JobRunner&)>;

  /// @param kind of the events that tell of it @param hub must live longer
  JobRunner(EventHub& hub, std::string kind) : hub_(hub), kind_(std::move(kind)) {}
  ~JobRunner();  // cancels
  JobRunner(const JobRunner&) = delete;
  JobRunner& operator=(const JobRunner&) = delete;

  /// Throws InputError where some goes on already. @param what it is: told with all of it
  void start(const std::string& what, Work work);
  void cancel();
  /// Cancels, and returns once nothing goes on and nothing more is told.
  void end();

  // For the work itself:
  /// Runs a command and tells of its progress: lines {"stage", "done", "total"} of its messages.
  /// Throws InputError with its last message where it ends otherwise than by 0 or `also`.
  /// @return whether it ended by 0
  bool run(const std::string& words, const std::vector<std::string>& command, int also = 0);
  /// Tells followers: `running` goes with it. From an end on, start() waits for what is left of
  /// the work.
  void tell(Json json, bool running);
  bool cancelled() const { return cancelled_; }

 private:
  EventHub& hub_;
  std::string kind_, what_;
  std::atomic<bool> cancelled_ = false, running_ = false;
  std::mutex mutex_;
  std::thread thread_;
  std::shared_ptr<ChildProcess> child_;  // by child_mutex_
  std::mutex child_mutex_;
};

}  // namespace legwright
