// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

namespace legwright {

/// By how much a trunk's frame is turned about z from the plane in which its hips are mirrored
/// [rad], at most 45°: of several planes, and those square to them, the one nearest to an axis.
/// Nothing where that is an axis, of hips that no plane mirrors, and of fewer than four, of which
/// one pair alone says little.
/// @param hips [2 × hips] places on the trunk [m]
std::optional<double> askew_hips(const Eigen::Matrix2Xd& hips);

}  // namespace legwright
