// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/design/inertia.hpp"
#include "optimizer/design/morphology.hpp"

namespace legwright {

/// One number that moves a part of the robot, seen at one pose and design. Numbers are counted within
/// [q; s]: pose first, then design. In homogeneous world coordinates every point p it moves obeys
/// ∂p/∂c = velocity · [p; 1], but for inner movers, whose points move each by their own slope.
struct Mover {
  enum class Kind { translation, rotation, inner };
  int coordinate;  // within [q; s]
  Kind kind;
  int link;              // moves this link and all below it; `inner`: this link's points only
  Eigen::Vector3d turn;  // rotation: spatial rate about the link's origin
  Eigen::Matrix<double, 3, 4> velocity;  // translation, rotation
  int inner_index = -1;                  // inner: entry of LinkAtDesign::inner
};

/// Second derivative of a link's own rotation: ∂²R/∂c_a∂c_b Rᵀ in the world frame, for two movers of one link.
struct SameLinkSecond {
  int a, b;  // indices of movers, a ≤ b; both rotations of the same link
  Eigen::Matrix3d second;
};

/// φ of eq (12) before it is summed up: where every link is at pose q and design s, and what moves it.
/// All outputs of kinematics (feet, COM, angular momentum) follow from this by the chain rule, because a mover
/// acts on everything below it as one rigid motion.
class PoseKinematics {
 public:
  /// @param q pose (root position, root rotation vector, joint angles) @param with_design also movers of s.
  void compute(const Morphology& morphology, const GeometryAtDesign& geometry,
               const Eigen::VectorXd& q, bool with_design);

  /// The same robot elsewhere: every world point p moved to turn·p + shift. Derivatives follow.
  PoseKinematics moved(const Eigen::Matrix3d& turn, const Eigen::Vector3d& shift) const;

  bool with_design() const { return with_design_; }
  const std::vector<Mover>& movers() const { return movers_; }
  const std::vector<SameLinkSecond>& same_link_seconds() const { return seconds_; }
  const Eigen::Matrix3d& rotation(int link) const { return rotation_[link]; }  // world ← link
  const Eigen::Vector3d& origin(int link) const { return origin_[link]; }      // world [m]
  /// 4×4 homogeneous transform world ← link.
  Eigen::Matrix4d transform(int link) const;

 private:
  void add_root(const Eigen::VectorXd& q);
  void add_link(const Link& link, int index, const LinkAtDesign& at, double angle, int design_start,
                bool with_design);
  void add_joint_movers(int index, const AxisAtDesign& axis, double angle,
                        const Eigen::Matrix3d& before, int design_start, bool with_design);
  void add_rotation(int link, int coordinate, const Eigen::Vector3d& turn);
  void add_translation(int link, int coordinate, const Eigen::Vector3d& rate);

  std::vector<Eigen::Matrix3d> rotation_;
  std::vector<Eigen::Vector3d> origin_;
  std::vector<Mover> movers_;
  std::vector<SameLinkSecond> seconds_;
  bool with_design_ = false;
};

/// True where link `upper` is `lower` or one of its ancestors; built once per morphology.
class Ancestry {
 public:
  Ancestry() = default;
  explicit Ancestry(const Morphology& morphology);
  bool contains(int upper, int lower) const { return table_(upper, lower); }
  bool strictly_above(int upper, int lower) const { return upper != lower && table_(upper, lower); }

 private:
  Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> table_;
};

/// A point y of the world as a function of [q; s] with exact derivatives. Columns number the coordinates that
/// the caller cares about; several effects may share a column (ties).
struct PointDerivatives {
  struct Effect {
    int column;
    int link;      // of the mover
    bool rotates;  // mover turns everything below it ...
    bool inner;    // ... or moves points inside its link
    Eigen::Vector3d turn;
    Eigen::Vector3d rate;  // ∂y/∂c
  };
  struct Second {
    int a, b;              // columns of two movers of one link
    Eigen::Vector3d rate;  // ∂²y/∂c_a∂c_b
    bool same;             // one and the same mover
  };
  Eigen::Vector3d value;
  std::vector<Effect> effects;
  std::vector<Second> seconds;

  /// Adds ∂y to `jacobian` (3 × columns).
  void add_jacobian(Eigen::Ref<Eigen::Matrix3Xd> jacobian) const;
  /// Adds Σ_k multiplier_k ∂²y_k to `hessian` (columns × columns, symmetric, both triangles).
  void add_curvature(const Ancestry& ancestry, const Eigen::Vector3d& multiplier,
                     Eigen::MatrixXd& hessian) const;
};

/// Which column a coordinate of [q; s] has; −1 where the output does not depend on it.
using Columns = std::vector<int>;

/// φ_EE of eq (12): the centre of a foot [m, world].
void foot_from_pose(const Morphology& morphology, const GeometryAtDesign& geometry,
                    const Ancestry& ancestry, const PoseKinematics& pose, int foot,
                    const Columns& columns, PointDerivatives& out);

/// φ_COM of eq (12): the robot's centre of mass [m, world].
void com_from_pose(const Morphology& morphology, const GeometryAtDesign& geometry,
                   const PoseKinematics& pose, const Columns& columns, PointDerivatives& out);

}  // namespace legwright
