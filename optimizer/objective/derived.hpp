// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/design/actuator_length.hpp"
#include "optimizer/design/growth.hpp"
#include "optimizer/design/inertia.hpp"
#include "optimizer/design/joint_torque.hpp"
#include "optimizer/design/kinematics.hpp"
#include "optimizer/design/momentum.hpp"
#include "optimizer/motion/layout.hpp"
#include "optimizer/motion/path.hpp"
#include "optimizer/motion/task.hpp"

namespace legwright {

/// One derived quantity y of Layout and the slots of p = [s; m] that it depends on.
struct DerivedBlock {
  enum class Kind {
    com,
    foot,
    anchor,
    capsule_end,
    sole_direction,
    momentum,
    foot_turn,
    joint_torque,
    actuator,
    mass_share,
    printed_volume
  };
  Kind kind;
  int slot, size;  // first and number of its slots of the extended vector
  int knot;        // knot T of a momentum: the wrapping pair
  int part;  // foot, end of a capsule, direction of a sole, link of an anchor or of a joint's torque, linear actuator
  std::vector<int> slots;  // column → slot of p; motion columns first
  int motion_columns;
  /// Coordinate of [q; s] → column, for each pose that matters: one; two for pairs; before, at, after for torques.
  Columns columns[3];
  int index;  // among the blocks whose derivatives have the same form
  std::vector<int> forces,
      feet;  // joint_torque: first slot of each force that the joint carries, and its foot
  std::vector<int> force_columns;
  int angles[3];    // joint_torque: slots of the joint's angle before, at and after the knot
  double armature;  // over h² [kg m²/s²]
};

/// y(s, m) with exact derivatives: all of the robot's kinematics. Values come first, for all terms at once; a block's
/// Jacobian and curvature are worked out when something asks for them.
class DerivedQuantities {
 public:
  struct Workspace {
    Eigen::VectorXd s;  // of `geometry`
    GeometryAtDesign geometry;
    std::vector<ActuatorShape> shapes;     // of the linear actuators, at `s`
    GrowthSum mass_share, printed_volume;  // in the units of Layout, at `s`
    std::vector<PoseKinematics> poses;  // knots 0 … T, then knot T − 1 moved back by one cycle
    std::vector<PairMoments> moments;   // knot i to i + 1; at T the wrapping pair
    std::vector<PointDerivatives> points;
    std::vector<PairDerivatives> pairs;
    std::vector<JointTorque> torques;
    std::vector<Eigen::MatrixXd> jacobians;  // by block, columns × size; valid where `ready`
    std::vector<char> ready;
    std::vector<FootForce> forces;
    Eigen::MatrixXd curvature;
  };

  DerivedQuantities() = default;
  /// @param wanted by slot of the extended vector: only blocks that hold a wanted slot exist.
  DerivedQuantities(const Morphology& morphology, const Layout& layout, const Task& task,
                    const WantedPath& path, const std::vector<char>& wanted);

  const std::vector<DerivedBlock>& blocks() const { return blocks_; }
  /// Fills the y part of `extended` ([s; m] given). `detail` says which derivatives may be asked for afterwards.
  void evaluate(const Morphology& morphology, const Layout& layout, PoseDetail detail,
                Eigen::VectorXd& extended, Workspace& workspace) const;
  /// ∂y of a block at the point just evaluated, columns × size.
  const Eigen::MatrixXd& jacobian(const Morphology& morphology, int block,
                                  const Eigen::VectorXd& extended, Workspace& workspace) const;
  /// Σ multiplier_k ∂²y_k of a block whose Jacobian is ready, into the lower triangle of workspace.curvature.
  void curvature(int block, const double* multiplier, Workspace& workspace) const;

 private:
  static void measure_amounts(const Morphology& morphology, Workspace& workspace);
  class BlockBuilder;
  PoseTriple triple(const DerivedBlock& block, const Workspace& workspace) const;
  void collect_forces(const DerivedBlock& block, const Eigen::VectorXd& extended,
                      Workspace& workspace) const;
  void place_block(const Morphology& morphology, const DerivedBlock& block,
                   Eigen::VectorXd& extended, Workspace& workspace) const;
  /// Columns that are wanted at this order of derivatives.
  static int columns_of(const DerivedBlock& block, const Workspace& workspace);
  void compute_torque(const Morphology& morphology, const DerivedBlock& block,
                      const Eigen::VectorXd& extended, Workspace& workspace) const;

  Ancestry ancestry_;
  WantedPath path_;
  std::vector<DerivedBlock> blocks_;
  int knot_count_ = 0, point_count_ = 0, pair_count_ = 0, torque_count_ = 0;
  double time_step_ = 1.0;
  Eigen::Vector3d up_ = Eigen::Vector3d::UnitZ();
  bool has_moments_ = false;
};

}  // namespace legwright
