// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/momentum.hpp"

#include <Eigen/Geometry>

#include "optimizer/design/rotation.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;
using Matrix34 = Eigen::Matrix<double, 3, 4>;

/// Σ a × b for X = Σ a bᵀ.
template <class Derived>
Vector3d cross_of(const Eigen::MatrixBase<Derived>& X) {
  return {X(1, 2) - X(2, 1), X(2, 0) - X(0, 2), X(0, 1) - X(1, 0)};
}

template <class A, class B>
double inner_product(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
  return a.cwiseProduct(b).sum();
}

void add_pair(Eigen::MatrixXd& hessian, int a, int b, double value) {
  hessian(a, b) += value;
  hessian(b, a) += value;
}

}  // namespace

void PairDerivatives::compute_swept_momentum(
    const Morphology& morphology, const GeometryAtDesign& geometry, const PoseKinematics& first,
    const PoseKinematics& second, const Columns& first_columns, const Columns& second_columns) {
  const int link_count = static_cast<int>(geometry.links.size());
  std::vector<Matrix4d> below(link_count);  // Σ m [p; 1][p′; 1]ᵀ over a link and all below it
  for (int l = 0; l < link_count; ++l)
    below[l] = first.transform(l) * geometry.links[l].moments * second.transform(l).transpose();
  for (int l = link_count - 1; l > 0; --l) below[morphology.links[l].parent] += below[l];
  value = cross_of(below[0]);

  const auto fill = [&](const PoseKinematics& own, const PoseKinematics& other,
                        const Columns& columns, bool swap, Side& side) {
    side.effects.clear();
    side.seconds.clear();
    for (const Mover& mover : own.movers()) {
      Effect effect{columns[mover.coordinate],
                    mover.link,
                    mover.kind == Mover::Kind::rotation,
                    mover.kind == Mover::Kind::inner,
                    mover.turn,
                    mover.velocity,
                    Matrix34::Zero(),
                    mover.inner_index};
      if (effect.inner)
        effect.swept = own.rotation(mover.link) *
                       geometry.links[mover.link].inner[mover.inner_index].moments *
                       other.transform(mover.link).transpose();
      else if (swap)
        effect.swept = mover.velocity * below[mover.link].transpose();
      else
        effect.swept = mover.velocity * below[mover.link];
      side.effects.push_back(effect);
    }
    for (const SameLinkSecond& s : own.same_link_seconds()) {
      const Mover &a = own.movers()[s.a], &b = own.movers()[s.b];
      const Matrix4d sum = swap ? Matrix4d(below[a.link].transpose()) : below[a.link];
      const Matrix3d arm =
          sum.topLeftCorner<3, 3>() - own.origin(a.link) * sum.bottomLeftCorner<1, 3>();
      side.seconds.push_back(
          {columns[a.coordinate], columns[b.coordinate], s.second * arm, s.a == s.b});
    }
  };
  fill(first, second, first_columns, false, first_);
  fill(second, first, second_columns, true, second_);
  add_inner_products(geometry, first, second);
}

void PairDerivatives::add_inner_products(const GeometryAtDesign& geometry,
                                         const PoseKinematics& first,
                                         const PoseKinematics& second) {
  inner_products_.clear();
  for (const Effect& a : first_.effects)
    for (const Effect& b : second_.effects) {
      if (!a.inner || !b.inner || a.link != b.link) continue;
      const InnerMotion& motion = geometry.links[a.link].inner[a.inner_index];
      inner_products_.push_back({a.column, b.column,
                                 first.rotation(a.link) * motion.products[b.inner_index].second *
                                     second.rotation(b.link).transpose()});
    }
}

void PairDerivatives::compute_foot_turn(const Morphology& morphology, const Ancestry& ancestry,
                                        int foot, const PoseKinematics& first,
                                        const PoseKinematics& second, const Columns& first_columns,
                                        const Columns& second_columns) {
  const int link = morphology.feet[foot].link;
  const Matrix3d sum = 0.5 * first.rotation(link) * second.rotation(link).transpose();
  value = cross_of(sum);
  inner_products_.clear();
  const auto fill = [&](const PoseKinematics& own, const Columns& columns, const Matrix3d& swept,
                        Side& side) {
    side.effects.clear();
    side.seconds.clear();
    for (const Mover& mover : own.movers()) {
      if (mover.kind != Mover::Kind::rotation || !ancestry.contains(mover.link, link)) continue;
      // Directions turn but do not shift: the homogeneous column stays zero.
      Effect effect{columns[mover.coordinate], mover.link,       true, false, mover.turn,
                    Matrix34::Zero(),          Matrix34::Zero(), -1};
      effect.velocity.leftCols<3>() = skew(mover.turn);
      effect.swept.leftCols<3>() = skew(mover.turn) * swept;
      side.effects.push_back(effect);
    }
    for (const SameLinkSecond& s : own.same_link_seconds()) {
      const Mover &a = own.movers()[s.a], &b = own.movers()[s.b];
      if (!ancestry.contains(a.link, link)) continue;
      side.seconds.push_back(
          {columns[a.coordinate], columns[b.coordinate], s.second * swept, s.a == s.b});
    }
  };
  fill(first, first_columns, sum, first_);
  fill(second, second_columns, sum.transpose(), second_);
}

void PairDerivatives::add_jacobian(Eigen::Ref<Eigen::Matrix3Xd> jacobian) const {
  for (const Effect& effect : first_.effects) jacobian.col(effect.column) += cross_of(effect.swept);
  for (const Effect& effect : second_.effects)
    jacobian.col(effect.column) -= cross_of(effect.swept);
}

void PairDerivatives::add_side_curvature(const Side& side, const Ancestry& ancestry,
                                         const Matrix3d& form, Eigen::MatrixXd& hessian) {
  for (const Effect& upper : side.effects) {
    if (!upper.rotates) continue;
    const Matrix3d turned = skew(upper.turn).transpose() * form;
    for (const Effect& lower : side.effects)
      if (ancestry.strictly_above(upper.link, lower.link) ||
          (lower.inner && upper.link == lower.link))
        add_pair(hessian, upper.column, lower.column,
                 inner_product(turned, lower.swept.leftCols<3>()));
  }
  for (const Second& second : side.seconds) {
    const double curvature = inner_product(form, second.swept);
    if (second.same)
      hessian(second.a, second.a) += curvature;
    else
      add_pair(hessian, second.a, second.b, curvature);
  }
}

void PairDerivatives::add_cross_curvature(const Ancestry& ancestry, const Matrix3d& form,
                                          Eigen::MatrixXd& hessian) const {
  // Σ weight (∂p/∂c)(∂p′/∂c′)ᵀ runs over what both movers move: what the lower one of them moves.
  for (const Effect& a : first_.effects) {
    const Matrix34 a_form = form.transpose() * a.velocity;
    for (const Effect& b : second_.effects) {
      if (!a.inner && ancestry.contains(a.link, b.link))
        add_pair(hessian, a.column, b.column, inner_product(a_form, b.swept));
      else if (!b.inner && ancestry.contains(b.link, a.link))
        add_pair(hessian, a.column, b.column, inner_product(form * b.velocity, a.swept));
    }
  }
  for (const InnerProduct& product : inner_products_)
    add_pair(hessian, product.a, product.b, inner_product(form, product.swept));
}

void PairDerivatives::add_curvature(const Ancestry& ancestry, const Vector3d& multiplier,
                                    Eigen::MatrixXd& hessian) const {
  // multiplier · Σ a × b = ⟨form, Σ a bᵀ⟩; with the roles of the poses exchanged the sign changes.
  const Matrix3d form = -skew(multiplier);
  add_side_curvature(first_, ancestry, form, hessian);
  add_side_curvature(second_, ancestry, -form, hessian);
  add_cross_curvature(ancestry, form, hessian);
}

}  // namespace legwright
