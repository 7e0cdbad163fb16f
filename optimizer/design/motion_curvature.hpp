// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/design/kinematics.hpp"
#include "optimizer/design/momentum.hpp"
#include "optimizer/design/small_products.hpp"

namespace legwright {

// Second derivatives Σ_k μ_k · ∂²y_k/∂q² of all points, directions and swept momenta of a pose, or
// of a pair of poses, in one pass. What a twist does to a point is linear in the point, so that
// points with their multipliers are summed up first, for each link over it and all below it (its
// load), and a pair of twists reads the load of the lower one of their links. That costs the same
// however many points there are. Coordinates of the design are not in it: see PointDerivatives and
// PairDerivatives.

inline int parent_of(const Morphology& morphology, int link) {
  return morphology.links[static_cast<std::size_t>(link)].parent;
}

/// What is asked of one pose.
class PoseLoads {
 public:
  void clear(std::size_t link_count);
  bool empty() const { return empty_; }

  /// μ · a world point that is fixed to `link`.
  void add_point(const Morphology& morphology, int link, const Scalars3& point,
                 const Scalars3& multiplier);
  /// μ · a direction of the world that is fixed to `link`.
  void add_direction(const Morphology& morphology, int link, const Scalars3& direction,
                     const Scalars3& multiplier);
  /// μ · Σ m p over `link` and all below it.
  void add_first_moment(const GeometryAtDesign& geometry, const Ancestry& ancestry,
                        const PoseKinematics& pose, int link, const Scalars3& multiplier);

  /// Calls visit(a, b, second derivative), a ≤ b coordinates of `pose`, whose loads these are.
  template <class Visit>
  void for_each(const Morphology& morphology, const PoseKinematics& pose, Visit visit) const;

 private:
  friend class PairLoads;
  /// Over points p that a link and those below it carry, f what pulls each of them.
  struct Load {
    Eigen::Matrix3d pull;  // Σ p fᵀ
    Scalars3 force;        // Σ f; directions have none
  };
  /// Σ (turn × p + shift) × f.
  static Scalars3 levers(const Load& load, const Twist& twist);

  Load& touch(int link) {
    empty_ = false;
    return loads_[static_cast<std::size_t>(link)];
  }

  std::vector<Load> loads_;  // by link
  bool empty_ = true;
};

/// What is asked of a pair of poses: μ · Σ weight p × p′, see PairDerivatives. How the two poses
/// act upon each other is kept here; what either does by itself becomes a load of that pose.
class PairLoads {
 public:
  void clear(std::size_t link_count);
  bool empty() const { return empty_; }

  /// μ · the swept momentum of `link` and all below it.
  void add_swept_momentum(const GeometryAtDesign& geometry, const Ancestry& ancestry, int link,
                          const PairMoments& moments, const PoseKinematics& first,
                          const PoseKinematics& second, const Scalars3& multiplier,
                          PoseLoads& first_loads, PoseLoads& second_loads);
  /// μ · the turn of a foot.
  void add_foot_turn(const Morphology& morphology, int foot, const PoseKinematics& first,
                     const PoseKinematics& second, const Scalars3& multiplier,
                     PoseLoads& first_loads, PoseLoads& second_loads);

  /// Calls visit(a, b, second derivative), a a coordinate of the first pose, b one of the second.
  template <class Visit>
  void for_each(const Morphology& morphology, const PoseKinematics& first,
                const PoseKinematics& second, Visit visit) const;

 private:
  /// Sums over what a link and those below it carry, p at the first pose, p′ at the second, each
  /// with the multiplier μ of what asks for it.
  struct Load {
    Scalars3 first_moment, second_moment;  // Σ p (p′ · μ), Σ p′ (p · μ)
    Scalars3 mass;                         // Σ μ
    Eigen::Matrix3d turned;                // Σ μ (p × p′)ᵀ
    Eigen::Matrix3d first, second;         // Σ μ pᵀ, Σ μ p′ᵀ
  };
  struct Source;
  void add(int link, const Source& source, const Scalars3& multiplier, PoseLoads& first_loads,
           PoseLoads& second_loads);
  /// The vectors that the turn and the shift of the upper twist are multiplied with.
  struct Pulled {
    Scalars3 by_turn, by_shift;

    double with(const Twist& upper) const {
      return dot(scalars(upper.turn), by_turn) + dot(scalars(upper.shift), by_shift);
    }
  };
  static Pulled by_first(const Load& load, const Twist& lower);
  static Pulled by_second(const Load& load, const Twist& lower);

  std::vector<Load> loads_;  // by link
  bool empty_ = true;
};

template <class Visit>
void PoseLoads::for_each(const Morphology& morphology, const PoseKinematics& pose,
                         Visit visit) const {
  const int link_count = static_cast<int>(loads_.size());
  for (int link = 1; link < link_count; ++link) {
    const Load& load = loads_[static_cast<std::size_t>(link)];
    const int own = 5 + link;
    const Twist& lower = pose.twist_of(own);
    const Scalars3 lever = levers(load, lower);
    const auto with = [&](int upper) {
      visit(upper, own, dot(scalars(pose.twist_of(upper).turn), lever));
    };
    for (int root = 3; root < 6; ++root) with(root);
    for (int up = parent_of(morphology, link); up > 0; up = parent_of(morphology, up)) with(5 + up);
    // ∂²R Rᵀ of a hinge is a aᵀ − I.
    const Scalars3 axis = scalars(lower.turn), origin = scalars(pose.origin(link));
    visit(own, own,
          dot(axis, product(load.pull, axis)) - dot(axis, origin) * dot(axis, load.force) -
              (trace(load.pull) - dot(origin, load.force)));
  }
  const Load& root = loads_[0];
  for (const SameLinkSecond& second : pose.same_link_seconds()) {
    if (pose.twists()[static_cast<std::size_t>(second.a)].link > 0) break;  // the root's come first
    double sum = 0.0;
    const Scalars3 origin = scalars(pose.origin(0));
    const double o[3] = {origin.x, origin.y, origin.z};
    const double f[3] = {root.force.x, root.force.y, root.force.z};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) sum += second.second(i, j) * (root.pull(j, i) - o[j] * f[i]);
    visit(second.a, second.b, sum);
  }
}

template <class Visit>
void PairLoads::for_each(const Morphology& morphology, const PoseKinematics& first,
                         const PoseKinematics& second, Visit visit) const {
  for (int b = 0; b < 6; ++b) {
    const Pulled pulled = by_second(loads_[0], second.twist_of(b));
    for (int a = 0; a < 6; ++a) visit(a, b, pulled.with(first.twist_of(a)));
  }
  const int link_count = static_cast<int>(loads_.size());
  for (int link = 1; link < link_count; ++link) {
    const Load& load = loads_[static_cast<std::size_t>(link)];
    const int own = 5 + link;
    const Pulled at_second = by_second(load, second.twist_of(own));
    const Pulled at_first = by_first(load, first.twist_of(own));
    const auto with = [&](int upper) {
      visit(upper, own, at_second.with(first.twist_of(upper)));
      visit(own, upper, at_first.with(second.twist_of(upper)));
    };
    for (int root = 0; root < 6; ++root) with(root);
    for (int up = parent_of(morphology, link); up > 0; up = parent_of(morphology, up)) with(5 + up);
    visit(own, own, at_second.with(first.twist_of(own)));
  }
}

}  // namespace legwright
