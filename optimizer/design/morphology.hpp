// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace legwright {

inline constexpr double kGravity = 9.81;  // [m/s²]

/// A vector that is affine in the design, v(s) = constant + Σₖ s[parameter]·slope. Metres, in the
/// frame of the link that owns it. Stretching a body maps all its points this way.
struct AffineVector {
  struct Slope {
    int parameter;
    Eigen::Vector3d slope;
  };
  Eigen::Vector3d constant = Eigen::Vector3d::Zero();
  std::vector<Slope> slopes;  // each parameter at most once

  Eigen::Vector3d at(const Eigen::VectorXd& s) const;
};

/// A vector that a design turns about fixed directions of the link frame,
/// a(s) = R(about₁, f₁ s₁) R(about₂, f₂ s₂) … reference. As long for every s.
struct TurnedVector {
  struct Turn {
    int parameter;          // angle in s [rad]
    Eigen::Vector3d about;  // unit vector; already mirrored where the joint is the mirrored one
    double factor = 1.0;    // f: it turns by so many times the angle (scaled ties)
  };
  Eigen::Vector3d reference = Eigen::Vector3d::Zero();  // at angles zero
  std::vector<Turn> turns;                              // outermost first

  Eigen::Vector3d at(const Eigen::VectorXd& s) const;
};

/// Turns a vector by R(about₁, f₁ s₁) R(about₂, f₂ s₂) …
Eigen::Vector3d turned(const std::vector<TurnedVector::Turn>& turns, const Eigen::VectorXd& s,
                       Eigen::Vector3d vector);
/// Takes such turns back.
Eigen::Vector3d turned_back(const std::vector<TurnedVector::Turn>& turns, const Eigen::VectorXd& s,
                            Eigen::Vector3d vector);

/// A joint axis as a function of the design: a unit vector.
using JointAxis = TurnedVector;

/// One of the point masses that stand for a body: same mass, centre and inertia. The mass of a
/// printed part grows with each stretch that makes it longer, m(s) = mass · Π s[parameter]/initial;
/// without growth it is fixed.
struct PointMass {
  struct Growth {
    int parameter;
    double initial;  // [m]
  };
  double mass;            // [kg]; of a growing one at the initial design
  AffineVector position;  // in the link frame, without the arm
  std::vector<Growth> growth = {};
  double volume = 0.0;    // printed with it [m³], grows alike
  TurnedVector arm = {};  // from the position: of what turns as a joint's axis does

  /// Where it is, in the link frame.
  Eigen::Vector3d at(const Eigen::VectorXd& s) const { return position.at(s) + arm.at(s); }

  /// Π s[parameter]/initial
  double growth_at(const Eigen::VectorXd& s) const;
};

/// What a motor gives at a speed: τ ≤ stall_torque (1 − ω/no_load_speed) forwards, and the same
/// backwards; it brakes with more.
struct MotorLine {
  double stall_torque = 0.0;   // at rest [N m]
  double no_load_speed = 0.0;  // where nothing is left [rad/s]
};

/// The hinge that moves a link, and its servo.
struct Joint {
  std::string name;
  JointAxis axis{Eigen::Vector3d::UnitY(), {}};             // in the link frame
  double nominal = 0.0;                                     // angle in the robot's home pose [rad]
  double lower = -std::numeric_limits<double>::infinity();  // range [rad]
  double upper = std::numeric_limits<double>::infinity();
  double torque_limit = std::numeric_limits<double>::infinity();  // at any speed [N m]
  std::optional<MotorLine> line;  // where the motor is known; of linear actuators along it [N, m/s]
  double armature = 0.0;          // reflected rotor inertia [kg m²]
  // What the motor works against besides: a damper [N m s/rad], a spring [N m/rad] that is slack at
  // an angle [rad], dry friction [N m].
  double damping = 0.0, stiffness = 0.0, slack_angle = 0.0, friction_loss = 0.0;
  // Gains of the servo [N m/rad], [N m s/rad]; of a linear actuator those about the joint in the
  // home pose of the initial design.
  double servo_kp = 0.0, servo_kd = 0.0;
};

/// A rigid part of the robot. Its frame has the hinge's anchor as origin; fixed MJCF bodies are
/// merged into the link they ride on. Link 0 is the trunk, which has no joint.
struct Link {
  std::string name;
  int parent = -1;      // index below the link's own; −1: trunk
  AffineVector origin;  // of the frame, in the parent's frame
  Eigen::Matrix3d orientation = Eigen::Matrix3d::Identity();  // parent ← link at joint angle zero
  Joint joint;                                                // not used for the trunk
  std::vector<PointMass> masses;
};

/// A linear actuator between two points of neighbouring links, which drives the hinge between them.
/// Its length is L(q, s) (design/actuator_length); a force F that pushes its ends apart turns the
/// hinge with F ∂L/∂q. It has no mass of its own.
struct LinearActuator {
  std::string name;
  int joint = 0;          // joint a, which moves link a + 1
  AffineVector upper;     // attachment in the frame of the parent of link a + 1
  AffineVector lower;     // attachment in the frame of link a + 1
  double shortest = 0.0;  // stroke [m]
  double longest = std::numeric_limits<double>::infinity();
  double force_limit = std::numeric_limits<double>::infinity();  // [N]
};

/// The plane in which a flat foot stands: perpendicular unit vectors in the frame of its link.
/// Stretches leave them alone.
struct Sole {
  Eigen::Vector3d ahead = Eigen::Vector3d::UnitX();
  Eigen::Vector3d beside = Eigen::Vector3d::UnitY();
};

/// A ball foot at the end of a limb, or the middle of a flat one's sole.
struct Foot {
  std::string name;
  int link = 0;
  AffineVector position;          // centre of the ball, in the link frame
  double radius = 0.0;            // [m]
  std::optional<Sole> sole = {};  // of a flat foot on a limb with hinges enough to lay it down
};

/// A capsule that collides: all points within `radius` of a segment that is fixed to a link. Shapes
/// that are no capsules are covered by several, which share a `part`.
struct Capsule {
  int link = 0;
  int part = 0;
  AffineVector from, to;  // ends of the segment, in the link frame; one point for a ball
  double radius = 0.0;    // [m]
};

/// A capsule of the trunk and one of a limb that may not touch.
struct CapsulePair {
  int trunk = 0, limb = 0;
  double hidden = 0.0;  // how much nearer the shapes are than the capsules that stand for them [m]
};

/// The fixed kinematic tree of a robot whose measures depend on s. Joint a of a pose moves link
/// a + 1.
struct Morphology {
  std::string name;
  std::vector<Link> links;  // parents before children
  std::vector<Foot> feet;
  std::vector<LinearActuator> linear_actuators;
  std::vector<Capsule> capsules;
  std::vector<CapsulePair> capsule_pairs;
  double leg_length = 0.0;  // unit of length: first limb stretched, at the initial design [m]

  int joint_count() const { return static_cast<int>(links.size()) - 1; }
  int foot_count() const { return static_cast<int>(feet.size()); }
  /// Size of a pose q: root position, root axis-angle, joint angles.
  int pose_size() const { return 6 + joint_count(); }
  /// At the initial design [kg].
  double total_mass() const;
  /// Whether the mass of anything depends on the design.
  bool grows() const;
  Eigen::VectorXd nominal_joints() const;
  /// Links from the trunk's child down to `link`, in this order; empty for the trunk.
  std::vector<int> chain_to(int link) const;
};

/// Sum over a foot's chain of the distances from hinge to hinge to foot, at design s [m]. A ball
/// round the last hinge is a sole: the leg then ends at its surface.
double stretched_limb(const Morphology& morphology, int foot, const Eigen::VectorXd& s);

/// Whether all feet are flat.
bool stands_on_soles(const Morphology& morphology);

}  // namespace legwright
