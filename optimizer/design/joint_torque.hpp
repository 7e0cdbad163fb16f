// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/design/kinematics.hpp"
#include "optimizer/design/momentum.hpp"
#include "optimizer/design/motion_curvature.hpp"

namespace legwright {

/// What a joint's torque at one knot depends on: the poses of the knot before, the knot itself, the
/// knot after, the pair moments from each to the next; and where up is.
struct PoseTriple {
  const PoseKinematics *before, *at, *after;
  const PairMoments *to_at, *to_after;
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  // against gravity, unit vector
};

/// A force that a foot carries: which foot, and its force on the robot [N, world].
struct FootForce {
  int foot;
  Eigen::Vector3d force;
};

/// The torque τ that a joint's motor exerts, by inverse dynamics of the point masses:
///   τ = Σ_p m_p ∂p/∂q · ((p₋ − 2p + p₊)/h² + g u) + armature q̈
///       − Σ_j ∂(contact point of foot j)/∂q · f_j
/// over the masses and feet that the joint moves, u the unit vector against gravity. A ball foot of
/// radius r touches the ground r below its centre e. With A the joint's axis and o its anchor,
/// ∂p/∂q = A × (p − o), and because p × p = 0 this is A · N + armature q̈ with
///   N = (S − S₋)/h² + g C × u − o × K − Σ_j (e_j − r ẑ) × f_j,
///   K = (C₋ − 2C + C₊)/h² + g M u − Σ_j f_j,
/// S = Σ m p × p₊ the swept momentum, C = Σ m p the first moment, M the mass of what the joint
/// moves.
class JointTorque {
 public:
  /// Columns of the coordinates of [q; s] by pose, of this joint's angle in each, of the first
  /// force component by entry of `forces`. A coordinate of the design has the same column in all
  /// poses.
  struct Slots {
    const Columns *before, *at, *after;
    std::vector<int> force;
  };

  /// A · N [N m], without armature, damper and spring of the joint, which are linear in its angles.
  static double value(const Morphology& morphology, const GeometryAtDesign& geometry,
                      const PoseTriple& poses, int link, double time_step,
                      const std::vector<FootForce>& forces);
  /// Prepares the derivatives of the same.
  void compute(const Morphology& morphology, const GeometryAtDesign& geometry,
               const Ancestry& ancestry, const PoseTriple& poses, int link, double time_step,
               const std::vector<FootForce>& forces, const Slots& slots, int column_count);
  /// Adds ∂τ to `jacobian` (columns × 1).
  void add_jacobian(Eigen::MatrixXd& jacobian) const;
  /// Loads of the poses and pairs of PoseTriple.
  struct Loads {
    PoseLoads &before, &at, &after;
    PairLoads &to_at, &to_after;
  };
  /// Adds multiplier · ∂²τ/∂m² to `loads`, but for what add_products adds; where compute() had no
  /// coordinates of the design.
  void add_loads(const Morphology& morphology, const GeometryAtDesign& geometry,
                 const Ancestry& ancestry, const PoseTriple& poses, int link, double multiplier,
                 const Loads& loads) const;
  /// Adds what multiplier · ∂²τ has of products of first derivatives to the lower triangle of
  /// `hessian` (columns × columns).
  void add_products(double multiplier, Eigen::MatrixXd& hessian) const;
  /// Adds multiplier · ∂²τ to the lower triangle of `hessian` (columns × columns); where compute()
  /// had coordinates of the design.
  void add_curvature(const Ancestry& ancestry, double multiplier, Eigen::MatrixXd& hessian) const;

 private:
  struct Carried {
    PointDerivatives centre;  // of the foot's ball
    Eigen::Vector3d contact;  // e − r ẑ
    Eigen::Vector3d force;
    int foot, column;          // column: of the force
    Eigen::MatrixXd jacobian;  // of the centre
  };
  /// Vectors and their derivatives by the coordinates of the motion, and of the design, too.
  void derive_by_motion(const Morphology& morphology, const GeometryAtDesign& geometry,
                        const Ancestry& ancestry, const PoseTriple& poses, int link,
                        const Slots& slots);
  void derive(const Morphology& morphology, const GeometryAtDesign& geometry,
              const Ancestry& ancestry, const PoseTriple& poses, int link, const Slots& slots);
  void sum_parts();
  /// Factors of the first moments' and swept momenta's second derivatives, see add_curvature.
  struct Factors;
  Factors factors(double multiplier) const;

  double time_step_ = 1.0;
  Eigen::Vector3d up_;
  Eigen::Vector3d lever_;                // N
  Eigen::Vector3d rate_;                 // K
  Eigen::Vector3d axis_at_, anchor_at_;  // A, o
  PointDerivatives axis_, anchor_, moment_before_, moment_, moment_after_;
  PairDerivatives swept_before_, swept_;
  std::vector<Carried> feet_;
  std::vector<PointDerivatives::Growth> mass_slopes_;  // of g M
  std::vector<PointDerivatives::GrowthSecond> mass_seconds_;
  Eigen::MatrixXd axis_jacobian_, anchor_jacobian_, rate_jacobian_, lever_jacobian_;
  Eigen::MatrixXd moment_jacobian_;  // of C
};

}  // namespace legwright
