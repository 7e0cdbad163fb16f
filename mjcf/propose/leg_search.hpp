// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace legwright {

/// A chain of hinges on the trunk, or on a waist that carries several, whose angles are searched
/// for with the file's own geoms: before anything is known of feet, as a robot that does not stand
/// has none. World axes.
struct SearchedLeg {
  std::vector<int> joints;                         // ids, from the trunk down
  std::vector<int> bodies;                         // of the last link
  std::vector<double> lower, upper;                // within which angles are searched [rad]
  double reach = 0.0;                              // farthest below the hinge above the knee [m]
  Eigen::Vector3d hip = Eigen::Vector3d::Zero();   // that hinge, at angles of rest [m]
  Eigen::Vector3d rest = Eigen::Vector3d::Zero();  // the foot, at angles of rest [m]
  std::vector<Eigen::Vector3d> anchors, axes;      // of the joints, at angles of rest [m]
  Eigen::Vector3d end = Eigen::Vector3d::Zero();   // the middle of the last link there [m]
  /// Level, along the knee's hinge at rest: the leg bends ahead and back of it.
  Eigen::Vector3d side = Eigen::Vector3d::UnitY();

  /// The hinge above the knee: the last but one.
  int hip_joint() const { return joints[joints.size() - 2]; }
  /// Where the last link reaches lowest: what collides, else what is drawn, else its frame.
  Eigen::Vector3d touch(const mjModel& model, const mjData& data) const;
  /// Where the leg bends to, level: square to `side`, towards +x, of a leg that bends along y +y.
  Eigen::Vector3d ahead() const;
  /// Below the hip in the plane in which the leg bends, as far beside it as at rest; of a leg that
  /// stands_beside() where the foot is at rest; height 0.
  Eigen::Vector3d below_hip() const;
  /// Whether its first hinge turns it about the vertical, as an insect's: then its knee bends it
  /// outwards, not ahead.
  bool turns_level() const;
  /// The same of a leg with a knee that can go up: it sprawls.
  bool sprawls() const;
  /// The same of a leg of two hinges, whose foot cannot come below its hip.
  bool stands_beside() const { return turns_level() && joints.size() == 2; }
  /// Level, from that hinge to the one above the knee; zero where both are in one place.
  Eigen::Vector3d outwards() const;
  /// Finds reach, hip, rest, side, anchors and axes; angles in `data` are as before then.
  void measure(const mjModel& model, mjData& data);
  /// The angles with which it is the mirror image of another leg, as that is held in `data`: hinges
  /// in their places (to 0.03 of the reach) and along their lines (to 0.05 rad), whatever either
  /// leg's zeros are. Nothing where it is no mirror image, or has not the range for them.
  /// Angles in `data` are as before then.
  /// @param trunk its place in the world
  /// @param plane signs of x, y, z in the image, of which one is negative
  std::optional<Eigen::VectorXd> mirror_of(const SearchedLeg& other, const Eigen::Vector3d& trunk,
                                           const Eigen::Vector3d& plane, const mjModel& model,
                                           mjData& data) const;
  Eigen::VectorXd angles_in(const mjModel& model, const mjData& data) const;
  void set_angles(const mjModel& model, mjData& data, const Eigen::VectorXd& angles) const;
  /// Brings the foot to a height by the least turn; false where a joint's range ends before.
  bool rise_to(double height, const mjModel& model, mjData& data) const;
  /// Turns the joints until the foot is at the height of `place` (to 1e-9 m) and otherwise near it,
  /// nearer in the plane in which the leg bends than beside it.
  /// False where the height is out of reach.
  /// @param knee where the knee had better go, a direction: back, or up of a leg that sprawls
  bool put(const mjModel& model, mjData& data, const Eigen::Vector3d& place,
           const Eigen::Vector3d& knee) const;

 private:
  /// The middle of what the last link collides with, or else draws.
  Eigen::Vector3d tip(const mjModel& model, const mjData& data) const;
  /// Where the hinges of a leg and the middle of its last link are in the mirror, held at rest.
  struct Image {
    std::vector<Eigen::Vector3d> anchors, axes;
    Eigen::Vector3d tip;
  };
  /// Whether it is such an image at some angles. @param own_zeros at angles of rest: then to 0.001
  /// @param at_rest its angles of rest; gets those at which it is the image
  bool turn_to_image(const Image& image, bool own_zeros, Eigen::VectorXd& at_rest,
                     const mjModel& model, mjData& data) const;
  /// rise_to() on the way to the angles of rest, from below; false where these are no higher.
  bool rise_towards_rest(double height, const mjModel& model, mjData& data) const;
};

}  // namespace legwright
