// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/design/inertia.hpp"
#include "optimizer/design/morphology.hpp"
#include "optimizer/design/rotation.hpp"
#include "optimizer/design/small_products.hpp"

namespace legwright {

/// How one coordinate c of [q; s] (pose first, then design) moves the robot, seen at one pose and
/// design: as a twist, a rigid motion of every world point p below it, ∂p/∂c = turn × p + shift.
/// Inner ones are no rigid motions: they move the points of one link, each by its own slope.
struct Twist {
  enum class Kind { translation, rotation, inner };
  int coordinate;  // within [q; s]
  Kind kind;
  int link;               // moves this link and all below it; `inner`: this link's points only
  Eigen::Vector3d turn;   // spatial rate; zero but for rotations
  Eigen::Vector3d shift;  // velocity of the point at the world's origin
  int inner_index = -1;   // inner: entry of LinkAtDesign::inner
};

/// Second derivative of a link's own rotation: ∂²R/∂c_a∂c_b Rᵀ in the world frame, for two twists
/// of one link.
struct SameLinkSecond {
  int a, b;  // indices of twists, a ≤ b; both rotations of the same link
  Eigen::Matrix3d second;
};

/// How much of a pose is computed.
enum class PoseDetail {
  place,   // where every link is
  rates,   // + what moves it: first derivatives by the coordinates of the pose
  motion,  // + second derivatives
  design,  // + coordinates of the design
};

/// φ of eq (12) before it is summed up: where every link is at pose q and design s, and what moves
/// it. All outputs of kinematics (feet, COM, angular momentum, joint torques) follow from this by
/// the chain rule, because a twist acts on everything below it as one rigid motion.
class PoseKinematics {
 public:
  /// @param q pose (root position, root rotation vector, joint angles)
  void compute(const Morphology& morphology, const GeometryAtDesign& geometry,
               const Eigen::Ref<const Eigen::VectorXd>& q, PoseDetail detail);

  /// Makes this the robot `other` elsewhere: every world point p moved to turn·p + shift.
  /// Derivatives follow.
  void assign_moved(const PoseKinematics& other, const GeometryAtDesign& geometry,
                    const Eigen::Matrix3d& turn, const Eigen::Vector3d& shift);

  bool with_design() const { return detail_ == PoseDetail::design; }
  bool with_second() const { return detail_ == PoseDetail::motion || with_design(); }
  const std::vector<Twist>& twists() const { return twists_; }
  /// The twist of a coordinate of the pose; not with the design, which has twists between them.
  const Twist& twist_of(int coordinate) const {
    return twists_[static_cast<std::size_t>(coordinate)];
  }
  const std::vector<SameLinkSecond>& same_link_seconds() const { return seconds_; }
  const Eigen::Matrix3d& rotation(int link) const { return rotation_[link]; }  // world ← link
  const Eigen::Vector3d& origin(int link) const { return origin_[link]; }      // world [m]
  /// The link's frame before its joint turns it, world ← link at joint angle zero.
  const Eigen::Matrix3d& before(int link) const { return before_[link]; }
  /// Σ m p [u; 1]ᵀ over a link's point masses, p in the world, u in the link.
  const Eigen::Matrix<double, 3, 4>& moments(int link) const { return moments_[link]; }
  /// Σ m p over a link and all below it.
  const Eigen::Vector3d& first_moment(int link) const { return first_moment_[link]; }

 private:
  void place(const Morphology& morphology, const GeometryAtDesign& geometry,
             const Eigen::Ref<const Eigen::VectorXd>& q);
  void sum_moments(const Morphology& morphology, const GeometryAtDesign& geometry);
  void add_root(const RotationDerivatives& root);
  void add_joint_twists(int index, const AxisAtDesign& axis, double angle, int design_start);
  void add_rotation(int link, int coordinate, const Eigen::Vector3d& turn);
  void add_translation(int link, int coordinate, const Eigen::Vector3d& rate);

  std::vector<Eigen::Matrix3d> rotation_, before_;
  std::vector<Eigen::Vector3d> origin_, first_moment_;
  std::vector<Eigen::Matrix<double, 3, 4>> moments_;
  std::vector<Twist> twists_;
  std::vector<SameLinkSecond> seconds_;
  PoseDetail detail_ = PoseDetail::place;
};

/// The robot in its home pose, seen from its trunk: the world's frame is the trunk's. Places only,
/// no twists.
PoseKinematics home_pose(const Morphology& morphology, const GeometryAtDesign& geometry);

/// True where link `upper` is `lower` or one of its ancestors; built once per morphology.
class Ancestry {
 public:
  Ancestry() = default;
  explicit Ancestry(const Morphology& morphology);
  bool contains(int upper, int lower) const { return table_(upper, lower); }
  bool strictly_above(int upper, int lower) const { return upper != lower && table_(upper, lower); }
  /// By link: whether it is `lower` or one of its ancestors.
  const bool* above(int lower) const { return table_.col(lower).data(); }
  bool related(int a, int b) const { return table_(a, b) || table_(b, a); }
  /// From the root down to a link.
  const std::vector<int>& chain(int link) const { return chains_[static_cast<std::size_t>(link)]; }

 private:
  std::vector<std::vector<int>> chains_;
  Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> table_;
};

/// A point y of the world as a function of [q; s] with exact derivatives. Columns number the
/// coordinates that the caller cares about; several effects may share a column (ties).
struct PointDerivatives {
  struct Effect {
    int column;
    int link;            // of the twist
    bool rotates;        // twist turns everything below it ...
    bool inner = false;  // ... or moves points inside its link
    Eigen::Vector3d turn;
    Eigen::Vector3d rate;                             // ∂y/∂c
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();  // of the twist; sums over masses only
    double growth = 0.0;                              // of the mass it sums over, inner only
  };
  struct Second {
    int a, b;              // columns of two twists of one link
    Eigen::Vector3d rate;  // ∂²y/∂c_a∂c_b
    bool same;             // one and the same twist
  };
  /// Where y is a sum over a mass that grows, divided by it: relative slopes and second derivatives
  /// of the mass.
  struct Growth {
    int column;
    double slope;
  };
  struct GrowthSecond {
    int a, b;
    double second;
    bool same;
  };
  Eigen::Vector3d value;
  std::vector<Effect> effects;
  std::vector<Second> seconds;
  std::vector<Growth> growths;
  std::vector<GrowthSecond> growth_seconds;

  void clear(const Eigen::Vector3d& at);
  /// What a twist that is not inner does; its shift stays zero.
  void add(int column, const Twist& twist, const Scalars3& turn, const Scalars3& by_twist);
  /// Adds ∂y to `jacobian` (columns × 3).
  void add_jacobian(Eigen::MatrixXd& jacobian) const;
  /// Adds Σ_k multiplier_k ∂²y_k to the lower triangle of `hessian` (columns × columns).
  void add_curvature(const Ancestry& ancestry, const Eigen::Vector3d& multiplier,
                     Eigen::MatrixXd& hessian) const;

 private:
  void add_quotient_curvature(const Eigen::Vector3d& multiplier, Eigen::MatrixXd& hessian) const;
};

/// Adds a mixed second derivative to a lower triangle; a shared column counts both orders.
inline void add_pair(Eigen::MatrixXd& hessian, int a, int b, double value) {
  if (a == b)
    hessian(a, a) += 2.0 * value;
  else
    hessian(a > b ? a : b, a > b ? b : a) += value;
}

/// Which column a coordinate of [q; s] has; −1 where the output does not depend on it.
using Columns = std::vector<int>;

/// φ_EE of eq (12): the centre of a foot [m, world].
Eigen::Vector3d foot_place(const Morphology& morphology, const GeometryAtDesign& geometry,
                           const PoseKinematics& pose, int foot);
/// The same with what moves it.
void foot_from_pose(const Morphology& morphology, const GeometryAtDesign& geometry,
                    const Ancestry& ancestry, const PoseKinematics& pose, int foot,
                    const Columns& columns, PointDerivatives& out);

/// The direction of a unit vector that is fixed to a link, in the world.
void direction_from_pose(const Ancestry& ancestry, const PoseKinematics& pose, int link,
                         const Eigen::Vector3d& own, const Columns& columns, PointDerivatives& out);

/// An end of a capsule [m, world]: 2 k is `from` of capsule k, 2 k + 1 is `to`.
Eigen::Vector3d capsule_end_place(const Morphology& morphology, const GeometryAtDesign& geometry,
                                  const PoseKinematics& pose, int end);

/// A point that is fixed to a link, at `own` in its frame, seen from the trunk [m, trunk frame].
Eigen::Vector3d place_from_trunk(const PoseKinematics& pose, int link, const Eigen::Vector3d& own);
/// The same with what moves it: the joints between trunk and link and the design, not the trunk's
/// own coordinates. @param at where it is, place_from_trunk. @param own in the link's frame
void point_from_trunk(const Morphology& morphology, const Ancestry& ancestry,
                      const PoseKinematics& pose, int link, const Eigen::Vector3d& at,
                      const AffineVector& own, const Columns& columns, PointDerivatives& out);

/// Where a link's hinge is anchored [m, world]; its own joint does not move it.
void anchor_from_pose(const Ancestry& ancestry, const PoseKinematics& pose, int link,
                      const Columns& columns, PointDerivatives& out);

/// The direction of a link's hinge, a unit vector in the world; its own joint does not turn it.
void axis_from_pose(const Morphology& morphology, const GeometryAtDesign& geometry,
                    const Ancestry& ancestry, const PoseKinematics& pose, int link,
                    const Columns& columns, PointDerivatives& out);

/// scale · Σ m p over `link` and all below it [scale · kg m, world].
void first_moment_from_pose(const GeometryAtDesign& geometry, const Ancestry& ancestry,
                            const PoseKinematics& pose, int link, double scale,
                            const Columns& columns, PointDerivatives& out);

/// Derivatives of the mass of `link` and all below it, times scale; nothing where no mass grows.
void mass_from_pose(const GeometryAtDesign& geometry, const Ancestry& ancestry,
                    const PoseKinematics& pose, int link, double scale, const Columns& columns,
                    std::vector<PointDerivatives::Growth>& slopes,
                    std::vector<PointDerivatives::GrowthSecond>& seconds);

/// φ_COM of eq (12): the robot's centre of mass [m, world].
void com_from_pose(const GeometryAtDesign& geometry, const Ancestry& ancestry,
                   const PoseKinematics& pose, const Columns& columns, PointDerivatives& out);

}  // namespace legwright
