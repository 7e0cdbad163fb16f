// SPDX-License-Identifier: Apache-2.0
#include "mjcf/shape/convex_hull.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kHullTolerance = 1e-9;  // of the size of all: nearer points are in one plane
constexpr int kMostTrials = 6;           // each with ten times the tolerance of the one before

double spread_of(const std::vector<Vector3d>& points) {
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Vector3d& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return points.empty() ? 0.0 : (high - low).norm();
}

/// A triangle with the plane that it lies in.
struct HullFacet {
  Facet corners{};
  Vector3d normal = Vector3d::Zero();  // outwards, a unit vector
  double offset = 0.0;
  bool is_gone = false;

  double above(const Vector3d& point) const { return normal.dot(point) - offset; }
};

/// Quickhull: the farthest point outside takes the place of all triangles that it sees.
class HullMaker {
 public:
  HullMaker(const std::vector<Vector3d>& points, double tolerance)
      : points_(points),
        tolerance_(tolerance),
        facet_at_(points.size() * points.size(), -1),
        outside_(points.size()) {}

  std::vector<Facet> run() {
    if (!start()) return {};
    for (int next = farthest(); next >= 0; next = farthest())
      if (!add(next)) return {};
    std::vector<Facet> out;
    for (const HullFacet& facet : facets_)
      if (!facet.is_gone) out.push_back(lowest_first(facet.corners));
    std::sort(out.begin(), out.end());
    return out;
  }

 private:
  /// How far a point is above the triangle over which it is farthest [m].
  struct Outside {
    double distance = 0.0;
    int facet = -1;  // none: it is within, or a corner
  };

  const Vector3d& at(int point) const { return points_[static_cast<std::size_t>(point)]; }

  static Facet lowest_first(Facet corners) {
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    return corners;
  }

  /// The triangle whose edge goes that way.
  int& facet_at(int from, int to) {
    return facet_at_[static_cast<std::size_t>(from) * points_.size() +
                     static_cast<std::size_t>(to)];
  }

  void put(int a, int b, int c) {
    HullFacet own;
    own.corners = {a, b, c};
    own.normal = (at(b) - at(a)).cross(at(c) - at(a)).normalized();
    own.offset = own.normal.dot((at(a) + at(b) + at(c)) / 3.0);
    const int index = static_cast<int>(facets_.size());
    facet_at(a, b) = facet_at(b, c) = facet_at(c, a) = index;
    facets_.push_back(own);
  }

  void look_at(int point, int facet) {
    const HullFacet& own = facets_[static_cast<std::size_t>(facet)];
    Outside& best = outside_[static_cast<std::size_t>(point)];
    const double above = own.is_gone ? 0.0 : own.above(at(point));
    if (above > std::max(tolerance_, best.distance)) best = {above, facet};
  }

  /// The point for which a measure is largest; the first of equals.
  template <class Measure>
  int most(const Measure& measure) const {
    int best = -1;
    double largest = tolerance_;
    for (int k = 0; k < static_cast<int>(points_.size()); ++k)
      if (const double value = measure(at(k)); value > largest) {
        largest = value;
        best = k;
      }
    return best;
  }

  /// A tetrahedron of four points that are far from each other.
  bool start() {
    if (points_.size() < 4 || !(tolerance_ > 0.0)) return false;
    const int a = 0, b = most([&](const Vector3d&p) { return (p - at(a)).norm(); });
    if (b < 0) return false;
    const Vector3d along = (at(b) - at(a)).normalized();
    const int c = most([&](const Vector3d& p) { return (p - at(a)).cross(along).norm(); });
    if (c < 0) return false;
    const Vector3d normal = (at(b) - at(a)).cross(at(c) - at(a)).normalized();
    const int d = most([&](const Vector3d& p) { return std::abs((p - at(a)).dot(normal)); });
    if (d < 0) return false;
    const bool is_above = (at(d) - at(a)).dot(normal) > 0.0;
    const int p = is_above ? c : b, q = is_above ? b : c;
    put(a, p, q);
    put(a, q, d);
    put(q, p, d);
    put(p, a, d);
    for (int k = 0; k < static_cast<int>(points_.size()); ++k)
      for (int f = 0; f < 4; ++f) look_at(k, f);
    return true;
  }

  int farthest() const {
    int best = -1;
    double distance = 0.0;
    for (std::size_t k = 0; k < outside_.size(); ++k)
      if (outside_[k].facet >= 0 && outside_[k].distance > distance) {
        distance = outside_[k].distance;
        best = static_cast<int>(k);
      }
    return best;
  }

  /// Puts the triangles from the point to the rim of what it sees in the place of that. False where
  /// rounding lets the rim be no loop.
  bool add(int point) {
    std::vector<int> seen{outside_[static_cast<std::size_t>(point)].facet};
    facets_[static_cast<std::size_t>(seen.front())].is_gone = true;
    std::map<int, int> rim;  // from corner to corner, as the triangles that are seen go round
    for (std::size_t next = 0; next < seen.size(); ++next) {
      const Facet corners = facets_[static_cast<std::size_t>(seen[next])].corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const int from = corners[k], to = corners[(k + 1) % 3], beyond = facet_at(to, from);
        HullFacet& other = facets_[static_cast<std::size_t>(beyond)];
        if (other.is_gone) continue;
        if (other.above(at(point)) > tolerance_) {
          other.is_gone = true;
          seen.push_back(beyond);
        } else if (!rim.emplace(from, to).second) {
          return false;
        }
      }
    }
    const int first = static_cast<int>(facets_.size());
    for (const auto& [from, to] : rim) put(from, to, point);
    outside_[static_cast<std::size_t>(point)] = {};
    for (int k = 0; k < static_cast<int>(points_.size()); ++k) {
      Outside& own = outside_[static_cast<std::size_t>(k)];
      if (own.facet < 0) continue;
      const bool is_lost = facets_[static_cast<std::size_t>(own.facet)].is_gone;
      if (is_lost) own = {};
      for (int f = is_lost ? 0 : first; f < static_cast<int>(facets_.size()); ++f) look_at(k, f);
    }
    return true;
  }

  const std::vector<Vector3d>& points_;
  const double tolerance_;  // [m]
  std::vector<HullFacet> facets_;
  std::vector<int> facet_at_;  // by the corners of an edge
  std::vector<Outside> outside_;
};

/// Whether no point lies outside of a facet's plane by more than the tolerance [m].
bool is_hull_within(const std::vector<Facet>& facets, const std::vector<Vector3d>& points,
                    double tolerance) {
  return !facets.empty() && std::all_of(facets.begin(), facets.end(), [&](const Facet& facet) {
    const Vector3d& first = points[static_cast<std::size_t>(facet[0])];
    const Vector3d normal = (points[static_cast<std::size_t>(facet[1])] - first)
                                .cross(points[static_cast<std::size_t>(facet[2])] - first);
    const double most = tolerance * normal.norm();
    return most > 0.0 && std::all_of(points.begin(), points.end(), [&](const Vector3d& point) {
             return normal.dot(point - first) <= most;
           });
  });
}

}  // namespace

std::vector<Facet> convex_hull(const std::vector<Vector3d>& points) {
  // Points that lie in a plane but for rounding may make a rim that is no loop: coarser then.
  double tolerance = kHullTolerance * spread_of(points);
  for (int trial = 0; trial < kMostTrials; ++trial, tolerance *= 10.0)
    if (std::vector<Facet> found = HullMaker(points, tolerance).run();
        is_hull_within(found, points, tolerance))
      return found;
  return {};
}

bool is_convex_hull(const std::vector<Facet>& facets, const std::vector<Vector3d>& points) {
  return is_hull_within(facets, points, kHullTolerance * spread_of(points));
}

std::vector<int> corners_of(const std::vector<Facet>& facets) {
  std::set<int> found;
  for (const Facet& facet : facets) found.insert(facet.begin(), facet.end());
  return {found.begin(), found.end()};
}

}  // namespace legwright
