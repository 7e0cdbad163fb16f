// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>

namespace legwright {

/// Draws frame.png into design folders on a thread of its own, at low priority, so that the
/// optimization never waits. A failure ends the pictures, never the run.
class PictureQueue {
 public:
  /// @param wanted false: does nothing at all
  explicit PictureQueue(bool wanted);
  /// Drops what is not drawn yet.
  ~PictureQueue();
  PictureQueue(const PictureQueue&) = delete;
  PictureQueue& operator=(const PictureQueue&) = delete;

  /// The folder's scene.xml will be drawn. The first folder sets the camera of all.
  void add(const std::filesystem::path& design_folder);
  /// How many are not drawn yet, the one at hand among them.
  std::size_t waiting();
  /// Waits until all is drawn. @return a warning, empty if all went well
  std::string finish();

 private:
  void work();
  bool take(std::filesystem::path& folder);
  void end();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::filesystem::path> folders_;
  bool closed_ = false, at_hand_ = false;
  std::string failure_;
  std::thread thread_;
};

}  // namespace legwright
