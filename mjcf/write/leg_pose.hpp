// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "optimizer/design/inertia.hpp"
#include "optimizer/design/morphology.hpp"

namespace legwright {

/// A leg: the joints that move one foot and no other.
struct LegJoints {
  int foot = 0;
  std::vector<int> joints;  // from the trunk down; empty where the foot shares all of its joints
};
std::vector<LegJoints> legs_of(const Morphology& morphology);

/// A robot at one design that is put into poses (root position, root rotation vector, joint
/// angles), and inverse kinematics of one leg, for keyframes.
///
/// Not motion/whole_body_ik, which makes first guesses for the optimizer: there the trunk moves,
/// COM, feet and soles compete with weights and a few damped steps are enough. Here the trunk stays
/// where the keyframe has it, the foot's height and the level of a sole hold to rounding, because
/// MuJoCo starts from them, and what is left over stays near the angles of the file. Both share the
/// kinematics (design/kinematics), not the solver.
class PosedRobot {
 public:
  PosedRobot(const Morphology& morphology, const Eigen::VectorXd& s);
  /// Centre of a foot, world [m].
  Eigen::Vector3d foot(const Eigen::VectorXd& pose, int foot) const;
  /// Centre of a foot as seen from the hinge where its leg hangs on the trunk, world axes [m].
  Eigen::Vector3d reach(const Eigen::VectorXd& pose, const LegJoints& leg) const;
  /// Where the sole of a flat foot points, world axes; nothing for other feet.
  std::optional<Sole> sole(const Eigen::VectorXd& pose, int foot) const;

  /// How a leg shall stand.
  struct LegTarget {
    double height = 0.0;       // of the foot's centre [m]
    Eigen::Vector2d reach;     // in x and y [m]
    std::optional<Sole> sole;  // of a flat foot
  };
  /// Turns a leg's joints in `pose` until the foot's centre is at its height, a flat foot's sole is
  /// as level as wanted and, as far as that goes, its reach and the sole's heading are as wanted.
  /// Joints stay within their ranges, near where they start. False where the height is out of
  /// reach; `pose` is then of no use. A sole that no angles lay down stays tilted.
  bool solve(Eigen::VectorXd& pose, const LegJoints& leg, const LegTarget& target) const;

 private:
  struct LegState;
  class LegSolver;
  LegState evaluate(const Eigen::VectorXd& pose, const LegJoints& leg) const;

  const Morphology& morphology_;
  const Eigen::VectorXd s_;
  const GeometryAtDesign geometry_;
};

}  // namespace legwright
