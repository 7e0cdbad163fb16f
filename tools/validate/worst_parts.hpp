// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "tools/run/verdict_record.hpp"
#include "tools/validate/measure.hpp"

namespace legwright {

/// Joints, feet or bodies that a measured value is of: at most three, the worst first, each with at
/// least half of what the worst has. None where all have nothing of it.
using WorstParts = std::function<std::vector<WorstPart>(const Measurements&)>;

/// @param value the more the worse
WorstParts worst_joints(std::function<double(const JointMetrics&)> value);
WorstParts worst_feet(std::function<double(const FootMeasures&)> value);

/// Those whose servos are at their limits the longest, with when that began.
std::vector<WorstPart> saturated_joints(const Measurements& run);
/// The two between which the hardest touch was, with when that was.
std::vector<WorstPart> touching_bodies(const Measurements& run);
/// That which passes over the lowest bar, of those that step.
std::vector<WorstPart> least_lifted_foot(const Measurements& run);

/// Greatest torque over the limit; 0 without a limit.
double torque_share(const JointMetrics& joint);

}  // namespace legwright
