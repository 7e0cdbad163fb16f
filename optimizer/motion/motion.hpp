// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "optimizer/motion/layout.hpp"

namespace legwright {

/// Named read-only views on a motion vector m, eq (2). World frame, SI units. Keeps references
/// only.
class MotionView {
 public:
  MotionView(const Layout& layout, const Eigen::VectorXd& m) : layout_(layout), m_(m) {}

  Eigen::VectorXd pose(int knot) const {
    return m_.segment(at(layout_.pose(knot)), layout_.pose_size());
  }
  Eigen::Vector3d com_W(int knot) const { return m_.segment<3>(at(layout_.com(knot))); }
  Eigen::Vector3d foot_W(int knot, int foot) const {
    return m_.segment<3>(at(layout_.foot(knot, foot)));
  }
  /// Zero where the foot swings.
  Eigen::Vector3d force_W(int knot, int foot) const {
    const int slot = layout_.force(knot, foot);
    return slot < 0 ? Eigen::Vector3d::Zero() : Eigen::Vector3d(m_.segment<3>(at(slot)));
  }

 private:
  int at(int slot) const { return slot - layout_.design_size(); }
  const Layout& layout_;
  const Eigen::VectorXd& m_;
};

}  // namespace legwright
