// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/standing.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "optimizer/design/joint_torque.hpp"

namespace legwright {

using Eigen::Vector3d;
using Eigen::VectorXd;

std::vector<double> shares_of_weight(const Vector3d& com, const std::vector<Vector3d>& stance,
                                     double weight, double length, double least) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  const auto lever = [&](const Vector3d& foot) {
    return Vector3d(1.0, (foot.x() - com.x()) / length, (foot.y() - com.y()) / length);
  };
  for (const Vector3d& foot : stance) normal += lever(foot) * lever(foot).transpose();
  normal.diagonal().array() += 1e-3;  // two feet in line with the COM, or one
  const Vector3d multiplier = normal.inverse() * Vector3d(weight, 0.0, 0.0);
  std::vector<double> force;
  double sum = 0.0;
  for (const Vector3d& foot : stance) {
    force.push_back(std::max(least, multiplier.dot(lever(foot))));
    sum += force.back();
  }
  for (double& f : force) f *= weight / sum;
  return force;
}

VectorXd standing_torques(const Morphology& morphology, const VectorXd& s) {
  const GeometryAtDesign geometry(morphology, s);
  const PoseKinematics home = home_pose(morphology, geometry);
  PairMoments still;  // from the pose to itself: nothing swings
  still.compute(morphology, home, home);
  std::vector<Vector3d> feet;
  for (int j = 0; j < morphology.foot_count(); ++j)
    feet.push_back(foot_place(morphology, geometry, home, j));
  const Vector3d com = home.first_moment(0) / geometry.total_mass;
  const std::vector<double> shares =
      shares_of_weight(com, feet, geometry.total_mass * kGravity, morphology.leg_length, 0.0);
  VectorXd torques(morphology.joint_count());
  for (int a = 0; a < morphology.joint_count(); ++a) {
    std::vector<FootForce> forces;
    for (int j = 0; j < morphology.foot_count(); ++j) {
      const std::vector<int> chain = morphology.chain_to(morphology.feet[j].link);
      if (std::find(chain.begin(), chain.end(), a + 1) != chain.end())
        forces.push_back({j, shares[j] * Vector3d::UnitZ()});
    }
    torques[a] = JointTorque::value(morphology, geometry, {&home, &home, &home, &still, &still},
                                    a + 1, 1.0, forces);
  }
  return torques;
}

}  // namespace legwright
