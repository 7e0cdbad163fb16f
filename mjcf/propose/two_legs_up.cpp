// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/two_legs_up.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "mjcf/text/model_arrays.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kHangs = 0.7;         // of the leg's length: the foot below the hip
constexpr double kAboveHips = 0.1;     // of the leg's length: what is no leg
constexpr double kNoLower = 0.05;      // of the leg's length: than the feet
constexpr double kHingeAcross = 0.95;  // cosine: a hinge about the line through the hips

double length_of_leg(const mjModel& model, const mjData& data, const SearchedLeg& leg) {
  double out = 0.0;
  Vector3d from = vector_at(data.xanchor, leg.joints.front());
  for (const int joint : leg.joints) {
    out += (vector_at(data.xanchor, joint) - from).norm();
    from = vector_at(data.xanchor, joint);
  }
  return out + (leg.touch(model, data) - from).norm();
}

/// The centre of mass of all that is no leg.
Vector3d centre_of_rest(const mjModel& model, const mjData& data, int trunk,
                        const std::vector<SearchedLeg>& legs) {
  double mass = model.body_subtreemass[trunk];
  Vector3d moment = mass * vector_at(data.subtree_com, trunk);
  for (const SearchedLeg& leg : legs) {
    const int hip = model.jnt_bodyid[leg.joints.front()];
    mass -= model.body_subtreemass[hip];
    moment -= model.body_subtreemass[hip] * vector_at(data.subtree_com, hip);
  }
  return moment / std::max(mass, 1e-9);
}

}  // namespace

bool plainly_stands_on_two(const mjModel& model, const mjData& data, int trunk,
                           const std::vector<SearchedLeg>& legs) {
  if (legs.size() != 2) return false;
  const Vector3d hips[] = {vector_at(data.xanchor, legs[0].joints.front()),
                           vector_at(data.xanchor, legs[1].joints.front())};
  const double length =
      std::max(length_of_leg(model, data, legs[0]), length_of_leg(model, data, legs[1]));
  Vector3d across = hips[1] - hips[0];
  if (std::abs(across.normalized().z()) > 1.0 - kHingeAcross || across.norm() < kNoLower * length)
    return false;
  across.normalize();
  double lowest = INFINITY;
  for (std::size_t k = 0; k < 2; ++k) {
    const SearchedLeg& leg = legs[k];
    const double foot = leg.touch(model, data).z();
    lowest = std::min(lowest, foot);
    if (hips[k].z() - foot < kHangs * length_of_leg(model, data, leg)) return false;
    if (std::none_of(leg.joints.begin(), leg.joints.end(), [&](int joint) {
          return std::abs(vector_at(data.xaxis, joint).dot(across)) > kHingeAcross;
        }))
      return false;
  }
  for (int g = 0; g < model.ngeom; ++g)
    if (model.body_rootid[model.geom_bodyid[g]] == trunk &&
        data.geom_xpos[3 * g + 2] < lowest - kNoLower * length)
      return false;
  const Vector3d above = centre_of_rest(model, data, trunk, legs) - 0.5 * (hips[0] + hips[1]);
  return above.z() > kAboveHips * length && above.z() > above.head<2>().norm();
}

}  // namespace legwright
