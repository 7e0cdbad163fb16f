// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/limbs.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "optimizer/design/kinematics.hpp"
#include "optimizer/motion/faced_frame.hpp"

namespace legwright {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kMirroredAlike = 0.03;  // of the leg length: mirrored feet may differ by so much
constexpr double kRowShare = 0.2;  // of the feet's longer spread: closer along x, they share a row
constexpr double kNearAxis = 0.966;  // cosine of 15 degrees

/// How many links of a chain, from the trunk on, others hang on too.
int shared_links(const Morphology& morphology, const std::vector<int>& chain) {
  int shared = 0;
  for (const int link : chain) {
    int feet = 0;
    for (const Foot& foot : morphology.feet) {
      const std::vector<int> other = morphology.chain_to(foot.link);
      feet += std::count(other.begin(), other.end(), link) > 0;
    }
    if (feet > 1) ++shared;
  }
  return shared;
}

Vector3d seen_ahead(Vector3d in_trunk, const Vector2d& ahead) {
  in_trunk.head<2>() = as_faced(in_trunk.head<2>(), ahead);
  return in_trunk;
}

/// Makes partners of limbs that are mirror images. @param apart how far feet may be from that [m]
/// @return how many pairs
int pair_up(std::vector<Limb>& limbs, Across across, double middle,
            const std::vector<double>& apart) {
  int pairs = 0;
  for (std::size_t a = 0; a < limbs.size(); ++a)
    for (std::size_t b = a + 1; b < limbs.size(); ++b) {
      const Vector3d image = point_in_mirror(limbs[b].home, across, middle);
      if (limbs[a].partner >= 0 || limbs[b].partner >= 0 ||
          limbs[a].links.size() != limbs[b].links.size() ||
          (limbs[a].home - image).norm() > apart[a])
        continue;
      limbs[a].partner = static_cast<int>(b);
      limbs[b].partner = static_cast<int>(a);
      ++pairs;
    }
  return pairs;
}

}  // namespace

Across sides_across(const Vector2d& ahead) { return ahead.x() != 0.0 ? Across::y : Across::x; }

std::vector<Limb> find_limbs(const Morphology& morphology, const VectorXd& s,
                             const Vector2d& ahead) {
  const GeometryAtDesign geometry(morphology, s);
  const PoseKinematics home = home_pose(morphology, geometry);
  std::vector<Vector3d> feet;
  feet.reserve(static_cast<std::size_t>(morphology.foot_count()));
  for (int foot = 0; foot < morphology.foot_count(); ++foot)
    feet.push_back(foot_place(morphology, geometry, home, foot));
  double spread = 0.0;  // the longer one, as footfall_order() has it
  for (const Vector3d& one : feet)
    for (const Vector3d& other : feet)
      spread = std::max(spread, (one - other).head<2>().lpNorm<Eigen::Infinity>());
  std::vector<Limb> limbs;
  double last = 0.0;  // how far ahead the foot before stands
  for (const int foot : order_as_faced(feet, ahead)) {
    Limb limb;
    limb.foot = foot;
    limb.links = morphology.chain_to(morphology.feet[static_cast<std::size_t>(foot)].link);
    limb.shared = shared_links(morphology, limb.links);
    for (const int link : limb.links)
      limb.axes.push_back(seen_ahead(
          home.rotation(link) * geometry.links[static_cast<std::size_t>(link)].axis.axis, ahead));
    limb.home = feet[static_cast<std::size_t>(foot)];
    const double here = seen_ahead(limb.home, ahead).x();
    if (!limbs.empty()) limb.row = limbs.back().row + (last - here > kRowShare * spread ? 1 : 0);
    last = here;
    limbs.push_back(std::move(limb));
  }
  const Across across = sides_across(ahead);
  const auto side = static_cast<int>(across);
  Eigen::AlignedBox3d around;
  std::vector<double> apart;
  for (const Limb& limb : limbs) {
    around.extend(limb.home);
    apart.push_back(kMirroredAlike * stretched_limb(morphology, limb.foot, s));
  }
  std::vector<Limb> shifted = limbs;
  const int pairs = pair_up(limbs, across, 0.0, apart);
  const bool more =
      !limbs.empty() && pair_up(shifted, across, around.center()[side], apart) > pairs;
  return more ? shifted : limbs;
}

double middle_of_sides(const std::vector<Limb>& limbs, Across across) {
  constexpr double kOffMiddle = 0.1;  // of the spread of the feet: a frame is not in their middle
  const auto side = static_cast<int>(across);
  if (limbs.empty()) return 0.0;
  Eigen::AlignedBox3d around;
  double middles = 0.0;
  int paired = 0;
  for (const Limb& limb : limbs) {
    around.extend(limb.home);
    if (limb.partner < 0) continue;
    middles += limb.home[side];
    ++paired;
  }
  const double centre = around.center()[side];
  if (paired == 0) return std::abs(centre) > kOffMiddle * around.sizes()[side] ? centre : 0.0;
  const double at = middles / paired;
  return std::abs(at) <= std::abs(at - centre) ? 0.0 : centre;
}

std::string row_name(int row, int rows) {
  if (rows == 1) return "";
  if (row == 0) return "front";
  if (row == rows - 1) return "hind";
  return rows == 3 ? "middle" : fmt::format("row{}", row + 1);
}

std::string axis_name(const Vector3d& axis) {
  const char* const names[] = {"roll", "pitch", "yaw"};
  for (int k = 0; k < 3; ++k)
    if (std::abs(axis[k]) >= kNearAxis) return names[k];
  return "oblique";
}

}  // namespace legwright
