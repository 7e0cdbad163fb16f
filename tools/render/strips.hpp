// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tools/render/gait_clip.hpp"

namespace legwright {

/// The planned gaits, one row for each clip: eight phases of one cycle by the same camera,
/// which goes along with the gait.
struct PlannedStrip {
  std::vector<StripRow> rows;
  std::vector<std::string> captions;
  StripLayout layout;
};
PlannedStrip planned_strip(const GlContext& context, const std::vector<GaitClip>& clips);

/// What the simulation did, at five moments from its start on: by one camera that stands
/// still, the way drawn on the floor. Every clip needs a playback.
Image physics_strip(const GlContext& context, const std::vector<GaitClip>& clips);

/// What the simulation did over the plan's ghost, at six phases of one late cycle: of the last
/// whole one that was recorded, where it fell of the one in which it fell. Every clip needs a
/// playback.
Image overlay_strip(const GlContext& context, const std::vector<GaitClip>& clips);

/// One phase (0 … 1) of the planned gait, 1280 × 960.
Image still(const GlContext& context, const GaitClip& clip, double phase);
/// The clips side by side at one phase, by the same camera.
Image still_side_by_side(const GlContext& context, const std::vector<GaitClip>& clips,
                         double phase);

}  // namespace legwright
