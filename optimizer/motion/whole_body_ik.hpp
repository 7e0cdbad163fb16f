// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/design/kinematics.hpp"

namespace legwright {

/// How much each miss counts, by direction in the world.
struct WholeBodyIkWeights {
  Eigen::Vector3d com = Eigen::Vector3d::Constant(10.0);  // of (miss/leg length)²
  Eigen::Vector3d foot = Eigen::Vector3d::Ones();         // of each foot's (miss/leg length)²
  double sole = 1.0;                                      // of each direction of a flat foot's sole
  double pose = 1e-3;                                     // of (q − home)² over the joints
};

/// Inverse kinematics of the whole robot, for first guesses: a pose near the home pose whose COM
/// and feet are as near to wanted places as joints allow. Damped Gauss-Newton over root position
/// and all joints; the trunk's orientation is given. What cannot be met is spread over all wants,
/// and a few steps are enough, because Newton's method goes on from there. One leg under a trunk
/// that stays where it is, its foot's height to rounding: mjcf/leg_pose.
class WholeBodyIk {
 public:
  /// Keeps references.
  WholeBodyIk(const Morphology& morphology, const GeometryAtDesign& geometry,
              const WholeBodyIkWeights& weights);

  struct Places {
    Eigen::Vector3d com;                // [m, world]
    std::vector<Eigen::Vector3d> feet;  // centres [m, world]
    double heading = 0.0;               // of flat feet [rad]
  };
  /// Moves root position and joints of pose q, at most `steps` steps. Joints stay in their ranges.
  void improve(const Places& wanted, int steps, Eigen::VectorXd& q);
  /// Where COM and feet are at pose q.
  Places places_at(const Eigen::VectorXd& q);

 private:
  double misfit(const Places& wanted, const Eigen::VectorXd& q);
  void linearise(const Places& wanted, const Eigen::VectorXd& q);
  void add_point(const PointDerivatives& point, const Eigen::Vector3d& wanted,
                 const Eigen::Vector3d& weight);
  /// Calls visit(link, own, wanted) for both directions of each flat foot.
  template <class Visit>
  void for_each_sole_direction(double heading, const Visit& visit) const;
  Eigen::VectorXd stepped(const Eigen::VectorXd& q, double damping) const;

  const Morphology& morphology_;
  const GeometryAtDesign& geometry_;
  const WholeBodyIkWeights weights_;
  Ancestry ancestry_;
  Columns columns_;  // root position, then joints; −1: the root's rotation
  Eigen::VectorXd nominal_;
  std::vector<double> splay_;  // of flat feet in the home pose: heading of the sole [rad]
  PoseKinematics pose_;
  PointDerivatives point_;
  Eigen::MatrixXd jacobian_, normal_;
  Eigen::VectorXd slope_;
};

}  // namespace legwright
