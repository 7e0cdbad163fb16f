// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/layout.hpp"

namespace legwright {

Layout::Layout(const Morphology& morphology, int design_size, const Gait& gait, int planted_margin)
    : design_size_(design_size),
      knot_count_(gait.knot_count()),
      foot_count_(morphology.foot_count()),
      pose_size_(morphology.pose_size()),
      planted_margin_(planted_margin) {
  for (int knot = 0; knot <= knot_count_; ++knot) {
    KnotSlots slots{motion_size_, std::vector<int>(foot_count_, -1)};
    motion_size_ += pose_size_ + 3 + 3 * foot_count_;
    for (int foot = 0; foot < foot_count_; ++foot) {
      if (!gait.in_contact(knot, foot)) continue;
      slots.force[foot] = design_size_ + motion_size_;
      motion_size_ += 3;
    }
    knots_.push_back(std::move(slots));
  }
  derived_ = parameter_count();
  pair_derived_ = derived_ + (1 + foot_count_) * 3 * (knot_count_ + 1);
  torques_ = pair_derived_ + (1 + foot_count_) * 3 * (knot_count_ + 1);
  shapes_ = torques_ + joint_count() * knot_count_;
  amounts_ = shapes_ + 3 * static_cast<int>(morphology.linear_actuators.size());
  trunk_points_ = amounts_ + 2;
  trunk_point_count_ =
      joint_count() + foot_count_ + 2 * static_cast<int>(morphology.capsules.size());
  soles_ = trunk_points_ + 3 * trunk_point_count_ * knot_count_;
  inertia_ = soles_ + 6 * foot_count_ * (knot_count_ + 1);
  extended_size_ = inertia_ + 6;
}

Eigen::VectorXd Layout::motion_units(double length, double force) const {
  Eigen::VectorXd units = Eigen::VectorXd::Ones(motion_size_);
  for (int knot = 0; knot <= knot_count_; ++knot) {
    units.segment(pose(knot) - design_size_, 3).setConstant(length);
    units.segment(com(knot) - design_size_, 3 + 3 * foot_count_).setConstant(length);
    for (int slot : knots_[knot].force)
      if (slot >= 0) units.segment(slot - design_size_, 3).setConstant(force);
  }
  return units;
}

}  // namespace legwright
