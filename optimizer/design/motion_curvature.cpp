// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/motion_curvature.hpp"

#include <algorithm>

namespace legwright {
namespace {

using Eigen::Matrix3d;

/// Adds a bᵀ.
void add_outer(const Scalars3& a, const Scalars3& b, Matrix3d& out) {
  out(0, 0) += a.x * b.x;
  out(1, 0) += a.y * b.x;
  out(2, 0) += a.z * b.x;
  out(0, 1) += a.x * b.y;
  out(1, 1) += a.y * b.y;
  out(2, 1) += a.z * b.y;
  out(0, 2) += a.x * b.z;
  out(1, 2) += a.y * b.z;
  out(2, 2) += a.z * b.z;
}

/// Adds rows.
void add_rows(const Scalars3& x, const Scalars3& y, const Scalars3& z, Matrix3d& out) {
  out(0, 0) += x.x;
  out(1, 0) += y.x;
  out(2, 0) += z.x;
  out(0, 1) += x.y;
  out(1, 1) += y.y;
  out(2, 1) += z.y;
  out(0, 2) += x.z;
  out(1, 2) += y.z;
  out(2, 2) += z.z;
}

/// Calls visit(link) for a link and all above it.
template <class Visit>
void for_each_up(const Morphology& morphology, int link, Visit visit) {
  for (; link > 0; link = parent_of(morphology, link)) visit(link);
  visit(0);
}

/// Calls visit(link, the lower one of it and `of`) for all links above and below `of`.
template <class Visit>
void for_each_related(const Ancestry& ancestry, int link_count, int of, Visit visit) {
  for (int link = 0; link < link_count; ++link)
    if (ancestry.related(of, link)) visit(link, std::max(of, link));  // children come later
}

}  // namespace

Scalars3 PoseLoads::levers(const Load& load, const Twist& twist) {
  // Σ (t × p) × f = Σ p (f · t) − t (p · f)
  const Scalars3 turn = scalars(twist.turn);
  return product(load.pull, turn) - trace(load.pull) * turn +
         cross(scalars(twist.shift), load.force);
}

void PoseLoads::clear(std::size_t link_count) {
  loads_.assign(link_count, {Matrix3d::Zero(), {0.0, 0.0, 0.0}});
  empty_ = true;
}

void PoseLoads::add_point(const Morphology& morphology, int link, const Scalars3& point,
                          const Scalars3& multiplier) {
  for_each_up(morphology, link, [&](int upper) {
    Load& load = touch(upper);
    add_outer(point, multiplier, load.pull);
    load.force = load.force + multiplier;
  });
}

void PoseLoads::add_direction(const Morphology& morphology, int link, const Scalars3& direction,
                              const Scalars3& multiplier) {
  for_each_up(morphology, link,
              [&](int upper) { add_outer(direction, multiplier, touch(upper).pull); });
}

void PoseLoads::add_first_moment(const GeometryAtDesign& geometry, const Ancestry& ancestry,
                                 const PoseKinematics& pose, int link, const Scalars3& multiplier) {
  for_each_related(ancestry, static_cast<int>(loads_.size()), link, [&](int at, int lower) {
    Load& load = touch(at);
    add_outer(scalars(pose.first_moment(lower)), multiplier, load.pull);
    load.force = load.force + geometry.mass_below[static_cast<std::size_t>(lower)] * multiplier;
  });
}

/// Σ over points at the first pose, p, and the second, p′.
struct PairLoads::Source {
  const Matrix3d& moments;  // Σ p p′ᵀ
  Scalars3 first, second;   // Σ p, Σ p′
  double mass;
};

void PairLoads::clear(std::size_t link_count) {
  const Scalars3 none{0.0, 0.0, 0.0};
  const Matrix3d zero = Matrix3d::Zero();
  loads_.assign(link_count, {none, none, none, zero, zero, zero});
  empty_ = true;
}

void PairLoads::add(int link, const Source& source, const Scalars3& multiplier,
                    PoseLoads& first_loads, PoseLoads& second_loads) {
  empty_ = false;
  const Matrix3d& X = source.moments;
  Load& load = loads_[static_cast<std::size_t>(link)];
  load.first_moment = load.first_moment + product(X, multiplier);
  load.second_moment = load.second_moment + transposed_product(X, multiplier);
  load.mass = load.mass + source.mass * multiplier;
  add_outer(multiplier, {X(1, 2) - X(2, 1), X(2, 0) - X(0, 2), X(0, 1) - X(1, 0)}, load.turned);
  add_outer(multiplier, source.first, load.first);
  add_outer(multiplier, source.second, load.second);
  // Each p is pulled by p′ × μ, each p′ by μ × p.
  PoseLoads::Load &at_first = first_loads.touch(link), &at_second = second_loads.touch(link);
  add_rows(cross(scalars(X.row(0)), multiplier), cross(scalars(X.row(1)), multiplier),
           cross(scalars(X.row(2)), multiplier), at_first.pull);
  at_first.force = at_first.force + cross(source.second, multiplier);
  add_rows(cross(multiplier, scalars(X.col(0))), cross(multiplier, scalars(X.col(1))),
           cross(multiplier, scalars(X.col(2))), at_second.pull);
  at_second.force = at_second.force + cross(multiplier, source.first);
}

void PairLoads::add_swept_momentum(const GeometryAtDesign& geometry, const Ancestry& ancestry,
                                   int link, const PairMoments& moments,
                                   const PoseKinematics& first, const PoseKinematics& second,
                                   const Scalars3& multiplier, PoseLoads& first_loads,
                                   PoseLoads& second_loads) {
  for_each_related(ancestry, static_cast<int>(loads_.size()), link, [&](int at, int lower) {
    add(at,
        {moments.below(lower), scalars(first.first_moment(lower)),
         scalars(second.first_moment(lower)), geometry.mass_below[static_cast<std::size_t>(lower)]},
        multiplier, first_loads, second_loads);
  });
}

void PairLoads::add_foot_turn(const Morphology& morphology, int foot, const PoseKinematics& first,
                              const PoseKinematics& second, const Scalars3& multiplier,
                              PoseLoads& first_loads, PoseLoads& second_loads) {
  const int link = morphology.feet[static_cast<std::size_t>(foot)].link;
  const Matrix3d moments = turn_moments(first, second, link);
  const Source source{moments, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0.0};  // directions do not shift
  for_each_up(morphology, link,
              [&](int upper) { add(upper, source, multiplier, first_loads, second_loads); });
}

// μ · Σ ∂p × ∂p′ over what both twists move, written as turn · by_turn + shift · by_shift of the
// upper one. With ∂p′ = t × p′ + v of the lower one by_turn is
//   Σ p × (∂p′ × μ) = Σ ∂p′ (p · μ) − μ (p · ∂p′) and by_shift is Σ ∂p′ × μ.
PairLoads::Pulled PairLoads::by_second(const Load& load, const Twist& lower) {
  const Scalars3 t = scalars(lower.turn), v = scalars(lower.shift);
  return {cross(t, load.second_moment) + trace(load.first) * v + product(load.turned, t) -
              product(load.first, v),
          transposed_product(load.second, t) - trace(load.second) * t + cross(v, load.mass)};
}

// With ∂p of the lower one: Σ p′ × (μ × ∂p) = Σ μ (p′ · ∂p) − ∂p (p′ · μ), and Σ μ × ∂p.
PairLoads::Pulled PairLoads::by_first(const Load& load, const Twist& lower) {
  const Scalars3 t = scalars(lower.turn), v = scalars(lower.shift);
  return {product(load.turned, t) + product(load.second, v) - cross(t, load.first_moment) -
              trace(load.second) * v,
          trace(load.first) * t - transposed_product(load.first, t) + cross(load.mass, v)};
}

}  // namespace legwright
