// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "optimizer/objective/derived/quantity.hpp"

namespace legwright {

/// A derived vector in space whose derivatives have one of the forms of kinematics. A subclass
/// gives its value and fills in `Derivatives`, which knows the Jacobian and the curvature; where
/// the motion's alone are wanted there may be shorter ways.
template <class Derivatives>
class VectorQuantity : public DerivedQuantity {
 public:
  std::unique_ptr<State> make_state() const final { return std::make_unique<Held>(); }
  void value(const DerivedInput& input, State&, Eigen::Ref<Eigen::VectorXd> y) const final {
    y = place(input);
  }
  void jacobian(const DerivedInput& input, State& state, Eigen::MatrixXd& jacobian) const final {
    if (!input.with_design() && add_motion_jacobian(input, jacobian)) return;
    Derivatives& derivatives = static_cast<Held&>(state).derivatives;
    derive(input, derivatives);
    derivatives.add_jacobian(jacobian);
  }
  void curvature(const Ancestry& ancestry, const State& state, const double* multiplier,
                 Eigen::MatrixXd& hessian) const final {
    static_cast<const Held&>(state).derivatives.add_curvature(
        ancestry, Eigen::Map<const Eigen::Vector3d>(multiplier), hessian);
  }

 protected:
  VectorQuantity(const DerivedSetting& setting, int slot, const std::vector<int>& knots,
                 const Dependence& on)
      : DerivedQuantity(setting, slot, 3, knots, on) {}

 private:
  struct Held : State {
    Derivatives derivatives;
  };
  virtual Eigen::Vector3d place(const DerivedInput& input) const = 0;
  virtual void derive(const DerivedInput& input, Derivatives& out) const = 0;
  /// Adds ∂y/∂m and returns true, where add_loads does, too; false: derive() is asked.
  virtual bool add_motion_jacobian(const DerivedInput&, Eigen::MatrixXd& /*jacobian*/) const {
    return false;
  }
};

/// A point or direction of one pose.
class PoseQuantity : public VectorQuantity<PointDerivatives> {
 public:
  bool add_motion_gradient(const DerivedInput& input, const double* multiplier,
                           double* gradient) const final {
    add_pose_gradient(input, Eigen::Map<const Eigen::Vector3d>(multiplier),
                      gradient + pose_slot(0));
    return true;
  }

 protected:
  PoseQuantity(const DerivedSetting& setting, int slot, int knot, const Dependence& on)
      : VectorQuantity(setting, slot, {knot}, on), knot_(static_cast<std::size_t>(knot)) {}
  const PoseKinematics& pose(const DerivedInput& input) const { return input.robot.poses[knot_]; }
  const Columns& columns() const { return DerivedQuantity::columns(0); }
  PoseLoads& own(MotionLoads& loads) const { return loads.poses[knot_]; }

 private:
  /// Adds ∂(multiplier · y)/∂q to `gradient`, the entries of its pose.
  virtual void add_pose_gradient(const DerivedInput& input, const Eigen::Vector3d& multiplier,
                                 double* gradient) const = 0;
  std::size_t knot_;
};

}  // namespace legwright
