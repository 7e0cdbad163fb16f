// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "optimizer/design/inertia.hpp"
#include "optimizer/design/kinematics.hpp"
#include "optimizer/design/momentum.hpp"
#include "optimizer/design/morphology.hpp"

namespace legwright {

// Gradients ∂(μ · y)/∂q of what kinematics computes, one pass over the twists of a pose and no
// Jacobian: all that a gradient of F needs. Each adds to `gradient`, the pose_size entries of a
// pose whose detail is PoseDetail::rates or more, number by number as the Jacobian's columns times
// μ would: to the same bits.

/// y = a world point that is fixed to `link`.
void add_point_gradient(const Morphology& morphology, const PoseKinematics& pose, int link,
                        const Eigen::Vector3d& point, const Eigen::Vector3d& multiplier,
                        double* gradient);

/// y = a point that is fixed to `link`, seen from the trunk. @param at there
void add_trunk_point_gradient(const Morphology& morphology, const PoseKinematics& pose, int link,
                              const Eigen::Vector3d& at, const Eigen::Vector3d& multiplier,
                              double* gradient);

/// y = a direction of the world that is fixed to `link`.
void add_direction_gradient(const Morphology& morphology, const PoseKinematics& pose, int link,
                            const Eigen::Vector3d& direction, const Eigen::Vector3d& multiplier,
                            double* gradient);

/// y = φ_COM of eq (12).
void add_com_gradient(const GeometryAtDesign& geometry, const PoseKinematics& pose,
                      const Eigen::Vector3d& multiplier, double* gradient);

/// y = the swept momentum of the whole robot from one pose to the next, see PairDerivatives.
void add_swept_momentum_gradient(const PairMoments& moments, const PoseKinematics& first,
                                 const PoseKinematics& second, const Eigen::Vector3d& multiplier,
                                 double* first_gradient, double* second_gradient);

/// y = the turn of a foot from one pose to the next, see PairDerivatives.
void add_foot_turn_gradient(const Morphology& morphology, int foot, const PoseKinematics& first,
                            const PoseKinematics& second, const Eigen::Vector3d& multiplier,
                            double* first_gradient, double* second_gradient);

}  // namespace legwright
