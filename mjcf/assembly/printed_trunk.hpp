// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "mjcf/assembly/outline_hulls.hpp"
#include "mjcf/assembly/robot_assembly.hpp"

namespace legwright {

/// A servo and the walls around it on the trunk.
Module with_cradle(Module servo);

/// What length and width of the trunk change: the modules on it, which move with their places.
class PrintedTrunk {
 public:
  /// @param assembly one that is to be printed
  explicit PrintedTrunk(const Assembly& assembly);

  /// Whether modules are clear, and the tray lies on the bed or is no larger than as drawn, at so
  /// many times its sizes.
  bool is_allowed(const Eigen::Vector3d& scale) const;
  /// The trunk with the axes of the first joints of limbs turned, and the servos with them: what is
  /// allowed is still measured against the drawn one.
  /// @param turn of the limbs as the file gives them
  PrintedTrunk turned(const std::vector<std::string>& limbs, const Eigen::Matrix3d& turn) const;
  /// Whether the tray lies on the bed as drawn.
  bool fits() const { return lies_on_bed(drawn_size_); }

 private:
  struct Rider {
    Eigen::Vector3d place;  // of its body [m]
    OutlineHulls outline, cradle;
    std::string limb;       // of a servo
    bool mirrored = false;  // that
  };

  bool lies_on_bed(const Eigen::Vector3d& size) const;
  std::vector<std::pair<std::size_t, std::size_t>> pairs() const;
  /// The rider's outline or cradle, `of`, where a scale takes it.
  bool is_clear(const Eigen::Vector3d& scale) const;
  static OutlineHulls at(const OutlineHulls& of, const Rider& rider, const Eigen::Vector3d& scale);
  double distance(std::size_t i, std::size_t j, const Eigen::Vector3d& scale) const;
  /// Of the tray with its cradles, along the axes [m].
  Eigen::Vector3d size_at(const Eigen::Vector3d& scale) const;

  Eigen::Vector2d bed_;         // [m]
  Eigen::Vector3d drawn_size_;  // of the tray [m]
  double clearance_;            // [m]
  Eigen::Vector3d low_, high_;  // of its box [m]
  std::vector<Rider> riders_;
  std::vector<double> drawn_;  // distances of pairs() [m]
};

}  // namespace legwright
