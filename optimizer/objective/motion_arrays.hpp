// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "optimizer/motion/layout.hpp"
#include "optimizer/objective/derived.hpp"
#include "optimizer/objective/evaluation.hpp"
#include "optimizer/objective/objective.hpp"

namespace legwright {

/// Body and motion as arrays of plain quantities, or the derivatives of a scalar by each of their
/// entries. One row a knot, T + 1 of them; the last is the first, one cycle later. World frame, SI
/// units. n joints, k feet.
struct MotionArrays {
  Eigen::VectorXd s;                                // design [m, rad]
  Eigen::MatrixXd joints;                           // n: positions [rad]
  Eigen::MatrixXd torques;                          // n: of the motors [N m]; row T is row 0
  Eigen::MatrixXd root;                             // 6: position [m], rotation vector [rad]
  Eigen::MatrixXd com;                              // 3 [m]
  Eigen::MatrixXd feet;                             // 3k: centre of each foot [m]
  Eigen::MatrixXd forces;                           // 3k: on each foot [N]; swing: zero
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(1);  // of the robot [kg]
  Eigen::VectorXd printed_volume = Eigen::VectorXd::Zero(1);  // of its printed parts [m³]

  /// Zeros in the shapes of a layout.
  explicit MotionArrays(const Layout& layout);
};

/// The arrays as functions of body and motion, with the chain rule through what follows from both:
/// torques, mass, printed volume.
class MotionEntries {
 public:
  /// Scratch memory of one thread, and the point it was last used at.
  struct Workspace {
    Eigen::VectorXd extended, gradient;  // [s; m; y]
    DerivedQuantities::Workspace derived;
  };

  /// @param objective for its robot and task; must live longer.
  explicit MotionEntries(const Objective& objective);
  /// @param with_gradient whether pull_back() follows
  MotionArrays arrays(const Eigen::VectorXd& s, const Eigen::VectorXd& m, bool with_gradient,
                      Workspace& workspace) const;
  /// ∂J/∂s and ∂J/∂m, as out.partial_s and out.stationarity, at the point of arrays().
  /// @param by_entry ∂J by each entry, all others fixed; forces of swing do not count
  void pull_back(const MotionArrays& by_entry, Workspace& workspace, Evaluation& out) const;

 private:
  template <class Arrays, class Visit>
  void visit(Arrays& arrays, const Visit& visit) const;

  const Objective& objective_;
  double mass_, volume_unit_;  // of the initial robot [kg]; [m³]
  DerivedQuantities derived_;
};

}  // namespace legwright
