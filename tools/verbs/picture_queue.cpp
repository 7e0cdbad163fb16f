// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/picture_queue.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <optional>

#include "tools/render/gl_context.hpp"
#include "tools/render/iteration_painter.hpp"
#include "tools/simulate/mujoco_host.hpp"

namespace legwright {

PictureQueue::PictureQueue(bool wanted) {
  if (!wanted) {
    closed_ = true;
    return;
  }
  try {
    pin_rasteriser();
    load_gait_plugin();
    thread_ = std::thread([this] { work(); });
  } catch (const std::exception& error) {
    failure_ = error.what();
    closed_ = true;
  }
}

PictureQueue::~PictureQueue() {
  {
    const std::lock_guard lock(mutex_);
    folders_.clear();
  }
  end();
}

void PictureQueue::add(const std::filesystem::path& design_folder) {
  {
    const std::lock_guard lock(mutex_);
    if (closed_) return;
    folders_.push_back(design_folder);
  }
  changed_.notify_one();
}

std::size_t PictureQueue::waiting() {
  const std::lock_guard lock(mutex_);
  return folders_.size() + (at_hand_ ? 1 : 0);
}

std::string PictureQueue::finish() {
  end();
  return failure_.empty() ? "" : "no pictures: " + failure_;
}

void PictureQueue::end() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  changed_.notify_one();
  if (thread_.joinable()) thread_.join();
}

bool PictureQueue::take(std::filesystem::path& folder) {
  std::unique_lock lock(mutex_);
  at_hand_ = false;
  changed_.wait(lock, [this] { return closed_ || !folders_.empty(); });
  if (folders_.empty()) return false;
  folder = folders_.front();
  folders_.pop_front();
  at_hand_ = true;
  return true;
}

void PictureQueue::work() {
  // Linux counts niceness by thread: on one core the optimization keeps three quarters of the
  // processor. The command waits for its pictures, so beside other programs they must not starve.
  constexpr int kNiceness = 5;
  const auto thread = static_cast<id_t>(::gettid());
  ::setpriority(PRIO_PROCESS, thread, std::max(::getpriority(PRIO_PROCESS, thread), kNiceness));
  try {
    const MujocoMessages messages;  // an error of the engine becomes an exception on this thread
    std::optional<IterationPainter> painter;
    for (std::filesystem::path folder; take(folder);) {
      if (!painter) painter.emplace(folder / "scene.xml");
      painter->paint(folder / "scene.xml", folder / "frame.png");
    }
  } catch (const std::exception& error) {
    const std::lock_guard lock(mutex_);
    failure_ = error.what();
    closed_ = true;
    at_hand_ = false;
    folders_.clear();
  }
}

}  // namespace legwright
