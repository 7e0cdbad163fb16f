// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/design/kinematics.hpp"

namespace legwright {

/// Inverse kinematics of the whole robot, for first guesses: a pose near the home pose whose COM and
/// feet are as near to wanted places as joints allow. Least squares by Gauss and Newton, damped; the
/// trunk's orientation is given.
class Reach {
 public:
  /// Keeps references.
  Reach(const Morphology& morphology, const GeometryAtDesign& geometry);

  struct Wanted {
    Eigen::Vector3d com;                // [m, world]
    std::vector<Eigen::Vector3d> feet;  // centres [m, world]
  };
  /// Moves root position and joints of pose q, at most `steps` steps. Joints stay in their ranges.
  void improve(const Wanted& wanted, int steps, Eigen::VectorXd& q);

 private:
  double misfit(const Wanted& wanted, const Eigen::VectorXd& q);
  void linearise(const Wanted& wanted, const Eigen::VectorXd& q);
  void add_point(const PointDerivatives& point, const Eigen::Vector3d& wanted, double weight);
  Eigen::VectorXd stepped(const Eigen::VectorXd& q, double damping) const;

  const Morphology& morphology_;
  const GeometryAtDesign& geometry_;
  Ancestry ancestry_;
  Columns columns_;  // root position, then joints; −1: the the root's rotation
  Eigen::VectorXd nominal_;
  PoseKinematics pose_;
  PointDerivatives point_;
  Eigen::MatrixXd jacobian_, normal_;
  Eigen::VectorXd slope_;
};

}  // namespace legwright
