// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/job_runner.hpp"

#include <fmt/format.h>

#include "mjcf/text/input_error.hpp"

namespace legwright {

JobRunner::~JobRunner() { end(); }

void JobRunner::end() {
  const std::lock_guard lock(mutex_);  // first: nothing else begins meanwhile
  cancel();
  if (thread_.joinable()) thread_.join();
}

void JobRunner::start(const std::string& what, Work work) {
  const std::lock_guard lock(mutex_);
  if (running_) throw InputError("this goes on already; wait for it, or cancel it");
  if (thread_.joinable()) thread_.join();
  cancelled_ = false;
  what_ = what;
  running_ = true;
  thread_ = std::thread([this, work = std::move(work)] {
    try {
      work(*this);
    } catch (const std::exception& error) {
      if (!cancelled_) hub_.notice("error", error.what());
      tell({{"done", 0}, {"of", 0}, {"failed", cancelled_ ? "cancelled" : error.what()}}, false);
    }
    running_ = false;
  });
}

void JobRunner::cancel() {
  cancelled_ = true;
  const std::lock_guard lock(child_mutex_);
  if (child_) child_->stop();
}

void JobRunner::tell(Json json, bool running) {
  json["what"] = what_;
  json["running"] = running;
  if (!running) running_ = false;  // who hears of the end may ask for the next at once
  hub_.publish(kind_, to_line(json));
}

bool JobRunner::run(const std::string& words, const std::vector<std::string>& command, int also) {
  auto child = std::make_shared<ChildProcess>(command);
  {
    const std::lock_guard lock(child_mutex_);
    child_ = child;
  }
  if (cancelled_) child->stop();
  tell({{"words", words}, {"done", 0}, {"of", 0}}, true);
  std::string last;
  const int status = child->follow([&](const std::string& line) {
    const Json json = Json::parse(line, nullptr, false);
    if (!json.is_object() || !json.contains("stage")) {
      last = line;
      return;
    }
    tell({{"words", json.value("stage", words)},
          {"done", json.value("done", 0)},
          {"of", json.value("total", 0)}},
         true);
  });
  {
    const std::lock_guard lock(child_mutex_);
    child_.reset();
  }
  if (cancelled_) throw InputError("cancelled");
  if (status == 0) return true;
  if (status == also) return false;
  throw InputError(
      status < 0 ? fmt::format("{} died of signal {}: {}", command.at(1), -status, last) : last);
}

}  // namespace legwright
