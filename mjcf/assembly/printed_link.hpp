// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "mjcf/assembly/link_hulls.hpp"
#include "mjcf/assembly/outline_hulls.hpp"
#include "mjcf/assembly/robot_assembly.hpp"

namespace legwright {

/// What a link's length changes: the module at its far end, and the hulls that reach it. Both keep
/// clear of the servo that turns the link, and of what carries that, where they are as drawn.
class PrintedLink {
 public:
  /// Points into the limb. @param assembly one that is to be printed
  PrintedLink(const Assembly& assembly, const PlacedLimb& limb, std::size_t joint);

  /// Whether all is clear, and no larger than the bed or than as drawn, at so many times its
  /// length.
  bool is_allowed(double scale) const;
  /// Whether its part lies on the bed as drawn.
  bool fits() const { return fits_; }

 private:
  /// What stays at least so far away [m].
  struct Near {
    OutlineHull hull;
    double least;
  };

  void find_what_is_near(const OutlineHulls& carrier);
  /// The place at the far end in a link of that scale.
  Eigen::Vector3d place_at(double scale) const;
  OutlineHulls other_at(double scale) const;
  /// The hulls; a capsule where there are none.
  OutlineHulls printed_at(double scale) const;
  /// The largest distance of two points of the part, with a peg to the middle of a ball foot [m].
  double span(double scale) const;

  LinkEnds ends_;
  double radius_;  // of a capsule [m]
  std::vector<LinkHull> hulls_;
  double clearance_;                       // [m]
  std::vector<Near> of_other_, of_parts_;  // of the module there, and of the part
  bool fits_ = true;
  double most_span_ = 0.0;  // [m]
};

}  // namespace legwright
