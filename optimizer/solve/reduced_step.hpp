// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace legwright {

/// Box of hard bounds on s, and the parameters' natural units.
struct DesignBox {
  Eigen::VectorXd lower, upper, scale;
};

/// Newton's step for F(s) = F(s, m*(s)) from its exact Hessian d²F/ds², within bounds: the
/// quadratic model's minimum over the parameters that are free, those that a step would carry past
/// a bound being put there first. Directions of negative curvature are followed downhill with the
/// curvature's absolute value. No entry changes by more than `largest_change` natural units.
/// @param hessian n × n, symmetric. @param gradient dF/ds. Returns Δs; s + Δs lies in the box. Zero
/// where nothing is free or a number is not finite.
Eigen::VectorXd reduced_newton_step(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& gradient,
                                    const Eigen::VectorXd& s, const DesignBox& box,
                                    double largest_change);

/// The model's least along the scaled gradient, within the same limits: never uphill, as Newton's
/// step is where the limits cut it much. Zero where the gradient is.
Eigen::VectorXd steepest_step(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& gradient,
                              const Eigen::VectorXd& s, const DesignBox& box,
                              double largest_change);

/// Change of F that the quadratic model promises for a step, gᵀΔs + ½ ΔsᵀBΔs.
double model_change(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& gradient,
                    const Eigen::VectorXd& step);

}  // namespace legwright
