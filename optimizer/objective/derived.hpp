// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "optimizer/motion/path.hpp"
#include "optimizer/objective/derived/quantity.hpp"

namespace legwright {

/// y(s, m) with exact derivatives: all of the robot's kinematics. Values come first, for all terms
/// at once; a quantity's Jacobian and curvature are worked out when something asks for them. Which
/// quantities there are: objective/derived/quantities.cpp.
class DerivedQuantities {
 public:
  struct Workspace {
    RobotAtPoint robot;
    std::vector<std::unique_ptr<DerivedQuantity::State>> states;  // by quantity
    std::vector<Eigen::MatrixXd> jacobians;  // by quantity, columns × size; valid where `ready`
    std::vector<char> ready;
    Eigen::MatrixXd curvature;
    MotionLoads loads;
  };

  DerivedQuantities() = default;
  /// @param wanted by slot of the extended vector: only quantities that hold a wanted slot exist.
  DerivedQuantities(const Morphology& morphology, const Layout& layout, const Task& task,
                    const WantedPath& path, const std::vector<char>& wanted);

  const DerivedBlocks& blocks() const { return blocks_; }
  /// Where each block's y stands: a walk over all of them reads nothing else.
  struct Extent {
    int slot, size;
  };
  const std::vector<Extent>& extents() const { return extents_; }
  /// Fills the y part of `extended` ([s; m] given). `detail` says which derivatives may be asked
  /// for afterwards.
  void evaluate(const Morphology& morphology, const Layout& layout, PoseDetail detail,
                Eigen::VectorXd& extended, Workspace& workspace) const;
  /// ∂y of a block at the point just evaluated, columns × size.
  const Eigen::MatrixXd& jacobian(const Morphology& morphology, int block,
                                  const Eigen::VectorXd& extended, Workspace& workspace) const;
  /// Adds Σ_k multiplier_k ∂y_k/∂m of a block to `gradient` (as [s; m; y]) without its Jacobian and
  /// returns true; false: the block has no such way.
  bool add_motion_gradient(const Morphology& morphology, int block, const double* multiplier,
                           const Eigen::VectorXd& extended, const Workspace& workspace,
                           double* gradient) const;
  /// Makes workspace.loads those of the point just evaluated, none so far.
  void clear_loads(Workspace& workspace) const;
  /// Adds Σ_k multiplier_k ∂²y_k/∂m² of a block to workspace.loads and returns true; false:
  /// curvature() has the rest.
  bool add_loads(const Morphology& morphology, int block, const double* multiplier,
                 const Eigen::VectorXd& extended, Workspace& workspace) const;
  /// Σ multiplier_k ∂²y_k of a block whose Jacobian is ready, into the lower triangle of
  /// workspace.curvature.
  void curvature(int block, const double* multiplier, Workspace& workspace) const;

 private:
  void place_robot(const Morphology& morphology, const Layout& layout, PoseDetail detail,
                   const Eigen::VectorXd& extended, RobotAtPoint& robot) const;
  /// Columns that are wanted at this order of derivatives.
  static int columns_of(const DerivedQuantity& block, const Workspace& workspace);

  Ancestry ancestry_;
  WantedPath path_;
  DerivedBlocks blocks_;
  std::vector<Extent> extents_;  // by block
  bool needs_moments_ = false;
};

}  // namespace legwright
