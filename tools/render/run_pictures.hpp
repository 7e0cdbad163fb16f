// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace legwright {

/// A picture that has been written.
struct MadePicture {
  std::filesystem::path file;
  double milliseconds = 0.0;
};

struct RunPictureOptions {
  bool all = false;  // also stills that exist already
  /// Called after each picture; may be empty.
  std::function<void(const MadePicture&)> on_picture{};
};

struct RunPictures {
  std::vector<MadePicture> made;
  std::vector<std::string> left_out;  // what could not be drawn yet, and what to run for it
};

/// Draws the pictures of a run folder: frame.png of every iteration, and in result/ the film strips
/// strip_initial, strip_result, strip_before_after (planned gait) and strip_physics (what the
/// simulation did, once validate has run). The plugins that its scenes name must have been loaded.
/// Throws GlError, std::system_error for files, std::runtime_error for files that do not fit
/// together.
RunPictures draw_run(const std::filesystem::path& run, const RunPictureOptions& options = {});

}  // namespace legwright
