// SPDX-License-Identifier: Apache-2.0
#include "python/core/conversation.hpp"

#include <chrono>
#include <utility>

namespace legwright {
namespace {

constexpr std::chrono::milliseconds kSignalInterval{50};

}  // namespace

bool Conversation::ask(const std::function<void()>& work) {
  const std::lock_guard alone(one_at_a_time_);
  std::unique_lock lock(mutex_);
  work_ = &work;
  done_.reset();
  changed_.notify_all();
  changed_.wait(lock, [this] { return done_.has_value() || refused_; });
  work_ = nullptr;
  return done_.value_or(false);
}

void Conversation::end() {
  const std::lock_guard lock(mutex_);
  ended_ = true;
  changed_.notify_all();
}

const std::function<void()>* Conversation::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, kSignalInterval, [this] { return ended_ || work_ != nullptr; });
  return std::exchange(work_, nullptr);
}

void Conversation::answer(bool done) {
  const std::lock_guard lock(mutex_);
  done_ = done;
  changed_.notify_all();
}

void Conversation::refuse() {
  const std::lock_guard lock(mutex_);
  refused_ = true;
  changed_.notify_all();
}

bool Conversation::ended() {
  const std::lock_guard lock(mutex_);
  return ended_;
}

}  // namespace legwright
