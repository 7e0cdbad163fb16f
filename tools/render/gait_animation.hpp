// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/image/webp.hpp"
#include "tools/render/gait_clip.hpp"

namespace legwright {

/// How many cycles an animation shows, and how often the pattern of the floor repeats so that it
/// joins at the end of the loop.
struct LoopFloor {
  int cycles = 1;
  std::array<double, 2> stretch{1.0, 1.0};  // of the pattern along x and y
};

/// @param travel of one cycle along x and y [m]. @param tile side of the floor's pattern [m], 0 if
/// it has none. At most two cycles, and a pattern stretched by no more than two fifths; where that
/// will not do, one cycle of the floor as it is, with a jump at the end.
LoopFloor loop_floor(const std::array<double, 2>& travel, double tile);

/// The gait in real time, ready to loop, the camera going along: of the last cycles that were
/// simulated where that passed its verdict, otherwise as planned. The picture says which.
Animation animate_gait(const GlContext& context, const GaitClip& clip);

/// What a file of it may have [bytes].
inline constexpr std::size_t kAnimationBytes = 500'000;

}  // namespace legwright
