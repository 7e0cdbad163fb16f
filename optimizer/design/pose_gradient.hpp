// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "optimizer/design/inertia.hpp"
#include "optimizer/design/kinematics.hpp"
#include "optimizer/design/momentum.hpp"
#include "optimizer/design/morphology.hpp"

namespace legwright {

// First derivatives of what kinematics computes in the coordinates of a pose whose detail is
// PoseDetail::rates or more, one pass over its twists. A gradient ∂(μ · y)/∂q is added to
// `gradient`, the pose_size entries of the pose, number by number as the Jacobian's columns times μ
// would: to the same bits. A Jacobian is added to columns × 3; `columns` tells where a coordinate
// of the pose stands. Of the design's coordinates PointDerivatives and PairDerivatives know.

/// y = a world point that is fixed to `link`.
void add_point_gradient(const Morphology& morphology, const PoseKinematics& pose, int link,
                        const Eigen::Vector3d& point, const Eigen::Vector3d& multiplier,
                        double* gradient);
void add_point_jacobian(const Morphology& morphology, const PoseKinematics& pose, int link,
                        const Eigen::Vector3d& point, const Columns& columns,
                        Eigen::MatrixXd& jacobian);

/// y = a point that is fixed to `link`, seen from the trunk. @param at there
void add_trunk_point_gradient(const Morphology& morphology, const PoseKinematics& pose, int link,
                              const Eigen::Vector3d& at, const Eigen::Vector3d& multiplier,
                              double* gradient);

/// y = a direction of the world that is fixed to `link`.
void add_direction_gradient(const Morphology& morphology, const PoseKinematics& pose, int link,
                            const Eigen::Vector3d& direction, const Eigen::Vector3d& multiplier,
                            double* gradient);
void add_direction_jacobian(const Morphology& morphology, const PoseKinematics& pose, int link,
                            const Eigen::Vector3d& direction, const Columns& columns,
                            Eigen::MatrixXd& jacobian);

/// y = scale · Σ m p over `link` and all below it; of link 0 by its mass φ_COM of eq (12).
void add_first_moment_gradient(const GeometryAtDesign& geometry, const Ancestry& ancestry,
                               const PoseKinematics& pose, int link, double scale,
                               const Eigen::Vector3d& multiplier, double* gradient);
void add_first_moment_jacobian(const GeometryAtDesign& geometry, const Ancestry& ancestry,
                               const PoseKinematics& pose, int link, double scale,
                               const Columns& columns, Eigen::MatrixXd& jacobian);

/// y = the swept momentum of `link` and all below it from one pose to the next, see
/// PairDerivatives.
void add_swept_momentum_gradient(const Ancestry& ancestry, const PairMoments& moments, int link,
                                 const PoseKinematics& first, const PoseKinematics& second,
                                 const Eigen::Vector3d& multiplier, double* first_gradient,
                                 double* second_gradient);
void add_swept_momentum_jacobian(const Ancestry& ancestry, const PairMoments& moments, int link,
                                 const PoseKinematics& first, const PoseKinematics& second,
                                 const Columns& first_columns, const Columns& second_columns,
                                 Eigen::MatrixXd& jacobian);

/// y = the turn of a foot from one pose to the next, see PairDerivatives.
void add_foot_turn_gradient(const Morphology& morphology, int foot, const PoseKinematics& first,
                            const PoseKinematics& second, const Eigen::Vector3d& multiplier,
                            double* first_gradient, double* second_gradient);
void add_foot_turn_jacobian(const Morphology& morphology, int foot, const PoseKinematics& first,
                            const PoseKinematics& second, const Columns& first_columns,
                            const Columns& second_columns, Eigen::MatrixXd& jacobian);

}  // namespace legwright
