// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/momentum.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "optimizer/design/rotation.hpp"
#include "optimizer/design/small_products.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Σ a × b for X = Σ a bᵀ. Also ⟨[v]×, X⟩ = v · −cross_of(X).
template <class Derived>
Vector3d cross_of(const Eigen::MatrixBase<Derived>& X) {
  return {X(1, 2) - X(2, 1), X(2, 0) - X(0, 2), X(0, 1) - X(1, 0)};
}

/// out = [turn]× X + shift sumᵀ, number by number: products of small vectors spend their time
/// waiting for half-written pairs.
template <class Derived>
void sweep(const Vector3d& turn, const Eigen::MatrixBase<Derived>& X, const Vector3d& shift,
           const Vector3d& sum, Eigen::Matrix<double, 3, 4>& out) {
  const double t0 = turn[0], t1 = turn[1], t2 = turn[2];
  const double v0 = shift[0], v1 = shift[1], v2 = shift[2];
  for (int k = 0; k < 3; ++k) {
    const double x0 = X(0, k), x1 = X(1, k), x2 = X(2, k), m = sum[k];
    out(0, k) = t1 * x2 - t2 * x1 + v0 * m;
    out(1, k) = t2 * x0 - t0 * x2 + v1 * m;
    out(2, k) = t0 * x1 - t1 * x0 + v2 * m;
  }
}

}  // namespace

void PairMoments::compute(const Morphology& morphology, const PoseKinematics& first,
                          const PoseKinematics& second) {
  const std::size_t link_count = morphology.links.size();
  below_.resize(link_count);
  for (std::size_t l = 0; l < link_count; ++l) {
    const int link = static_cast<int>(l);
    const Eigen::Matrix<double, 3, 4>& moments = first.moments(link);
    const Scalars3 sum = scalars(moments.col(3));
    for (int k = 0; k < 3; ++k)
      store(product(moments, scalars(second.rotation(link).row(k))) + second.origin(link)[k] * sum,
            below_[l].col(k));
  }
  for (std::size_t l = link_count - 1; l > 0; --l) below_[morphology.links[l].parent] += below_[l];
}

Vector3d PairMoments::swept(int link) const { return cross_of(below_[link]); }

void PairDerivatives::Side::clear(int link_count) {
  effects.clear();
  seconds.clear();
  inner_seconds.clear();
  arms.clear();
  of_link.assign(static_cast<std::size_t>(link_count), {0, 0});
}

PairDerivatives::Effect& PairDerivatives::Side::add(const Twist& twist, const Columns& columns) {
  if (twist.kind != Twist::Kind::inner) {
    auto& [begin, end] = of_link[static_cast<std::size_t>(twist.link)];
    if (begin == end) begin = static_cast<int>(effects.size());  // a link's twists are in a row
    end = static_cast<int>(effects.size()) + 1;
  }
  Effect& effect = effects.emplace_back();
  effect.column = columns[static_cast<std::size_t>(twist.coordinate)];
  effect.link = twist.link;
  effect.rotates = twist.kind == Twist::Kind::rotation;
  effect.inner = twist.kind == Twist::Kind::inner;
  effect.turn = twist.turn;
  effect.inner_index = twist.inner_index;
  effect.growth.setZero();
  return effect;
}

// Places in the world, p̂ = T v of each point; `swept` is Σ (∂p)[p′; 1]ᵀ with the weight in both of
// them.
void PairDerivatives::add_inner(const LinkAtDesign& at, const PoseKinematics& own,
                                const PoseKinematics& other, const Columns& columns,
                                const Twist& twist, Effect& effect, Side& side) {
  const Matrix3d& turn = own.rotation(twist.link);
  const Vector3d& origin = own.origin(twist.link);
  const Matrix3d& other_turn = other.rotation(twist.link);
  const Vector3d& other_origin = other.origin(twist.link);
  const auto in_world = [&](const Eigen::Matrix4d& v) -> Eigen::Matrix<double, 3, 4> {
    const Eigen::Matrix<double, 3, 4> turned = turn * v.topRows<3>() + origin * v.row(3);
    Eigen::Matrix<double, 3, 4> out;
    out.leftCols<3>() =
        turned.leftCols<3>() * other_turn.transpose() + turned.col(3) * other_origin.transpose();
    out.col(3) = turned.col(3);
    return out;
  };
  const InnerMotion& motion = at.inner[twist.inner_index];
  effect.swept = in_world(motion.moments);
  if (!at.bends) return;
  effect.growth = other_turn * motion.moments.row(3).head<3>().transpose() +
                  motion.moments(3, 3) * other_origin;
  for (int l = twist.inner_index; l < static_cast<int>(at.inner.size()); ++l) {
    const Twist& with = (&twist)[l - twist.inner_index];  // inner twists of a link are in a row
    side.inner_seconds.push_back({columns[twist.coordinate], columns[with.coordinate],
                                  in_world(motion.seconds[l]).leftCols<3>(), &with == &twist});
  }
}

void PairDerivatives::fill_swept(const GeometryAtDesign& geometry, const Ancestry& ancestry,
                                 int link, const PairMoments& moments, const PoseKinematics& own,
                                 const PoseKinematics& other, const Columns& columns, bool swap,
                                 Side& side) {
  side.clear(moments.link_count());
  for (const Twist& twist : own.twists()) {
    const bool inner = twist.kind == Twist::Kind::inner;
    if (inner ? !ancestry.contains(link, twist.link) : !ancestry.related(link, twist.link))
      continue;
    Effect& effect = side.add(twist, columns);
    effect.shift = twist.shift;
    if (inner) {
      add_inner(geometry.links[twist.link], own, other, columns, twist, effect, side);
      continue;
    }
    const int lower = std::max(link, twist.link);  // children come after their parents
    const Vector3d& sum = other.first_moment(lower);
    if (swap)
      sweep(twist.turn, moments.below(lower).transpose(), twist.shift, sum, effect.swept);
    else
      sweep(twist.turn, moments.below(lower), twist.shift, sum, effect.swept);
    const Vector3d& own_sum = own.first_moment(lower);
    const double mass = geometry.mass_below[lower];
    for (int k = 0, l = 1, n = 2; k < 3; ++k, l = (l + 1) % 3, n = (n + 1) % 3)
      effect.swept(k, 3) =
          twist.turn[l] * own_sum[n] - twist.turn[n] * own_sum[l] + mass * twist.shift[k];
  }
  int arm_of = -1;
  for (const SameLinkSecond& s : own.same_link_seconds()) {
    const Twist &a = own.twists()[s.a], &b = own.twists()[s.b];
    if (!ancestry.related(link, a.link)) continue;
    if (a.link != arm_of) {
      arm_of = a.link;
      const int lower = std::max(link, a.link);
      Matrix3d arm = moments.below(lower);
      if (swap) arm.transposeInPlace();
      side.arms.push_back(arm - own.origin(a.link) * other.first_moment(lower).transpose());
    }
    side.seconds.push_back({columns[a.coordinate], columns[b.coordinate], &s.second,
                            static_cast<int>(side.arms.size()) - 1, s.a == s.b});
  }
}

void PairDerivatives::compute_swept_momentum(
    const GeometryAtDesign& geometry, const Ancestry& ancestry, int link,
    const PairMoments& moments, const PoseKinematics& first, const PoseKinematics& second,
    const Columns& first_columns, const Columns& second_columns) {
  value = moments.swept(link);
  fill_swept(geometry, ancestry, link, moments, first, second, first_columns, false, first_);
  fill_swept(geometry, ancestry, link, moments, second, first, second_columns, true, second_);
  inner_products_.clear();
  if (first.with_design()) add_inner_products(geometry, first, second);
}

void PairDerivatives::add_inner_products(const GeometryAtDesign& geometry,
                                         const PoseKinematics& first,
                                         const PoseKinematics& second) {
  for (const Effect& a : first_.effects) {
    if (!a.inner) continue;
    for (const Effect& b : second_.effects) {
      if (!b.inner || a.link != b.link) continue;
      const InnerMotion& motion = geometry.links[a.link].inner[a.inner_index];
      const Eigen::Matrix4d& product = motion.products[b.inner_index];
      const Eigen::Matrix<double, 3, 4> turned =
          first.rotation(a.link) * product.topRows<3>() + first.origin(a.link) * product.row(3);
      inner_products_.push_back({a.column, b.column,
                                 turned.leftCols<3>() * second.rotation(b.link).transpose() +
                                     turned.col(3) * second.origin(b.link).transpose()});
    }
  }
}

Matrix3d turn_moments(const PoseKinematics& first, const PoseKinematics& second, int link) {
  const Matrix3d half = 0.5 * first.rotation(link);
  Matrix3d out;
  for (int k = 0; k < 3; ++k)
    store(product(half, scalars(second.rotation(link).row(k))), out.col(k));
  return out;
}

Vector3d PairDerivatives::foot_turn(const Morphology& morphology, int foot,
                                    const PoseKinematics& first, const PoseKinematics& second) {
  return cross_of(turn_moments(first, second, morphology.feet[foot].link));
}

void PairDerivatives::compute_foot_turn(const Morphology& morphology, const Ancestry& ancestry,
                                        int foot, const PoseKinematics& first,
                                        const PoseKinematics& second, const Columns& first_columns,
                                        const Columns& second_columns) {
  const int link = morphology.feet[foot].link;
  const Matrix3d sum = turn_moments(first, second, link);
  value = cross_of(sum);
  inner_products_.clear();
  const auto fill = [&](const PoseKinematics& own, const Columns& columns, const Matrix3d& swept,
                        Side& side) {
    side.clear(static_cast<int>(morphology.links.size()));
    side.arms.assign(1, swept);
    for (const Twist& twist : own.twists()) {
      if (twist.kind != Twist::Kind::rotation || !ancestry.contains(twist.link, link)) continue;
      Effect& effect = side.add(twist, columns);
      effect.shift.setZero();  // directions turn but do not shift
      sweep(twist.turn, swept, effect.shift, effect.shift, effect.swept);
      effect.swept.col(3).setZero();
    }
    for (const SameLinkSecond& s : own.same_link_seconds()) {
      const Twist &a = own.twists()[s.a], &b = own.twists()[s.b];
      if (!ancestry.contains(a.link, link)) continue;
      side.seconds.push_back(
          {columns[a.coordinate], columns[b.coordinate], &s.second, 0, s.a == s.b});
    }
  };
  fill(first, first_columns, sum, first_);
  fill(second, second_columns, sum.transpose(), second_);
}

void PairDerivatives::add_jacobian(Eigen::MatrixXd& jacobian) const {
  for (const Effect& effect : first_.effects) {
    const Vector3d rate = cross_of(effect.swept);
    for (int k = 0; k < 3; ++k) jacobian(effect.column, k) += rate[k];
  }
  for (const Effect& effect : second_.effects) {
    const Vector3d rate = cross_of(effect.swept);
    for (int k = 0; k < 3; ++k) jacobian(effect.column, k) -= rate[k];
  }
}

void PairDerivatives::add_side_curvature(const Side& side, const Ancestry& ancestry,
                                         const Vector3d& multiplier, Eigen::MatrixXd& hessian) {
  // An upper rotation turns what the lower twist does. With X = Σ ∂p p′ᵀ of the lower one,
  // μ · Σ (turn × ∂p) × p′ = turn · (Xᵀ μ − tr X μ).
  const Scalars3 mu = scalars(multiplier);
  for (const Effect& lower : side.effects) {
    const auto X = lower.swept.leftCols<3>();
    const Scalars3 pull = transposed_product(X, mu) - trace(X) * mu;
    const bool grown = lower.inner && !lower.growth.isZero(0.0);
    const Scalars3 push = cross(scalars(lower.growth), mu);
    side.for_each_above(ancestry, lower.link, lower.inner, [&](const Effect& upper) {
      if (upper.rotates)
        add_pair(hessian, upper.column, lower.column, dot(scalars(upper.turn), pull));
      if (grown) add_pair(hessian, upper.column, lower.column, dot(scalars(upper.shift), push));
    });
  }
  // μ · Σ (S a) × b = ⟨S, −[μ]× armᵀ⟩ for arm = Σ a bᵀ.
  Matrix3d pull = Matrix3d::Zero();
  int arm = -1;
  for (const Second& second : side.seconds) {
    if (second.arm != arm) {
      arm = second.arm;
      pull = -skew(multiplier) * side.arms[static_cast<std::size_t>(arm)].transpose();
    }
    const double curvature = second.second->cwiseProduct(pull).sum();
    if (second.same)
      hessian(second.a, second.a) += curvature;
    else
      add_pair(hessian, second.a, second.b, curvature);
  }
  for (const InnerSecond& second : side.inner_seconds) {
    const double curvature = multiplier.dot(cross_of(second.swept));
    if (second.same)
      hessian(second.a, second.a) += curvature;
    else
      add_pair(hessian, second.a, second.b, curvature);
  }
}

void PairDerivatives::add_cross_curvature(const Ancestry& ancestry, const Vector3d& multiplier,
                                          Eigen::MatrixXd& hessian) const {
  // μ · Σ ∂p × ∂p′ runs over what both twists move: what the lower one of them moves. With
  // [X x] = Σ ∂p′ [p; 1]ᵀ of the lower one it is turn · (X μ − tr X μ) + shift · (x × μ), turn and
  // shift those of the upper one.
  const Scalars3 mu = scalars(multiplier);
  const auto add = [&](const Side& lowers, const Side& uppers, double sign, bool same_link) {
    for (const Effect& lower : lowers.effects) {
      const auto X = lower.swept.leftCols<3>();
      const Scalars3 pull = sign * (product(X, mu) - trace(X) * mu);
      const Scalars3 push = cross(sign * scalars(lower.swept.col(3)), mu);
      // Two twists of one link are counted once, from the side of the second pose.
      uppers.for_each_above(
          ancestry, lower.link, same_link || lower.inner, [&](const Effect& upper) {
            add_pair(hessian, upper.column, lower.column,
                     dot(scalars(upper.turn), pull) + dot(scalars(upper.shift), push));
          });
    }
  };
  add(second_, first_, 1.0, true);
  add(first_, second_, -1.0, false);
  for (const InnerProduct& product : inner_products_)
    add_pair(hessian, product.a, product.b, multiplier.dot(cross_of(product.swept)));
}

void PairDerivatives::add_curvature(const Ancestry& ancestry, const Vector3d& multiplier,
                                    Eigen::MatrixXd& hessian) const {
  // The sign changes where the poses exchange their roles.
  add_side_curvature(first_, ancestry, multiplier, hessian);
  add_side_curvature(second_, ancestry, -multiplier, hessian);
  add_cross_curvature(ancestry, multiplier, hessian);
}

}  // namespace legwright
