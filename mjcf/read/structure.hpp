// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace legwright {

/// Where a foot touches the ground: a ball about a point that is fixed to its link. Radius zero:
/// the point itself, as the middle of a sole.
struct FootContact {
  std::string name;    // of the geom in scenes; the file's geom may have none
  int geom = -1;       // id in the compiled model; −1: a site, for which scenes have a geom
  int geom_type = -1;  // its mjtGeom, likewise
  int site = -1;
  Eigen::Vector3d share = Eigen::Vector3d::Zero();  // of the point, along the geom's axes: over its
                                                    // half sizes; of a mesh along the axes and in
                                                    // the units of its file, whatever its scale
  double radius = 0.0;                              // [m]
  /// Of a flat foot whose leg has hinges enough to lay it down: its sole's upward normal, in its
  /// body's frame.
  std::optional<Eigen::Vector3d> normal = {};
  /// Where several geoms make up such a foot that are no balls of one size: the middle of the face
  /// with which they touch, in the same frame; `share` is not used.
  std::optional<Eigen::Vector3d> middle = {};
  /// Balls of one sole, or plates of a fork, as low as this one: the point is the middle of all.
  std::vector<int> others;
};

/// A joint that the plan holds at its home pose.
struct FrozenJoint {
  int joint = -1;          // id in the compiled model
  std::string name, body;  // of the file; may be empty
  std::string why;         // "rides along …"
};

/// What moves in the plan, what is held, and where the robot touches the ground. The same for every
/// design of a robot.
struct Structure {
  int trunk = 0;                    // body id
  std::vector<bool> moves;          // by joint id: a hinge of a leg
  std::vector<bool> reads_tendon;   // by tendon id: a linear actuator of a leg
  std::vector<FootContact> feet;    // in order of their links
  std::vector<FrozenJoint> frozen;  // in order of joints
};

}  // namespace legwright
