// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mjcf/read/mirror.hpp"
#include "mjcf/read/structure.hpp"
#include "mjcf/read/turning_parts.hpp"
#include "mjcf/shape/convex_hull.hpp"
#include "mjcf/text/robot_files.hpp"
#include "optimizer/design/design.hpp"
#include "optimizer/design/morphology.hpp"

namespace legwright {

/// What one design parameter changes in the file, by MJCF names.
struct Binding {
  struct Target {
    std::string name;                   // body (stretch), joint (axis) or site (place)
    std::optional<Across> mirror = {};  // ~ or ^: the turn's direction was mirrored (mirrored_turn)
    double factor = 1.0;  // this target has so many times the number: scaled tie, mirrored place
    int line = 0;         // of the <text> that declares it
    Eigen::Vector3d direction =
        Eigen::Vector3d::Zero();  // as it holds for this target, its body's frame, unit
    double still = 0.0;           // of a stretch: where along it nothing moves [m]
  };
  std::vector<Target> targets;
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  // of the first target, not mirrored
};

/// A servo as the file has it; gains are defaults from the torque limit where the file has no
/// position servo. All at the joint: a gear of the file is multiplied in.
/// Of a linear actuator all is meant along its tendon: [N/m], [N s/m], [N].
struct Servo {
  std::string actuator, joint;
  double kp = 0.0, kd = 0.0;           // [N m/rad], [N m s/rad]
  double torque_limit = 0.0;           // [N m]; infinite for a position servo without limit
  std::string tendon;                  // of a linear actuator; empty: the servo sits at the joint
  double joint_damping = 0.0;          // of the joint itself, besides kd [N m s/rad]
  std::optional<MotorLine> line = {};  // read/motor_lines
  double lag = 0.0;                    // of the file's actuator behind its control [s]
  bool integrates = false;             // whether that control is a rate
  double arm = 1.0;                    // of a linear actuator in the home pose [m]; else one [-]
  double mobility = 0.0;               // read/time_step [1/(kg m²)]
};

/// Gains of a servo to which nobody gave any: the error at which it gives all it has [rad], and kd
/// over kp [s].
inline constexpr double kFullTorqueError = 0.0375, kDampingTime = 0.015;

/// A printed part between modules: the convex hull of points, each of which goes with what it is
/// fixed to.
struct Connector {
  /// Points that go with one thing.
  struct End {
    std::string what;                     // of the declaration: "body FL_knee_servo"
    std::vector<Eigen::Vector3d> points;  // from there, in the axes of the mesh [m]
    std::string joint;                    // with whose axis they turn; empty: with none
    Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();  // mesh ← body of that joint
  };
  std::string mesh, body;            // of the file: its asset, and the body that shows it
  double density = 0.0;              // [kg/m3]
  std::vector<End> ends;             // whose points are `points`, in this order
  std::vector<AffineVector> points;  // in the body's frame
  std::vector<Facet> facets;         // of the hull at the initial design, indices of points
  int link = 0;                      // of the morphology, that it belongs to
  AffineVector origin;               // of the body, in that link's frame
  Eigen::Matrix3d link_from_body = Eigen::Matrix3d::Identity();
  std::ptrdiff_t first_mass = 0;  // of those of the link that stand for it
};

/// A robot as Legwright sees it: the compiled tree, its design parameters, and how to find them in
/// the file.
struct RobotModel {
  std::filesystem::path file;
  std::string xml;  // text of `files`; of a robot in one file that file, byte for byte
  RobotFiles files;
  Morphology morphology;
  DesignSpace space;
  std::vector<Binding> bindings;  // one for each entry of `space`
  std::vector<Servo> servos;      // in the order of the morphology's joints
  std::vector<Connector> connectors;
  std::vector<TurningPart> turning_parts;
  std::string root_body;    // MJCF name of the trunk
  bool in_degrees = false;  // angles of the file, but for those of keyframes
  Structure structure;      // what moves, what is held; the ids are those of each design
};

}  // namespace legwright
