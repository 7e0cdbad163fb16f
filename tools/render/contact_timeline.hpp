// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tools/render/gait_clip.hpp"

namespace legwright {

/// Share of [from, to] that lies in the intervals, 0 … 1.
double covered(const std::vector<std::pair<double, double>>& intervals, double from, double to);

/// The planned stances of all cycles that begin before `end` [s].
std::vector<std::pair<double, double>> repeated(
    const std::vector<std::pair<double, double>>& of_one_cycle, double period, double end);

/// Bars over time for each foot: above when the plan has it stand, below when it touched the ground
/// in the simulation, in another colour where the plan has it swing. One block for each clip; all
/// need feet and a playback. `letters` draws the text.
Image contact_timeline(const std::vector<GaitClip>& clips, Renderer& letters);

}  // namespace legwright
