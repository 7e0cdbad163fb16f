// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "optimizer/design/morphology.hpp"

namespace legwright {

/// One stretch of a body, in its frame: a point p goes to p + d (d·p − c)(l/l₀ − 1).
struct Stretch {
  int parameter;
  Eigen::Vector3d direction;  // d, unit
  double initial;             // l₀ [m], the value in the file
  double still;               // c [m], where along d nothing moves: at the body's own hinge
};
/// The stretches of each body that has some, by MJCF name.
using StretchMap = std::map<std::string, std::vector<Stretch>>;

/// One coordinate of a site that a parameter places: p_axis = factor · s, in its body's frame.
struct Place {
  int parameter;
  int axis;  // 0, 1, 2: x, y, z
  double factor;
};
/// The places of each site that has some, by MJCF name.
using PlaceMap = std::map<std::string, std::vector<Place>>;

/// A point of a stretched body as a function of the design, in the body's frame.
AffineVector stretched_point(const Eigen::Vector3d& point, const std::vector<Stretch>& stretches);
/// The same for a site some of whose coordinates are placed: those follow their parameter alone.
AffineVector placed_point(const Eigen::Vector3d& point, const std::vector<Stretch>& stretches,
                          const std::vector<Place>& places);
/// The difference of two points of a stretched body.
AffineVector stretched_arm(const Eigen::Vector3d& arm, const std::vector<Stretch>& stretches);
/// A and t of the map p ↦ A p + t of a body's points at design s.
Eigen::Matrix3d stretch_matrix(const std::vector<Stretch>& stretches, const Eigen::VectorXd& s);
Eigen::Vector3d stretch_shift(const std::vector<Stretch>& stretches, const Eigen::VectorXd& s);

AffineVector sum(const AffineVector& a, const AffineVector& b);
AffineVector negative(const AffineVector& a);
AffineVector rotated(const Eigen::Matrix3d& rotation, const AffineVector& a);

}  // namespace legwright
