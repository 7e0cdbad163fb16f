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
  bool all = false;  // also frame.png of iterations that have one already
  /// Phases (0 … 1) of the planned gait of which to draw stills.
  std::vector<double> phases{};
  bool only_phases = false;  // nothing but these
  bool only_small = false;   // nothing but small.webp
  /// Called after each picture; may be empty.
  std::function<void(const MadePicture&)> on_picture{};
};

struct RunPictures {
  std::vector<MadePicture> made;
  std::vector<std::string> left_out;  // what could not be drawn yet, and what to run for it
};

/// Draws the pictures of a run folder: frame.png of every iteration, and in result/
/// - strip_initial.png, strip_result.png, strip_before_after.png: the planned gaits by phase;
/// - strip_physics.png, overlay.png, contact_timeline.png, once validate has run: what the
///   simulation did, the plan's ghost over it, and when each foot touched the ground;
/// - gait.webp: the gait in real time, a loop of at most kAnimationBytes;
/// - still_P.png and still_before_after_P.png for each phase P asked for;
/// - small.webp, where asked for: the result by the camera of iteration 0, for overviews.
/// Of a motion-only run there is nothing before: its strips have one row.
/// The plugins that its scenes name must have been loaded. Throws GlError, IoError where
/// another result stands there by now, std::system_error for files, std::runtime_error for files
/// that do not fit together.
RunPictures draw_run(const std::filesystem::path& run, const RunPictureOptions& options = {});

}  // namespace legwright
