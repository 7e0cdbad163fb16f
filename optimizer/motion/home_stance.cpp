// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/home_stance.hpp"

#include <algorithm>
#include <limits>

#include "optimizer/design/inertia.hpp"
#include "optimizer/design/kinematics.hpp"

namespace legwright {
namespace {

/// Whether a link carries a foot other than this one.
bool is_shared(const Morphology& morphology, int link, int foot) {
  for (int j = 0; j < morphology.foot_count(); ++j) {
    const std::vector<int> chain = morphology.chain_to(morphology.feet[j].link);
    if (j != foot && std::find(chain.begin(), chain.end(), link) != chain.end()) return true;
  }
  return false;
}

}  // namespace

StyleTargets home_stance(const Morphology& morphology, const Eigen::VectorXd& s) {
  const GeometryAtDesign geometry(morphology, s);
  const PoseKinematics pose = home_pose(morphology, geometry);
  const Eigen::Vector3d com = pose.first_moment(0) / geometry.total_mass;
  StyleTargets stance;
  double ground = std::numeric_limits<double>::infinity();
  for (int j = 0; j < morphology.foot_count(); ++j) {
    const Eigen::Vector3d foot = foot_place(morphology, geometry, pose, j);
    stance.footprint.push_back((foot - com).head<2>());
    ground = std::min(ground, foot.z() - morphology.feet[j].radius);
  }
  stance.com_height = com.z() - ground;
  return stance;
}

std::vector<Eigen::Matrix2Xd> hip_slopes(const Morphology& morphology,
                                         const Eigen::VectorXd& initial) {
  const PoseKinematics pose = home_pose(morphology, GeometryAtDesign(morphology, initial));
  std::vector<Eigen::Matrix2Xd> slopes;
  Eigen::Matrix2Xd middle = Eigen::Matrix2Xd::Zero(2, initial.size());
  for (int j = 0; j < morphology.foot_count(); ++j) {
    Eigen::Matrix2Xd hip = Eigen::Matrix2Xd::Zero(2, initial.size());
    for (const int link : morphology.chain_to(morphology.feet[j].link)) {
      const int parent = std::max(0, morphology.links[link].parent);
      for (const AffineVector::Slope& slope : morphology.links[link].origin.slopes)
        hip.col(slope.parameter) += (pose.rotation(parent) * slope.slope).head<2>();
      if (!is_shared(morphology, link, j)) break;
    }
    middle += hip / morphology.foot_count();
    slopes.push_back(std::move(hip));
  }
  for (Eigen::Matrix2Xd& hip : slopes) hip -= middle;
  return slopes;
}

}  // namespace legwright
