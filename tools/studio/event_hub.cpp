// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/event_hub.hpp"

#include <algorithm>
#include <utility>

#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

constexpr std::size_t kNoticesKept = 100;

}  // namespace

void EventHub::publish(std::string kind, std::string json, std::string key) {
  publish(std::vector<ToldEvent>{{std::move(kind), std::move(json), std::move(key)}});
}

void EventHub::publish(std::vector<ToldEvent> events) {
  {
    const std::lock_guard lock(mutex_);
    for (ToldEvent& event : events) {
      const std::string key = event.key.empty() ? event.kind : std::move(event.key);
      latest_[key] = {++count_, std::move(event.kind),
                      std::make_shared<const std::string>(std::move(event.json))};
    }
  }
  changed_.notify_all();
}

void EventHub::notice(const std::string& level, const std::string& words) {
  const Json json{{"level", level}, {"words", words}};
  auto text = std::make_shared<const std::string>(to_line(json));
  {
    const std::lock_guard lock(mutex_);
    notices_.push_back({++count_, "notice", std::move(text)});
    if (notices_.size() > kNoticesKept) notices_.erase(notices_.begin());
  }
  changed_.notify_all();
}

void EventHub::forget(const std::string& prefix) {
  const std::lock_guard lock(mutex_);
  std::erase_if(latest_, [&](const auto& entry) { return entry.first.starts_with(prefix); });
}

std::uint64_t EventHub::now() const {
  const std::lock_guard lock(mutex_);
  return count_;
}

std::vector<StudioEvent> EventHub::gather(std::uint64_t number, std::uint64_t joined) const {
  std::vector<StudioEvent> out;
  for (const auto& [key, event] : latest_)
    if (event.number > number) out.push_back(event);
  for (const StudioEvent& event : notices_)
    if (event.number > std::max(number, joined)) out.push_back(event);
  std::sort(out.begin(), out.end(),
            [](const StudioEvent& a, const StudioEvent& b) { return a.number < b.number; });
  return out;
}

std::vector<StudioEvent> EventHub::after(std::uint64_t number, std::uint64_t joined,
                                         std::chrono::milliseconds limit) const {
  std::unique_lock lock(mutex_);
  std::vector<StudioEvent> out;
  changed_.wait_for(lock, limit, [&] {
    out = gather(number, joined);
    return closed_ || !out.empty();
  });
  return out;
}

void EventHub::close() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  changed_.notify_all();
}

bool EventHub::closed() const {
  const std::lock_guard lock(mutex_);
  return closed_;
}

}  // namespace legwright
