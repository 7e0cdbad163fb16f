// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/names_of_runs.hpp"

#include <algorithm>
#include <iterator>

namespace legwright {
namespace {

// What a run's folders hold beside the robot's own files.
constexpr std::string_view kNamesOfRuns[] = {"robot.xml",
                                             "scene.xml",
                                             "motion.csv",
                                             "metrics.json",
                                             "frame.png",
                                             "task.toml",
                                             "certificate.json",
                                             "verdict.json",
                                             "comparison.json",
                                             "numerics.json",
                                             "robustness.json",
                                             "matrix.json",
                                             "front.json",
                                             "overlay.png",
                                             "contact_timeline.png",
                                             "gait.webp",
                                             "strip_initial.png",
                                             "strip_result.png",
                                             "strip_physics.png",
                                             "strip_before_after.png",
                                             "playback_result.csv",
                                             "playback_initial.csv",
                                             "summary.md",
                                             "README.md"};

}  // namespace

bool is_name_of_runs(std::string_view name) {
  return name.substr(0, 6) == "still_" ||  // of `render --phase`
         std::find(std::begin(kNamesOfRuns), std::end(kNamesOfRuns), name) !=
             std::end(kNamesOfRuns);
}

}  // namespace legwright
