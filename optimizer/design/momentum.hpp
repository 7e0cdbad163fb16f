// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "optimizer/design/inertia.hpp"
#include "optimizer/design/kinematics.hpp"
#include "optimizer/design/morphology.hpp"
#include "optimizer/design/small_products.hpp"

namespace legwright {

/// Σ m p p′ᵀ over a link and all below it, for every link of a robot at two poses (p at the first,
/// p′ at the second): what angular momentum and joint torques are made of.
class PairMoments {
 public:
  void compute(const Morphology& morphology, const PoseKinematics& first,
               const PoseKinematics& second);
  int link_count() const { return static_cast<int>(below_.size()); }
  const Eigen::Matrix3d& below(int link) const { return below_[link]; }
  /// Σ m p × p′ over a link and all below it [kg m²].
  Eigen::Vector3d swept(int link) const;
  Scalars3 swept_scalars(int link) const {
    const Eigen::Matrix3d& X = below_[static_cast<std::size_t>(link)];
    return {X(1, 2) - X(2, 1), X(2, 0) - X(0, 2), X(0, 1) - X(1, 0)};
  }

 private:
  std::vector<Eigen::Matrix3d> below_;
};

template <class Matrix>
[[gnu::always_inline]] inline double trace(const Matrix& X) {
  return X(0, 0) + (X(1, 1) + X(2, 2));
}

/// ½ Σ_k (R e_k)(R′ e_k)ᵀ of a link: ½ R R′ᵀ.
Eigen::Matrix3d turn_moments(const PoseKinematics& first, const PoseKinematics& second, int link);

/// A vector that depends on two poses of one design, y = Σ weight p × p′ (p at the first pose, p′
/// at the second), with exact derivatives; the poses must outlive them. Columns: of the first pose,
/// of the second pose; a design coordinate has one column in both.
///
/// Two outputs have this form. The swept momentum Σ m p_i × p_{i+1} over the point masses of a link
/// and all below it: because p × p = 0, the rate of angular momentum Σ m p × (p₋ − 2p + p₊) is the
/// difference of two of them. And the turn of a foot, ½ Σ_k (R e_k) × (R′ e_k) =
/// ½ vee(R′Rᵀ − RR′ᵀ), its rotation vector to second order.
class PairDerivatives {
 public:
  Eigen::Vector3d value;

  /// Over the point masses of `link` (0: of the whole robot) and all below it.
  void compute_swept_momentum(const GeometryAtDesign& geometry, const Ancestry& ancestry, int link,
                              const PairMoments& moments, const PoseKinematics& first,
                              const PoseKinematics& second, const Columns& first_columns,
                              const Columns& second_columns);
  void compute_foot_turn(const Morphology& morphology, const Ancestry& ancestry, int foot,
                         const PoseKinematics& first, const PoseKinematics& second,
                         const Columns& first_columns, const Columns& second_columns);
  static Eigen::Vector3d foot_turn(const Morphology& morphology, int foot,
                                   const PoseKinematics& first, const PoseKinematics& second);

  /// Adds ∂y to `jacobian` (columns × 3).
  void add_jacobian(Eigen::MatrixXd& jacobian) const;
  /// Adds Σ_k multiplier_k ∂²y_k to the lower triangle of `hessian`.
  void add_curvature(const Ancestry& ancestry, const Eigen::Vector3d& multiplier,
                     Eigen::MatrixXd& hessian) const;

 private:
  /// One twist of one pose, with `swept` = Σ weight (∂p/∂c)[p′; 1]ᵀ over what it moves (for the
  /// second pose: with the roles of p and p′ exchanged).
  struct Effect {
    Effect() {}  // all members are set by who adds it
    int column, link;
    bool rotates, inner;
    Eigen::Vector3d turn, shift;
    Eigen::Matrix<double, 3, 4> swept;
    Eigen::Vector3d growth;  // Σ (∂weight/∂c) p′, inner only
    int inner_index;
  };
  struct Second {
    int a, b;
    const Eigen::Matrix3d* second;  // ∂²R Rᵀ, kept by the pose
    int arm;                        // Σ weight (∂²p/∂c_a∂c_b) p′ᵀ = second · arms[arm]
    bool same;
  };
  struct InnerSecond {
    int a, b;
    Eigen::Matrix3d swept;  // Σ weight (∂²p/∂c_a∂c_b) p′ᵀ of two inner twists of a link that grows
    bool same;
  };
  struct InnerProduct {
    int a, b;
    Eigen::Matrix3d swept;  // Σ weight (∂p/∂c_a)(∂p′/∂c_b)ᵀ
  };
  struct Side {
    std::vector<Effect> effects;  // inner ones last
    std::vector<std::pair<int, int>>
        of_link;  // where a link's effects begin and end, but inner ones
    std::vector<Second> seconds;
    std::vector<Eigen::Matrix3d> arms;
    std::vector<InnerSecond> inner_seconds;

    void clear(int link_count);
    Effect& add(const Twist& twist, const Columns& columns);
    /// Calls visit(upper) for the effects of `link` and of all above it, inner ones left out.
    template <class Visit>
    void for_each_above(const Ancestry& ancestry, int link, bool with_own, Visit visit) const {
      for (int upper : ancestry.chain(link)) {
        if (upper == link && !with_own) continue;
        const auto [begin, end] = of_link[static_cast<std::size_t>(upper)];
        for (int k = begin; k < end; ++k) visit(effects[static_cast<std::size_t>(k)]);
      }
    }
  };

  void fill_swept(const GeometryAtDesign& geometry, const Ancestry& ancestry, int link,
                  const PairMoments& moments, const PoseKinematics& own,
                  const PoseKinematics& other, const Columns& columns, bool swap, Side& side);
  static void add_inner(const LinkAtDesign& at, const PoseKinematics& own,
                        const PoseKinematics& other, const Columns& columns, const Twist& twist,
                        Effect& effect, Side& side);
  void add_inner_products(const GeometryAtDesign& geometry, const PoseKinematics& first,
                          const PoseKinematics& second);
  void add_cross_curvature(const Ancestry& ancestry, const Eigen::Vector3d& multiplier,
                           Eigen::MatrixXd& hessian) const;
  static void add_side_curvature(const Side& side, const Ancestry& ancestry,
                                 const Eigen::Vector3d& multiplier, Eigen::MatrixXd& hessian);

  Side first_, second_;
  std::vector<InnerProduct> inner_products_;
};

}  // namespace legwright
