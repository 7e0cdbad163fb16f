// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mjcf/read/mirror.hpp"
#include "mjcf/read/robot_model.hpp"

namespace legwright {

/// A leg as a chain of links from the trunk to a foot, and where it stands among the others.
struct Limb {
  int foot = 0;            // of the morphology
  std::vector<int> links;  // from the trunk's child down to the foot's
  int shared = 0;          // so many of them, from the first on, carry other limbs too: a waist
  std::vector<Eigen::Vector3d> axes;  // of the links' joints, home pose, x ahead and y to the left
  Eigen::Vector3d home =
      Eigen::Vector3d::Zero();  // centre of the foot, trunk's frame, home pose [m]
  int row = 0;                  // from front to hind
  int partner = -1;             // index of its mirror image left or right, −1: there is none
};

/// What left and right of a robot mirror each other across. @param ahead one of ±x, ±y
Across sides_across(const Eigen::Vector2d& ahead);

/// The limbs of a robot, front to hind, left before right: rows by where the feet stand in the home
/// pose, partners by geometry (same number of joints, feet mirrored to 0.03 of the leg), across the
/// plane through the trunk's frame, or, where that has fewer pairs, in the middle of the feet.
/// @param s the design. @param ahead where it faces: one of ±x, ±y of the trunk's frame
std::vector<Limb> find_limbs(const Morphology& morphology, const Eigen::VectorXd& s,
                             const Eigen::Vector2d& ahead = Eigen::Vector2d::UnitX());

/// Where the plane lies across which find_limbs() paired limbs: 0, or the middle of the feet. Of
/// limbs without pairs it is that middle where the trunk's frame is far off it [m].
double middle_of_sides(const std::vector<Limb>& limbs, Across across);

/// What the rows are called: front and hind, front, middle and hind; nothing for one row.
std::string row_name(int row, int rows);

/// "roll", "pitch" or "yaw" for an axis near x, y or z of the trunk; else "oblique".
std::string axis_name(const Eigen::Vector3d& axis);

}  // namespace legwright
