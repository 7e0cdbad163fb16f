// SPDX-License-Identifier: Apache-2.0
// What printed hulls weigh, as functions of the design.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/design/morphology.hpp"

namespace legwright {

/// ∫ [u; 1][u; 1]ᵀ over a hull, u in the link frame [m], and its exact derivatives by the design:
/// second moments [m5], volume times centre [m4], volume [m3].
struct HullMoments {
  Eigen::Matrix4d moments = Eigen::Matrix4d::Zero();
  std::vector<int> parameters;         // that move corners, rising
  std::vector<Eigen::Matrix4d> first;  // in the order of `parameters`
  std::vector<std::vector<Eigen::Matrix4d>> second;
};

/// Parameters that move points of a hull, rising.
std::vector<int> hull_parameters(const HullPart& hull);

/// The points of a hull at a design, in the link frame [m].
std::vector<Eigen::Vector3d> hull_points(const HullPart& hull, const Eigen::VectorXd& s);

/// The triangles of a hull at a design: those of the design at hand where they still are its hull,
/// else made anew. A function of the design alone, whatever was asked before.
std::vector<Facet> hull_facets(const HullPart& hull, const std::vector<Eigen::Vector3d>& points);

/// Moments of a hull at a design. Where triangles change they are continuous, and derivatives are
/// those of one side: the volume, the largest that triangles over these points hold, has a kink
/// there.
HullMoments hull_moments(const HullPart& hull, const Eigen::VectorXd& s);

/// The same of the volume alone: the last entry of each matrix; others are zero.
HullMoments hull_volume(const HullPart& hull, const Eigen::VectorXd& s);

}  // namespace legwright
