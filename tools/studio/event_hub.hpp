// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace legwright {

/// An event on its way to the page.
struct StudioEvent {
  std::uint64_t number = 0;  // rises
  std::string kind;          // "state", "motion", …
  std::shared_ptr<const std::string> json;
};

/// An event that is to be told.
struct ToldEvent {
  std::string kind, json;
  std::string key = {};  // under which a later event takes this one's place; empty: the kind
};

/// From those who make events to those who follow. Of each key only the latest is kept, so a slow
/// follower misses frames and never their order; notices are all told, as far as they are kept. Any
/// thread may call.
class EventHub {
 public:
  /// One. @param key as in ToldEvent
  void publish(std::string kind, std::string json, std::string key = {});
  /// Several that belong together: who follows is woken once and finds them all.
  void publish(std::vector<ToldEvent> events);
  /// One that is to be read, whatever comes after.
  void notice(const std::string& level, const std::string& words);
  /// Nothing of these keys is present any more: what starts with `prefix`.
  void forget(const std::string& prefix);

  /// Where a new follower begins: with everything present, without the notices of before.
  std::uint64_t now() const;
  /// What was published after `number` and still stands, in order, waiting up to `limit` for some.
  /// @param joined as now() told when the follower began: notices up to it are not told
  std::vector<StudioEvent> after(std::uint64_t number, std::uint64_t joined,
                                 std::chrono::milliseconds limit) const;
  /// Wakes all who wait, for good.
  void close();
  bool closed() const;

 private:
  std::vector<StudioEvent> gather(std::uint64_t number, std::uint64_t joined) const;

  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::uint64_t count_ = 0;
  std::map<std::string, StudioEvent> latest_;
  std::vector<StudioEvent> notices_;
  bool closed_ = false;
};

}  // namespace legwright
