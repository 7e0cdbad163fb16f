// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "mjcf/assembly/outline_hulls.hpp"
#include "mjcf/assembly/robot_assembly.hpp"

namespace legwright {

/// A servo and the walls around it on the trunk.
Module with_cradle(Module servo);

/// Axes of limbs' first joints that one number turns, and the servos with them.
struct HipTurn {
  std::map<std::string, Eigen::Vector3d> about;  // by limb, in the trunk's axes, unit
  double low = 0.0, high = 0.0;                  // bounds of the angle [rad]
};

/// What length and width of the trunk change: the modules on it, which move with their places; and
/// what turns of hips do to them.
class PrintedTrunk {
 public:
  /// @param assembly one that is to be printed
  explicit PrintedTrunk(const Assembly& assembly);

  /// Whether modules are clear, and the tray lies on the bed or is no larger than as drawn, at so
  /// many times its sizes, with each of these turns at either of its bounds. (The first turns the
  /// others, where several are of one limb.)
  bool is_allowed(const Eigen::Vector3d& scale, const std::vector<HipTurn>& hips = {}) const;
  /// Whether the tray lies on the bed as drawn.
  bool fits() const { return lies_on_bed(drawn_size_); }

 private:
  struct Rider {
    Eigen::Vector3d place;  // of its body [m]
    OutlineHulls outline, core, cradle;
    std::string limb;  // of a servo
  };
  /// A rider at a scale, with each turn of its limb at either bound.
  struct PosedRider {
    std::vector<std::size_t> turns;          // of `hips`, whose bits in this order number the poses
    std::vector<OutlineHulls> outlines;      // by pose
    std::vector<OutlineHulls> cores;         // of these, within which modules never touch
    std::vector<Eigen::Vector3d> low, high;  // of cradles, by pose; none of other parts
  };

  bool lies_on_bed(const Eigen::Vector3d& size) const;
  /// How far two riders are apart, each in a pose; less than 0 where they are into each other, by
  /// as much as is passed over at most [m].
  static double distance(const PosedRider& one, std::size_t pose, const PosedRider& other,
                         std::size_t its_pose);
  PosedRider posed(const Rider& rider, const Eigen::Vector3d& scale,
                   const std::vector<HipTurn>& hips) const;
  std::vector<PosedRider> all_posed(const Eigen::Vector3d& scale,
                                    const std::vector<HipTurn>& hips) const;
  /// Of the tray with its cradles, along the axes, at most [m].
  Eigen::Vector3d size_of(const std::vector<PosedRider>& riders,
                          const Eigen::Vector3d& scale) const;

  Eigen::Vector2d room_;        // of the bed [m]
  Eigen::Vector3d drawn_size_;  // of the tray [m]
  double clearance_;            // [m]
  Eigen::Vector3d low_, high_;  // of its box [m]
  std::vector<Rider> riders_;
  std::vector<double> drawn_;  // distances of pairs of riders [m]
};

}  // namespace legwright
