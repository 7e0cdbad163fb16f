// SPDX-License-Identifier: Apache-2.0
// The points of a printed hull and how the design moves them.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "optimizer/design/morphology.hpp"

namespace legwright {

/// The points of a hull at a design, in the link frame [m], with exact first and second derivatives
/// by the parameters that move them.
class MovingPoints {
 public:
  /// Of points by one parameter, or by two: zero but for ends that `ends` has bits of.
  struct Moves {
    std::uint64_t ends = 0;
    std::vector<Eigen::Vector3d> steps;
  };
  std::vector<Eigen::Vector3d> points;
  std::vector<std::uint64_t> end_of;  // a bit by point; ends from the 64th on share one
  std::vector<Moves> first;           // by parameter
  std::vector<Moves> second;          // by pair(k, l), l ≤ k

  /// @param parameters that move points of the hull, rising
  MovingPoints(const HullPart& hull, const std::vector<int>& parameters, const Eigen::VectorXd& s);

  static std::size_t pair(std::size_t k, std::size_t l) { return k * (k + 1) / 2 + l; }

 private:
  void add(const HullPart::End& end, std::uint64_t bit, std::size_t count,
           const std::vector<int>& parameters, const Eigen::VectorXd& s);
};

}  // namespace legwright
