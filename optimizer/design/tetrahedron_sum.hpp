// SPDX-License-Identifier: Apache-2.0
// Sums over tetrahedra whose corners a design moves.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "optimizer/design/convex_hull.hpp"
#include "optimizer/design/moving_points.hpp"

namespace legwright {

/// ∫ [u; 1][u; 1]ᵀ over the solid within triangles, u in the link frame, as Σ V ∫ over tetrahedra
/// from the link's origin of volume one, V the signed volume of each; with exact first and second
/// derivatives. The slope by each point is summed first, for all that moves it; what is quadratic
/// in moves is summed by triangles.
class TetrahedronSum {
 public:
  /// xx, yy, zz, xy, xz, yz, x1, y1, z1, 11 of the symmetric matrix.
  using Entries = Eigen::Matrix<double, 10, 1>;

  /// @param points outlive the sum. @param volume_only the last entry alone; others stay zero
  TetrahedronSum(const MovingPoints& points, bool volume_only);

  void add(const Facet& facet);

  const Entries& value() const { return value_; }
  Entries first(std::size_t k) const { return along(points_.first[k]); }
  /// @param l ≤ k
  Entries second(std::size_t k, std::size_t l) const;

 private:
  /// The tetrahedron over a triangle.
  struct Tetrahedron {
    std::array<std::size_t, 3> corners{};
    std::array<Eigen::Vector3d, 3> places, normals;  // normals: 6 ∂V/∂place
    Eigen::Vector3d sum;                             // of places
    double volume = 0.0;
    Entries square;  // of volume one
    std::uint64_t ends = 0;
  };
  /// What the sum changes by where a point moves.
  struct PointSlope {
    Eigen::Matrix<double, 10, 3> by_volume = Eigen::Matrix<double, 10, 3>::Zero();
    Eigen::Vector3d by_place = Eigen::Vector3d::Zero();
    double volume = 0.0;
  };
  /// What a parameter does to one tetrahedron.
  struct Slope {
    std::size_t parameter = 0;
    std::array<Eigen::Vector3d, 3> steps, normals;
    Eigen::Vector3d sum;
    double volume = 0.0;
    Entries square;
  };

  Tetrahedron over(const Facet& facet) const;
  void add_pairs(const Tetrahedron& at);
  void fill(const Tetrahedron& at, std::size_t k, Slope& out) const;
  Entries along(const MovingPoints::Moves& moves) const;

  const MovingPoints& points_;
  const bool volume_only_;
  Entries value_ = Entries::Zero();
  std::vector<PointSlope> slopes_;
  std::vector<Entries> second_;  // without what bends of points add
  std::vector<Slope> own_;       // of the parameters that move the tetrahedron at hand
};

}  // namespace legwright
