// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/leg_chains.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mjcf/read/feet.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kOneBuild = 0.25;     // of the length: legs of one build
constexpr double kHangsHigher = 0.4;   // of the length, above the lowest: an arm
constexpr double kInTheMiddle = 0.05;  // of the hips' spread: on the trunk's middle line
constexpr double kUpInTheAir = 0.25;   // of the length, above the lowest end: no foot as drawn
constexpr double kOffEnds = 0.05;      // of a range, at both of its ends
constexpr double kFarthestTurn = 2.6;  // from rest, of joints without range [rad]

/// The ends of chains of hinges under the trunk.
std::vector<int> chain_ends(const mjModel& model, int trunk) {
  std::vector<bool> carries(static_cast<std::size_t>(model.nbody), false);
  std::vector<int> ends;
  for (int b = static_cast<int>(model.nbody) - 1; b > trunk; --b) {
    if (model.body_rootid[b] != trunk) continue;
    const auto at = static_cast<std::size_t>(b);
    const bool moves = model.body_jntnum[b] > 0;
    if (moves && !carries[at]) ends.insert(ends.begin(), b);
    if (moves || carries[at]) carries[static_cast<std::size_t>(model.body_parentid[b])] = true;
  }
  return ends;
}

/// How many chains of two hinges and more hang below each body: several on a waist, where legs
/// begin below it, and none on a shin with toes.
std::vector<int> legs_carried(const mjModel& model, int trunk, const std::vector<int>& ends) {
  std::vector<int> out(static_cast<std::size_t>(model.nbody), 0);
  for (const int end : ends) {
    int below = 0;
    for (int b = end; b != trunk; b = model.body_parentid[b]) {
      if (below > 1) ++out[static_cast<std::size_t>(b)];
      below += model.body_jntnum[b];
    }
  }
  return out;
}

/// Where a chain hangs, with the hinges that it shares with others [m].
double highest_hinge(const mjModel& model, const mjData& data, int trunk, int end) {
  double highest = -std::numeric_limits<double>::infinity();
  for (int b = end; b != trunk; b = model.body_parentid[b])
    for (int j = model.body_jntadr[b]; j < model.body_jntadr[b] + model.body_jntnum[b]; ++j)
      highest = std::max(highest, data.xanchor[std::ptrdiff_t{3} * j + 2]);
  return highest;
}

/// @param carried legs_carried(): above a body that carries several, hinges are no leg's own
SearchedLeg leg_to(const mjModel& model, int trunk, int end, const std::vector<int>& carried) {
  SearchedLeg leg;
  for (int b = end; b != trunk && carried[static_cast<std::size_t>(b)] <= 1;
       b = model.body_parentid[b])
    for (int n = model.body_jntnum[b] - 1; n >= 0; --n)
      leg.joints.insert(leg.joints.begin(), model.body_jntadr[b] + n);
  for (int b = end; b < static_cast<int>(model.nbody); ++b)
    if (model.body_weldid[b] == model.body_weldid[end]) leg.bodies.push_back(b);
  for (const int joint : leg.joints) {
    const mjtNum* range = model.jnt_range + std::ptrdiff_t{2} * joint;
    const bool limited = model.jnt_limited[joint] != 0;
    const double off = limited ? kOffEnds * (range[1] - range[0]) : 0.0;
    leg.lower.push_back(limited ? std::max(range[0] + off, -kFarthestTurn) : -kFarthestTurn);
    leg.upper.push_back(limited ? std::min(range[1] - off, kFarthestTurn) : kFarthestTurn);
    if (leg.lower.back() > leg.upper.back())  // turned away by more than that
      leg.lower.back() = leg.upper.back() = 0.5 * (range[0] + range[1]);
  }
  return leg;
}

/// From hinge to hinge, and on to the farthest of what the last link collides with, or else draws:
/// the same in any pose.
double length_of_chain(const mjModel& model, const mjData& data, const SearchedLeg& leg) {
  double length = 0.0;
  Vector3d at = Vector3d::Map(data.xanchor + std::ptrdiff_t{3} * leg.joints.front());
  for (const int joint : leg.joints) {
    const Vector3d next = Vector3d::Map(data.xanchor + std::ptrdiff_t{3} * joint);
    length += (next - at).norm();
    at = next;
  }
  double colliding = 0.0, drawn = 0.0;
  for (const int body : leg.bodies)
    for (int k = 0; k < model.body_geomnum[body]; ++k) {
      const int g = model.body_geomadr[body] + k;
      const Vector3d middle = Vector3d::Map(data.geom_xpos + std::ptrdiff_t{3} * g);
      double& farthest = collides(model, g) ? colliding : drawn;
      farthest = std::max(farthest, (middle - at).norm() + model.geom_rbound[g]);
    }
  return length + (colliding > 0.0 ? colliding : drawn);
}

/// Whether a chain of one build with legs is a tail or a neck: alone on a middle line of the trunk,
/// it ends up in the air where theirs do not.
class TailFinder {
 public:
  TailFinder(const mjModel& model, int trunk, const mjData& data,
             const std::vector<SearchedLeg>& legs)
      : lowest_(std::numeric_limits<double>::infinity()) {
    for (const SearchedLeg& leg : legs) {
      hips_.push_back(Vector3d::Map(data.xanchor + std::ptrdiff_t{3} * leg.joints.front()) -
                      Vector3d::Map(data.xpos + std::ptrdiff_t{3} * trunk));
      ends_.push_back(leg.touch(model, data).z());
      lowest_ = std::min(lowest_, ends_.back());
      for (const Vector3d& hip : hips_)
        spread_ = std::max(spread_, (hip - hips_.back()).head<2>().norm());
    }
  }

  /// @param length of the chain [m]
  bool is_tail(std::size_t chain, double length) const {
    if (ends_[chain] - lowest_ <= kUpInTheAir * length) return false;
    for (const int across : {0, 1})
      if (is_in_the_middle(chain, across) && alone_there(chain, across)) return true;
    return false;
  }

 private:
  bool is_in_the_middle(std::size_t chain, int across) const {
    return std::abs(hips_[chain][across]) <= kInTheMiddle * spread_;
  }
  bool alone_there(std::size_t chain, int across) const {
    for (std::size_t other = 0; other < hips_.size(); ++other)
      if (other != chain && is_in_the_middle(other, across)) return false;
    return true;
  }

  std::vector<Vector3d> hips_;  // from the trunk [m]
  std::vector<double> ends_;    // heights [m]
  double lowest_, spread_ = 0.0;
};

}  // namespace

std::vector<SearchedLeg> legs_of_one_build(const mjModel& model, int trunk, const mjData& data) {
  std::vector<SearchedLeg> chains;
  std::vector<double> lengths, hangs;
  double lowest = std::numeric_limits<double>::infinity();
  const std::vector<int> ends = chain_ends(model, trunk);
  const std::vector<int> carried = legs_carried(model, trunk, ends);
  for (const int end : ends) {
    SearchedLeg leg = leg_to(model, trunk, end, carried);
    const bool hinges = std::all_of(leg.joints.begin(), leg.joints.end(), [&](int joint) {
      return model.jnt_type[joint] == mjJNT_HINGE;
    });
    if (!hinges || leg.joints.size() < 2) continue;
    lengths.push_back(length_of_chain(model, data, leg));
    hangs.push_back(highest_hinge(model, data, trunk, end));
    lowest = std::min(lowest, hangs.back());
    chains.push_back(std::move(leg));
  }
  std::vector<std::size_t> best;
  for (std::size_t k = 0; k < chains.size(); ++k) {
    std::vector<std::size_t> group;
    for (std::size_t n = 0; n < chains.size(); ++n)
      if (chains[n].joints.size() == chains[k].joints.size() && lengths[n] <= lengths[k] &&
          lengths[n] >= (1.0 - kOneBuild) * lengths[k] &&
          hangs[n] - lowest <= kHangsHigher * lengths[n])
        group.push_back(n);
    if (group.size() > best.size() ||
        (group.size() == best.size() && !best.empty() && lengths[k] > lengths[best.front()]))
      best = std::move(group);
  }
  std::vector<SearchedLeg> alike, legs;
  for (const std::size_t k : best) alike.push_back(chains[k]);
  const TailFinder tails(model, trunk, data, alike);
  for (std::size_t k = 0; k < best.size(); ++k)
    if (!tails.is_tail(k, lengths[best[k]])) legs.push_back(alike[k]);
  return legs;
}

}  // namespace legwright
