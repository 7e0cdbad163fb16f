// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "optimizer/design/morphology.hpp"

namespace legwright {

/// I of the paper's eq (13): moments of inertia of the whole robot in its home pose about its
/// centre of mass, in the frame of the trunk [kg m²], at one design; constant over the motion. With
/// exact derivatives by the design.
struct HomeInertia {
  /// Entries of the symmetric matrix: xx, yy, zz, xy, xz, yz.
  using Entries = Eigen::Matrix<double, 6, 1>;
  Entries value;
  Eigen::MatrixXd jacobian;              // parameters × 6, in the order of `parameters`
  std::vector<Eigen::MatrixXd> hessian;  // of each entry, symmetric
};

HomeInertia home_inertia(const Morphology& morphology, const std::vector<int>& parameters,
                         const Eigen::VectorXd& s);

/// The matrix of such entries.
Eigen::Matrix3d symmetric_matrix(const HomeInertia::Entries& entries);

}  // namespace legwright
