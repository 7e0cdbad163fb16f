// SPDX-License-Identifier: Apache-2.0
#include "mjcf/shape/hull_cover.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <mutex>
#include <utility>

#include "mjcf/text/hull_graph.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

// Where each side of the bounding box is looked through, from its middle: none of that is an edge.
constexpr double kRayOffsets[] = {-0.8, -0.4, 0.0, 0.4, 0.8};
constexpr int kEach = 2;               // of these, one that a ball touches
constexpr double kCornerRadius = 0.2;  // of a ball in a corner, of the largest about the middle
constexpr double kUnlike =
    0.5;  // balls of radii farther apart than that are no two ends of a capsule
constexpr double kNoArea = 1e-16;   // [m²]; of a face without a normal
constexpr double kSameFace = 1e-9;  // 1 − cosine
constexpr double kNoRoom = 1e-6;    // [m]; radius

/// A convex body: all x with n·x ≤ d for each face; its corners.
struct Hull {
  Eigen::Matrix<double, Eigen::Dynamic, 3> normals;
  VectorXd offsets;
  std::vector<Vector3d> corners;

  VectorXd room(const Vector3d& x) const { return offsets - normals * x; }
  bool operator==(const Hull& other) const {
    return normals.rows() == other.normals.rows() && corners == other.corners &&
           normals == other.normals && offsets == other.offsets;
  }
};

Hull hull_of(const mjModel& model, int mesh) {
  Hull hull;
  if (!has_hull(model, mesh)) return hull;
  const HullGraph graph(model, mesh);
  const auto vertex = [&](int id) { return mesh_vertex(model, mesh, id); };
  const auto corners = static_cast<double>(graph.corners.size());
  Vector3d middle = Vector3d::Zero();
  for (const int corner : graph.corners) {
    hull.corners.push_back(vertex(corner));
    middle += hull.corners.back() / corners;
  }
  const auto faces = static_cast<Eigen::Index>(graph.faces.size() / 3);
  hull.normals.resize(faces, 3);
  hull.offsets.resize(faces);
  int count = 0;
  for (std::size_t f = 0; f < graph.faces.size(); f += 3) {
    const Vector3d a = vertex(graph.faces[f]), b = vertex(graph.faces[f + 1]),
                   c = vertex(graph.faces[f + 2]);
    Vector3d normal = (b - a).cross(c - a);
    if (normal.norm() < kNoArea) continue;
    normal.normalize();
    if (normal.dot(middle - a) > 0.0) normal = -normal;
    hull.normals.row(count) = normal.transpose();
    hull.offsets[count++] = normal.dot(a);
  }
  hull.normals.conservativeResize(count, 3);
  hull.offsets.conservativeResize(count);
  return hull;
}

/// A ball within the hull.
struct Ball {
  Vector3d middle;
  double radius;
};

/// The largest ball in the hull that touches face `face` in the point x of it.
Ball ball_at(const Hull& hull, Eigen::Index face, const Vector3d& x) {
  const Vector3d normal = hull.normals.row(face).transpose();
  const VectorXd room = hull.room(x);
  double radius = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < room.size(); ++k) {
    const double bend = 1.0 - hull.normals.row(k).dot(normal);
    if (bend > kSameFace) radius = std::min(radius, std::max(0.0, room[k]) / bend);
  }
  return {x - radius * normal, radius};
}

/// What is looked at of a hull's surface, and balls within the hull that come near it there.
class SurfaceSamples {
 public:
  explicit SurfaceSamples(const Hull& hull) : hull_(hull) {
    Eigen::AlignedBox3d box;
    for (const Vector3d& corner : hull.corners) box.extend(corner);
    if (hull.corners.empty()) return;
    half_ = 0.5 * box.sizes();
    middle_ = box.center();
    room_ = hull.room(middle_);
    if (room_.size() < 4 || room_.minCoeff() < kNoRoom) return;
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {-1.0, 1.0})
        for (int a = 0; a < 5; ++a)
          for (int b = 0; b < 5; ++b) {
            Vector3d ray;
            ray[axis] = side;
            ray[(axis + 1) % 3] = kRayOffsets[a];
            ray[(axis + 2) % 3] = kRayOffsets[b];
            cast_ray(half_.cwiseProduct(ray), a % kEach == 0 && b % kEach == 0);
          }
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z)
          if (x != 0 || y != 0 || z != 0) add_corner(Vector3d(x, y, z).cwiseQuotient(half_));
  }
  const std::vector<Vector3d>& surface() const { return surface_; }
  const std::vector<Ball>& balls() const { return balls_; }

 private:
  void cast_ray(const Vector3d& ray, bool with_ball) {
    const VectorXd rise = hull_.normals * ray;
    Eigen::Index face = -1;
    double reach = std::numeric_limits<double>::infinity();
    for (Eigen::Index f = 0; f < rise.size(); ++f)
      if (rise[f] > 0.0 && room_[f] < reach * rise[f]) {
        reach = room_[f] / rise[f];
        face = f;
      }
    if (face < 0) return;
    surface_.push_back(middle_ + reach * ray);
    if (with_ball) balls_.push_back(ball_at(hull_, face, surface_.back()));
  }

  /// The corner that is farthest that way, and a small ball as near to it as it gets on the way to
  /// the middle.
  void add_corner(const Vector3d& way) {
    const Vector3d corner = *std::max_element(
        hull_.corners.begin(), hull_.corners.end(),
        [&](const Vector3d& a, const Vector3d& b) { return way.dot(a) < way.dot(b); });
    if (std::find(surface_.begin(), surface_.end(), corner) != surface_.end()) return;
    const double small = kCornerRadius * room_.minCoeff();
    const VectorXd there = hull_.room(corner);
    double share = 0.0;
    for (Eigen::Index f = 0; f < room_.size(); ++f)
      if (there[f] < small) share = std::max(share, (small - there[f]) / (room_[f] - there[f]));
    surface_.push_back(corner);
    balls_.push_back({corner + share * (middle_ - corner), small});
  }

  const Hull& hull_;
  Vector3d half_, middle_;
  VectorXd room_;  // of the middle, to each face
  std::vector<Vector3d> surface_;
  std::vector<Ball> balls_;
};

/// How far points, a row each, are off a capsule; zero inside. Many are asked for: in single
/// precision, all at once.
Eigen::ArrayXf beside(const HullCapsule& capsule, const Eigen::ArrayX3f& points) {
  const Eigen::Array3f from = capsule.from.cast<float>().array(),
                       along = (capsule.to - capsule.from).cast<float>().array();
  const float square = along.matrix().squaredNorm();
  const Eigen::ArrayX3f offset = points.rowwise() - from.transpose();
  Eigen::ArrayXf share = Eigen::ArrayXf::Zero(points.rows());
  if (square > 0.0f)
    share = ((offset.matrix() * along.matrix()).array() / square).max(0.0f).min(1.0f);
  const auto off = [&](int k) { return (offset.col(k) - along[k] * share).square(); };
  return ((off(0) + off(1) + off(2)).sqrt() - static_cast<float>(capsule.radius)).max(0.0f);
}

std::vector<HullCapsule> cover(const Hull& hull, int most, double enough) {
  const SurfaceSamples samples(hull);
  std::vector<HullCapsule> choice, out;
  for (std::size_t a = 0; a < samples.balls().size(); ++a)
    for (std::size_t b = a; b < samples.balls().size(); ++b) {
      const Ball &from = samples.balls()[a], &to = samples.balls()[b];
      const double radius = std::min(from.radius, to.radius);
      if (radius > kNoRoom && radius >= kUnlike * std::max(from.radius, to.radius))
        choice.push_back({from.middle, to.middle, radius});
    }
  Eigen::ArrayX3f points(static_cast<Eigen::Index>(samples.surface().size()), 3);
  for (Eigen::Index p = 0; p < points.rows(); ++p)
    points.row(p) =
        samples.surface()[static_cast<std::size_t>(p)].cast<float>().array().transpose();
  Eigen::ArrayXXf gaps(points.rows(), static_cast<Eigen::Index>(choice.size()));
  for (Eigen::Index k = 0; k < gaps.cols(); ++k)
    gaps.col(k) = beside(choice[static_cast<std::size_t>(k)], points);
  Eigen::ArrayXf left = Eigen::ArrayXf::Constant(points.rows(), 1e9f);
  while (static_cast<int>(out.size()) < most && gaps.cols() > 0 &&
         left.maxCoeff() > static_cast<float>(enough)) {
    Eigen::Index best = 0;
    float least = std::numeric_limits<float>::infinity();
    for (Eigen::Index k = 0; k < gaps.cols(); ++k)
      if (const float sum = gaps.col(k).min(left).square().sum(); sum < least) {
        least = sum;
        best = k;
      }
    left = left.min(gaps.col(best)).eval();
    out.push_back(choice[static_cast<std::size_t>(best)]);
  }
  return out;
}

/// The hulls that were covered last: a mesh whose size does not follow the design is the same in
/// every design.
class CoveredHulls {
 public:
  std::vector<HullCapsule> cover_once(Hull hull, int most, double enough) {
    {
      const std::lock_guard lock(mutex_);
      for (const Covered& each : covered_)
        if (each.most == most && each.enough == enough && each.hull == hull) return each.capsules;
    }
    std::vector<HullCapsule> capsules = cover(hull, most, enough);
    const std::lock_guard lock(mutex_);
    if (covered_.size() == kKept) covered_.pop_front();
    covered_.push_back({std::move(hull), most, enough, capsules});
    return capsules;
  }

 private:
  static constexpr std::size_t kKept = 32;  // a quadruped has some dozen
  struct Covered {
    Hull hull;
    int most;
    double enough;
    std::vector<HullCapsule> capsules;
  };
  std::mutex mutex_;
  std::deque<Covered> covered_;  // the oldest first
};

}  // namespace

std::vector<HullCapsule> cover_hull(const mjModel& model, int mesh, int most, double enough) {
  static CoveredHulls covered;
  return covered.cover_once(hull_of(model, mesh), most, enough);
}

}  // namespace legwright
