// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/design/morphology.hpp"
#include "optimizer/motion/gait.hpp"

namespace legwright {

/// The index of every number: the only index arithmetic of the project. A slot is a position in the
/// extended vector [s; m; y]: the design, the motion of eq (2), and the derived quantities y(s, m)
/// that kinematics computes from them (feet, COM and hinges of a pose, angular momentum and foot
/// roll between two poses, joint torques of three).
/// m = (P_0 … P_T), P_i = (pose, com_W, foot_W of each foot, force_W of each stance foot). Knot T
/// is knot 0 one cycle later. Swing forces have no slot: they would be free and the Hessian
/// singular.
class Layout {
 public:
  Layout() = default;
  Layout(const Morphology& morphology, int design_size, const Gait& gait, int planted_margin);

  int design_size() const { return design_size_; }
  int motion_size() const { return motion_size_; }
  int parameter_count() const { return design_size_ + motion_size_; }  // size of p = [s; m]
  int extended_size() const { return extended_size_; }                 // size of [s; m; y]
  int knot_count() const { return knot_count_; }                       // T; knots run 0 … T
  int foot_count() const { return foot_count_; }
  int pose_size() const { return pose_size_; }
  int planted_margin() const { return planted_margin_; }

  int design(int k) const { return k; }
  int pose(int knot) const { return design_size_ + knots_[knot].start; }
  int com(int knot) const { return pose(knot) + pose_size_; }
  int foot(int knot, int foot) const { return com(knot) + 3 + 3 * foot; }
  /// First of three slots, or −1 where the foot swings.
  int force(int knot, int foot) const { return knots_[knot].force[foot]; }

  int joint_count() const { return pose_size_ - 6; }

  // Derived quantities, three slots each but for the torques.
  int com_from_pose(int knot) const { return derived_ + (1 + foot_count_) * 3 * knot; }
  int foot_from_pose(int knot, int foot) const { return com_from_pose(knot) + 3 + 3 * foot; }
  /// Σ m p_i × p_{i+1} over all point masses, knots i and i + 1, 0 ≤ i < T.
  int swept_momentum(int knot) const { return pair_derived_ + (1 + foot_count_) * 3 * knot; }
  /// The same from knot T − 1, moved back by one cycle, to knot 0.
  int wrapping_momentum() const { return swept_momentum(knot_count_); }
  /// Rotation vector of a foot's link from knot i to i + 1, to second order.
  int foot_turn(int knot, int foot) const { return swept_momentum(knot) + 3 + 3 * foot; }
  /// Torque of a joint's motor by inverse dynamics [N m], one slot; knots 0 … T − 1.
  int joint_torque(int knot, int joint) const { return torques_ + joint_count() * knot + joint; }
  /// A, B, C of a linear actuator's length (design/actuator_length) [leg length²]; they depend on s
  /// alone.
  int actuator_shape(int actuator) const { return shapes_ + 3 * actuator; }
  /// Mass of the robot over that of the initial design, one slot; depends on s alone.
  int mass_share() const { return amounts_; }
  /// Volume of its printed parts [leg length³], one slot; depends on s alone.
  int printed_volume() const { return amounts_ + 1; }
  /// Moments of inertia in the home pose, xx, yy, zz, xy, xz, yz [kg m²], six slots; depend on s
  /// alone.
  int home_inertia() const { return inertia_; }

  // Points seen from the trunk, for (16): three slots each, in the trunk's frame; knots 0 … T − 1.
  /// Where the hinge of link 1 … joint_count is anchored.
  int link_anchor(int knot, int link) const { return trunk_point(knot, link - 1); }
  /// The centre of a foot.
  int limb_end(int knot, int foot) const { return trunk_point(knot, joint_count() + foot); }
  /// End 0 or 1 of a capsule.
  int capsule_end(int knot, int capsule, int end) const {
    return trunk_point(knot, joint_count() + foot_count_ + 2 * capsule + end);
  }

  /// Where a foot's sole points ahead (0) or beside (1), a unit vector in the world; knots 0 … T.
  int sole_direction(int knot, int foot, int which) const {
    return soles_ + 6 * (foot_count_ * knot + foot) + 3 * which;
  }

  /// Physical unit of each entry of m (leg length, weight, radian): Newton damps in these.
  Eigen::VectorXd motion_units(double length, double force) const;

 private:
  int trunk_point(int knot, int which) const {
    return trunk_points_ + 3 * (trunk_point_count_ * knot + which);
  }

  struct KnotSlots {
    int start;               // within m
    std::vector<int> force;  // slot or −1
  };
  std::vector<KnotSlots> knots_;
  int design_size_ = 0, motion_size_ = 0, extended_size_ = 0, derived_ = 0, pair_derived_ = 0;
  int torques_ = 0, shapes_ = 0, amounts_ = 0, trunk_points_ = 0, soles_ = 0;
  int inertia_ = 0;
  int trunk_point_count_ = 0;  // of a knot
  int knot_count_ = 0, foot_count_ = 0, pose_size_ = 0, planted_margin_ = 1;
};

}  // namespace legwright
