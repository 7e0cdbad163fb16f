// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/design/actuator_length.hpp"
#include "optimizer/design/inertia.hpp"
#include "optimizer/design/kinematics.hpp"
#include "optimizer/design/momentum.hpp"
#include "optimizer/motion/layout.hpp"
#include "optimizer/motion/path.hpp"
#include "optimizer/motion/task.hpp"

namespace legwright {

/// One derived quantity y (three numbers) of Layout and the slots of p = [s; m] that it depends on.
struct DerivedBlock {
  enum class Kind { com, foot, momentum, foot_turn, actuator };
  Kind kind;
  int slot;                // first of three
  int knot, foot;          // knot T of a momentum: the wrapping pair; actuator: its number as foot
  std::vector<int> slots;  // column → slot of p; motion columns first
  int motion_columns;
  Columns first, second;  // coordinate of [q; s] → column; `second` for pairs of poses
};

/// y(s, m) with exact derivatives: all of the robot's kinematics, evaluated once per point for all terms.
class DerivedQuantities {
 public:
  struct Workspace {
    Eigen::VectorXd s;  // of `geometry`
    GeometryAtDesign geometry;
    std::vector<ActuatorShape> shapes;  // of the linear actuators, at `s`
    std::vector<PoseKinematics> poses;  // knots 0 … T, then knot T − 1 moved back by one cycle
    std::vector<PointDerivatives> points;  // per block; unused for pairs
    std::vector<PairDerivatives> pairs;
    std::vector<Eigen::Matrix3Xd> jacobians;
    Eigen::MatrixXd curvature;
  };

  DerivedQuantities() = default;
  DerivedQuantities(const Morphology& morphology, const Layout& layout, const Task& task,
                    const WantedPath& path);

  const std::vector<DerivedBlock>& blocks() const { return blocks_; }
  /// Fills the y part of `extended` ([s; m] given) and, with_jacobian, the Jacobians.
  void evaluate(const Morphology& morphology, const Layout& layout, bool with_jacobian,
                bool with_design, Eigen::VectorXd& extended, Workspace& workspace) const;
  /// Σ multiplier_k ∂²y_k of a block at the point just evaluated, columns × columns, into workspace.curvature.
  void curvature(int block, const Eigen::Vector3d& multiplier, Workspace& workspace) const;

 private:
  void add_block(DerivedBlock::Kind kind, int slot, int knot, int foot,
                 const Morphology& morphology, const Layout& layout);
  void add_actuator_block(int actuator, const Morphology& morphology, const Layout& layout);

  Ancestry ancestry_;
  WantedPath path_;
  std::vector<DerivedBlock> blocks_;
};

}  // namespace legwright
