// SPDX-License-Identifier: Apache-2.0
#include "mjcf/shape/growing_axes.hpp"

#include <cmath>

namespace legwright {
namespace {

constexpr double kAlong = 1.0 - 1e-9;  // cosine: parallel but for rounding
constexpr double kShortestRod = 0.5;   // of the link: a shorter one by pos is a motor or a pin

}  // namespace

Eigen::Vector3d half_sizes(int type, const mjtNum* size) {
  switch (type) {
    case mjGEOM_SPHERE:
      return Eigen::Vector3d::Constant(size[0]);
    case mjGEOM_CAPSULE:
    case mjGEOM_CYLINDER:
      return {size[0], size[0], size[1]};
    case mjGEOM_BOX:
    case mjGEOM_ELLIPSOID:
      return {size[0], size[1], size[2]};
    default:
      return Eigen::Vector3d::Zero();
  }
}

std::array<const Stretch*, 3> growing_axes(int type, const Eigen::Vector3d& half,
                                           const Eigen::Matrix3d& axes, bool from_to,
                                           const std::vector<Stretch>& stretches) {
  std::array<const Stretch*, 3> out{};
  const bool is_rod = type == mjGEOM_CAPSULE || type == mjGEOM_CYLINDER;
  if (!is_rod && type != mjGEOM_BOX) return out;
  for (const Stretch& stretch : stretches)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      if (std::abs(axes.col(axis).dot(stretch.direction)) <= kAlong) continue;
      const bool long_enough = from_to || 2 * half[axis] > kShortestRod * stretch.initial;
      if (is_rod ? k == 2 && long_enough : !from_to) out[k] = &stretch;
    }
  return out;
}

}  // namespace legwright
