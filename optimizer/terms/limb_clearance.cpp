// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "optimizer/design/kinematics.hpp"
#include "optimizer/design/segment_distance.hpp"
#include "optimizer/motion/margins.hpp"
#include "optimizer/terms/factories.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kClearanceRange =
    0.1;  // beyond the clearance from which a pair costs nothing, share of the leg
constexpr double kDistanceRounding =
    0.25;  // distance below which its root is rounded, share of the clearance
constexpr double kTouching = 1e-6;  // [m]

// Of limbs and the trunk, whose thickness is known: δ is that plus a margin for servos that lag
// behind, share of the leg.
constexpr double kTrunkMargin = 0.015, kTrunkRange = 0.05;
constexpr double kLeastRange = 0.1;  // of the range, for a leg that is at home beside its trunk
constexpr double kReach = 1.5;       // how much longer a limb may get

/// A limb segment, from a link's hinge to a hinge that it carries or to its foot, or the axis of a
/// capsule.
struct Segment {
  int link;                    // owner
  int child;                   // link at its far end, or −1
  int foot;                    // foot at its far end, or −1
  Vector3d near_end, far_end;  // in the home pose of the initial design
  int capsule = -1;
};

struct Pair {
  int a, b;                 // segments
  double clearance, range;  // δ, and beyond it where the barrier begins [m]
};

/// Eq (16), with its inequality the right way round: limbs stay apart, V_iᵏ to V_iˡ at least the
/// clearance δ, measured between centre lines. Residual (distance − δ)/range, range a tenth of the
/// leg, kept by a barrier that is zero from one on: pairs farther apart than δ + range are passed
/// over after a bound on their midpoints. Pairs of limbs: those the task names, or all but
/// neighbours: segments that share a point, and segments of one limb that are within δ + range of
/// each other in the home pose (across a short link), which no motion can part. Limbs and the
/// trunk: all pairs of capsules that the robot's file lets collide, whatever the task names.
/// Here δ is the sum of their radii, what they hide of their shapes, and a margin. Shapes nearer to
/// each other in the home pose of the initial design have a margin and range as much smaller, so
/// that the home pose costs nothing, unless the room there is less than what is hidden; shapes that
/// touch there already are left out.
class LimbClearance final : public Term {
 public:
  explicit LimbClearance(const TermContext& context)
      : layout_(context.layout),
        clearance_(legwright::limb_clearance(context.task, context.length)),
        range_(kClearanceRange * context.length) {
    collect_segments(context.morphology, context.space.initial());
    choose_pairs(context);
    collect_capsules(context.morphology, context.space.initial());
    choose_trunk_pairs(context);
    for (int i = 0; i < layout_.knot_count(); ++i)
      for (const Pair& pair : pairs_) {
        Element element{i, -1, 1, {}};
        for (int segment : {pair.a, pair.b})
          for (int end : {near_slot(i, segment), far_slot(i, segment)})
            for (int k = 0; k < 3; ++k) element.slots.push_back(end + k);
        elements_.push_back(std::move(element));
      }
    for (const Segment& segment : segments_)
      names_.push_back(segment.foot >= 0 ? context.morphology.feet[segment.foot].name
                                         : context.morphology.links[segment.link].name);
  }
  std::string_view name() const override { return "limb_clearance"; }
  Penalty penalty() const override { return Penalty::near_only; }

  void residual(int element, const VectorXd& z, VectorXd& r) const override {
    const Pair& pair = pair_of(element);
    r[0] = (measure(pair, z, DistanceDetail::value).value - pair.clearance) / pair.range;
  }
  void jacobian(int element, const VectorXd& z, Eigen::MatrixXd& jacobian) const override {
    const Pair& pair = pair_of(element);
    jacobian = measure(pair, z, DistanceDetail::gradient).gradient.transpose() / pair.range;
  }
  void add_curvature(int element, const VectorXd& z, const VectorXd& multiplier,
                     Eigen::MatrixXd& hessian) const override {
    const Pair& pair = pair_of(element);
    hessian += multiplier[0] / pair.range * measure(pair, z, DistanceDetail::hessian).hessian;
  }
  bool select_active(const VectorXd& extended, std::vector<int>& active) const override {
    const int count = static_cast<int>(segments_.size());
    std::vector<Rod> rods(segments_.size());
    for (int i = 0; i < layout_.knot_count(); ++i) {
      for (int k = 0; k < count; ++k) {
        const auto from = extended.segment<3>(near_slot(i, k)),
                   to = extended.segment<3>(far_slot(i, k));
        rods[k] = {0.5 * (from + to), 0.5 * (to - from), 0.5 * (to - from).norm()};
      }
      const int first = i * static_cast<int>(pairs_.size());
      for (std::size_t k = 0; k < pairs_.size(); ++k)
        if (!far_apart(rods[pairs_[k].a], rods[pairs_[k].b], pairs_[k].clearance + pairs_[k].range))
          active.push_back(first + static_cast<int>(k));
    }
    return true;
  }
  ResidualUnit unit(int element, int) const override { return {pair_of(element).range, "m"}; }
  std::string subject(int element, int) const override {
    const Pair& pair = pair_of(element);
    return names_[pair.a] + " - " + names_[pair.b];
  }
  VectorXd sample(int element, std::mt19937& random) const override {
    // Crossing segments, an end over a segment, end to end: by turns at random, near the clearance.
    std::uniform_real_distribution<double> uniform;
    std::normal_distribution<double> normal;
    const double place[3] = {0.5, 1.6, 1.6}, across[3] = {0.5, 0.5, 1.7};
    const int which = static_cast<int>(3.0 * uniform(random));
    const double length = range_ / kClearanceRange * 0.4;
    const Pair& pair = pair_of(element);
    VectorXd z(12);
    z.segment<3>(0) = Vector3d::Zero();
    z.segment<3>(3) = length * Vector3d::UnitX();
    const Vector3d direction = length * Vector3d(0.3, 1.0, 0.2);
    const Vector3d on =
        length * place[which] * Vector3d::UnitX() +
        (pair.clearance + pair.range * (0.5 * uniform(random) - 0.05)) * Vector3d::UnitZ() -
        (place[which] > 1.0 ? 0.6 * length : 0.0) * Vector3d::UnitX();
    z.segment<3>(6) = on - across[which] * direction;
    z.segment<3>(9) = z.segment<3>(6) + direction;
    for (double& value : z) value += 0.003 * length * normal(random);
    return z;
  }

 private:
  struct Rod {
    Vector3d middle, half;
    double half_length;
  };

  /// True only where the segments are at least `limit` apart: by their midpoints less their half
  /// lengths, then by one's midpoint to the other segment less its half length.
  static bool far_apart(const Rod& a, const Rod& b, double limit) {
    const Vector3d w = b.middle - a.middle;
    const double sum = a.half_length + b.half_length + limit, apart = w.squaredNorm();
    if (apart >= sum * sum) return true;
    const double along = std::clamp(
        -w.dot(b.half) / std::max(b.half_length * b.half_length, kTouching * kTouching), -1.0, 1.0);
    const double reach = a.half_length + limit;
    return (w + along * b.half).squaredNorm() >= reach * reach;
  }

  const Pair& pair_of(int element) const {
    return pairs_[static_cast<std::size_t>(element) % pairs_.size()];
  }
  static SegmentDistance measure(const Pair& pair, const VectorXd& z, DistanceDetail detail) {
    return segment_distance(z.segment<3>(0), z.segment<3>(3), z.segment<3>(6), z.segment<3>(9),
                            kDistanceRounding * pair.clearance, detail);
  }
  int near_slot(int knot, int segment) const {
    const Segment& s = segments_[segment];
    return s.capsule >= 0 ? layout_.capsule_end(knot, s.capsule, 0)
                          : layout_.link_anchor(knot, s.link);
  }
  int far_slot(int knot, int segment) const {
    const Segment& s = segments_[segment];
    if (s.capsule >= 0) return layout_.capsule_end(knot, s.capsule, 1);
    return s.child >= 0 ? layout_.link_anchor(knot, s.child) : layout_.limb_end(knot, s.foot);
  }

  void collect_segments(const Morphology& morphology, const VectorXd& initial) {
    const GeometryAtDesign geometry(morphology, initial);
    const PoseKinematics home = home_pose(morphology, geometry);
    const auto add = [&](int link, int child, int foot, const Vector3d& end) {
      if (link > 0 && (end - home.origin(link)).norm() > kTouching)
        segments_.push_back({link, child, foot, home.origin(link), end});
    };
    for (int l = 1; l < static_cast<int>(morphology.links.size()); ++l) {
      for (int child = l + 1; child < static_cast<int>(morphology.links.size()); ++child)
        if (morphology.links[child].parent == l) add(l, child, -1, home.origin(child));
      for (int j = 0; j < morphology.foot_count(); ++j)
        if (morphology.feet[j].link == l) add(l, -1, j, foot_place(morphology, geometry, home, j));
    }
  }

  bool neighbours(const Morphology& morphology, const Segment& a, const Segment& b) const {
    for (const Vector3d& x : {a.near_end, a.far_end})
      for (const Vector3d& y : {b.near_end, b.far_end})
        if ((x - y).norm() < kTouching) return true;
    if (morphology.chain_to(a.link).front() != morphology.chain_to(b.link).front()) return false;
    const double home = segment_distance(a.near_end, a.far_end, b.near_end, b.far_end,
                                         kDistanceRounding * clearance_, DistanceDetail::value)
                            .value;
    return home < clearance_ + range_;
  }

  void choose_pairs(const TermContext& context) {
    const int count = static_cast<int>(segments_.size());
    if (!context.task.limb_pairs) {
      for (int a = 0; a < count; ++a)
        for (int b = a + 1; b < count; ++b)
          if (!neighbours(context.morphology, segments_[a], segments_[b]))
            pairs_.push_back({a, b, clearance_, range_});
      return;
    }
    const auto named = [&](const std::string& name) {
      std::vector<int> found;
      for (int k = 0; k < count; ++k)
        if (context.morphology.links[segments_[k].link].name == name ||
            (segments_[k].foot >= 0 && context.morphology.feet[segments_[k].foot].name == name))
          found.push_back(k);
      if (found.empty())
        throw std::invalid_argument("limb_pairs: no limb segment belongs to " + name);
      return found;
    };
    std::set<std::pair<int, int>> wanted;
    for (const auto& [first, second] : *context.task.limb_pairs)
      for (int a : named(first))
        for (int b : named(second))
          if (a != b) wanted.emplace(std::min(a, b), std::max(a, b));
    for (const auto& [a, b] : wanted) pairs_.push_back({a, b, clearance_, range_});
  }

  void collect_capsules(const Morphology& morphology, const VectorXd& initial) {
    first_capsule_ = static_cast<int>(segments_.size());
    const GeometryAtDesign geometry(morphology, initial);
    const PoseKinematics home = home_pose(morphology, geometry);
    for (int k = 0; k < static_cast<int>(morphology.capsules.size()); ++k)
      segments_.push_back({morphology.capsules[k].link, -1, -1,
                           capsule_end_place(morphology, geometry, home, 2 * k),
                           capsule_end_place(morphology, geometry, home, 2 * k + 1), k});
  }

  /// How far a limb's capsule can get from where the limb hangs on the trunk, and that place, at
  /// the initial design.
  static std::pair<double, Vector3d> farthest(const Morphology& morphology, const Capsule& capsule,
                                              const VectorXd& s) {
    const std::vector<int> chain = morphology.chain_to(capsule.link);
    double sum = std::max(capsule.from.at(s).norm(), capsule.to.at(s).norm());
    for (std::size_t k = 1; k < chain.size(); ++k)
      sum += morphology.links[chain[k]].origin.at(s).norm();
    return {sum, morphology.links[chain.front()].origin.at(s)};
  }

  void choose_trunk_pairs(const TermContext& context) {
    const Morphology& robot = context.morphology;
    const double margin = kTrunkMargin * context.length, range = kTrunkRange * context.length;
    const auto radii = [&](const CapsulePair& pair) {
      return robot.capsules[pair.trunk].radius + robot.capsules[pair.limb].radius + pair.hidden;
    };
    std::set<std::pair<int, int>> touching;      // parts
    std::map<std::pair<int, int>, double> room;  // between two parts, at home
    const auto parts = [&](const CapsulePair& pair) {
      return std::pair(robot.capsules[pair.trunk].part, robot.capsules[pair.limb].part);
    };
    const auto gap = [&](const CapsulePair& pair) {
      const Segment &a = segments_[first_capsule_ + pair.trunk],
                    &b = segments_[first_capsule_ + pair.limb];
      return segment_distance(a.near_end, a.far_end, b.near_end, b.far_end, kTouching,
                              DistanceDetail::value)
                 .value -
             radii(pair);
    };
    for (const CapsulePair& pair : robot.capsule_pairs)
      if (gap(pair) < kTouching) touching.insert(parts(pair));
    for (const CapsulePair& pair : robot.capsule_pairs) {
      if (touching.count(parts(pair))) continue;
      double& least = room.emplace(parts(pair), margin + range).first->second;
      least = std::min(least, gap(pair));
    }
    for (const CapsulePair& pair : robot.capsule_pairs) {
      if (touching.count(parts(pair)) || out_of_reach(context, pair, radii(pair) + margin + range))
        continue;
      const auto [clearance, own] = barrier(room.at(parts(pair)), margin, range, pair.hidden);
      pairs_.push_back({first_capsule_ + pair.trunk, first_capsule_ + pair.limb,
                        std::max(radii(pair) + clearance, kLeastRange * own), own});
    }
  }

  /// Distance of the surfaces at the wall, and range, of shapes with `room` between them at home.
  /// Where that is less than the margin and the range, both shrink with it. Of shapes that capsules
  /// do not fill the distance is known no better than what those hide: the barrier begins as far
  /// off, if need be beyond the room at home, and a design may make some.
  static std::pair<double, double> barrier(double room, double margin, double range,
                                           double hidden) {
    const double share = room / (margin + range), own = std::max(share, kLeastRange) * range;
    if (hidden > 0.0) return {share * margin, std::max(own, std::min(hidden, range))};
    return {room - own, own};
  }

  bool out_of_reach(const TermContext& context, const CapsulePair& pair, double limit) const {
    const auto [length, hip] = farthest(context.morphology, context.morphology.capsules[pair.limb],
                                        context.space.initial());
    const Segment& trunk = segments_[first_capsule_ + pair.trunk];
    const double apart =
        segment_distance(hip, hip, trunk.near_end, trunk.far_end, kTouching, DistanceDetail::value)
            .value;
    return apart > kReach * length + limit;
  }

  const Layout layout_;
  double clearance_, range_;
  std::vector<Segment> segments_;
  int first_capsule_ = 0;  // segment
  std::vector<Pair> pairs_;
  std::vector<std::string> names_;
};

}  // namespace

std::unique_ptr<Term> make_limb_clearance(const TermContext& context) {
  return std::make_unique<LimbClearance>(context);
}

}  // namespace legwright
