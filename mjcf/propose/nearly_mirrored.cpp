// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/nearly_mirrored.hpp"

#include <fmt/format.h>

#include "optimizer/design/kinematics.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kNear = 0.3;  // of the leg length: feet farther from a mirror image are none

}  // namespace

std::vector<std::string> nearly_mirrored(const RobotModel& robot, const std::vector<Limb>& limbs,
                                         Across across) {
  std::vector<std::string> out;
  const double middle = middle_of_sides(limbs, across);
  const auto foot_of = [&](const Limb& limb) -> const Foot& {
    return robot.morphology.feet[static_cast<std::size_t>(limb.foot)];
  };
  for (std::size_t a = 0; a < limbs.size(); ++a)
    for (std::size_t b = a + 1; b < limbs.size(); ++b) {
      const Limb &one = limbs[a], &other = limbs[b];
      const auto side = static_cast<int>(across);
      const bool opposite = (one.home[side] - middle) * (other.home[side] - middle) < 0.0;
      if (one.partner >= 0 || other.partner >= 0 || !opposite ||
          one.links.size() != other.links.size())
        continue;
      const Vector3d off = one.home - point_in_mirror(other.home, across, middle);
      if (off.norm() > kNear * stretched_limb(robot.morphology, one.foot, robot.space.initial()))
        continue;
      out.push_back(fmt::format(
          "feet '{}' and '{}' would be mirror images but for {:.3g}, {:.3g}, {:.3g} mm in the home "
          "pose, so nothing ties their legs; mend the file if that is not meant",
          foot_of(one).name, foot_of(other).name, 1e3 * off.x(), 1e3 * off.y(), 1e3 * off.z()));
    }
  return out;
}

}  // namespace legwright
