// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "mjcf/assembly/link_hulls.hpp"
#include "mjcf/assembly/outline_hulls.hpp"
#include "mjcf/assembly/robot_assembly.hpp"

namespace legwright {

/// How a design has turned the axes at the ends of a link, and with them the servos there, of the
/// limb as the file gives it.
struct LinkTurns {
  Eigen::Matrix3d own = Eigen::Matrix3d::Identity(), next = Eigen::Matrix3d::Identity();
};

/// What a link's length changes: the module at its far end, and the hulls that reach it. Both keep
/// clear of the servo that turns the link, and of what carries that, where they are as drawn.
class PrintedLink {
 public:
  /// Points into the limb. @param assembly one that is to be printed
  PrintedLink(const Assembly& assembly, const PlacedLimb& limb, std::size_t joint);

  /// Whether all is clear, and no larger than the bed or than as drawn, at so many times its
  /// length, with axes so turned.
  bool is_allowed(double scale, const LinkTurns& turns = {}) const;
  /// Whether its part lies on the bed as drawn.
  bool fits() const { return fits_; }

 private:
  /// The hull of points that stay, and others that turn with the axis, from the joint; seen from
  /// the link at that angle.
  struct Seen {
    OutlineHull still;
    std::vector<Eigen::Vector3d> turning;
    int sample = 0;  // turn_to_link()
  };
  /// What stays at least so far away [m].
  struct Near {
    Seen what;
    double least;
  };

  /// What carries a link's servo: the trunk with its cradle, or the parts of the link above.
  static std::vector<Seen> carrier_of(const Assembly& assembly, const PlacedLimb& limb,
                                      std::size_t joint);
  void find_what_is_near(const std::vector<Seen>& carrier);
  OutlineHull hull_of(const Seen& seen, const Eigen::Matrix3d& turn) const;
  /// The place at the far end in a link of that scale.
  Eigen::Vector3d place_at(double scale) const;
  OutlineHulls other_at(double scale, const LinkTurns& turns) const;
  /// The hulls; a capsule where there are none.
  OutlineHulls printed_at(double scale, const LinkTurns& turns) const;
  /// The largest distance of two points of the part, with a peg to the middle of a ball foot [m].
  double span(double scale, const LinkTurns& turns) const;

  LinkEnds ends_;
  double radius_;  // of a capsule [m]
  std::vector<LinkHull> hulls_;
  double clearance_;                       // [m]
  std::vector<Near> of_other_, of_parts_;  // of the module there, and of the part
  bool fits_ = true;
  double most_span_ = 0.0;  // [m]
};

}  // namespace legwright
