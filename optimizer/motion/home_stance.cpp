// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/home_stance.hpp"

#include <algorithm>
#include <limits>

#include "optimizer/design/inertia.hpp"
#include "optimizer/design/kinematics.hpp"

namespace legwright {

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

}  // namespace legwright
