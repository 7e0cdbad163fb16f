// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/design/kinematics.hpp"
#include "optimizer/motion/layout.hpp"

namespace legwright {

/// Second-order correction of eq (12) for steps of Newton's method. A straight step in (s, m) moves
/// feet and COM along lines, joints too, so that φ(q, s) misses them afterwards by what is
/// quadratic in the step; the weight of eq (12) makes a wall of that, for which steps are cut to a
/// tenth. Here poses give way: after the step each pose is moved, with feet, COM and forces as they
/// are, until it misses them by what the linear model said. The path of corrected points has the
/// straight step as its tangent, so slopes and promises of the model hold for it.
/// One object per thread; it keeps references.
class PoseCorrection {
 public:
  /// @param units of the motion (Layout::motion_units): in these a pose moves as little as it can
  PoseCorrection(const Morphology& morphology, const Layout& layout, const Eigen::VectorXd& units);

  /// The point that steps set out from.
  void set_base(const Eigen::VectorXd& s, const Eigen::VectorXd& m);
  /// Moves the poses of m, which a straight step from the base led to; a pose of which that does
  /// not make the miss smaller stays. @param s design after the step
  void correct(const Eigen::VectorXd& s, Eigen::VectorXd& m);

 private:
  /// Eq (12) of one pose: its Jacobian by [q; s], and the pose's least move per miss.
  struct Knot {
    Eigen::VectorXd miss;
    Eigen::MatrixXd jacobian, pull_back;
  };
  int at(int slot) const { return slot - layout_.design_size(); }
  int miss_size() const { return 3 + 3 * layout_.foot_count(); }
  void take_design(const Eigen::VectorXd& s);
  /// φ(q_i, s) − (x_i, e_i) [m].
  void compute_miss(const Eigen::VectorXd& m, int knot, Eigen::VectorXd& out);
  void linearise(const Eigen::VectorXd& m, int index);
  /// What the linear model says of the miss after the step to m.
  void predict_miss(const Eigen::VectorXd& m, int index);
  void correct_pose(const Knot& knot, int index, Eigen::VectorXd& m);

  const Morphology& morphology_;
  const Layout& layout_;
  const Eigen::VectorXd& units_;
  Ancestry ancestry_;
  Columns columns_;
  Eigen::VectorXd base_s_, base_m_, geometry_s_;
  GeometryAtDesign geometry_;
  PoseKinematics pose_;
  PointDerivatives point_;
  std::vector<Knot> knots_;
  Eigen::MatrixXd rows_, scaled_, normal_;
  Eigen::VectorXd wanted_, miss_, best_;
};

}  // namespace legwright
