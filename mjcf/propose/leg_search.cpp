// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/leg_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "mjcf/read/feet.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kBesideWeight = 0.25;  // of the place beside the hip against that below it
constexpr double kBelowWeight = 4.0;
constexpr double kDiagonal = 1e-3;  // of a direction at 45 degrees, which counts as along x
constexpr double kParallel = 0.9;   // least cosine between hinges that bend a leg in one plane
constexpr double kLevelKnee = 0.5;  // of a hinge's axis: else it is no knee that bends the leg
constexpr double kKneeBack = 0.02, kNearRest = 0.003;
constexpr std::size_t kSearchStarts = 6;  // of the grid, from which the search goes on
constexpr std::size_t kMostHingesOnGrid = 6;
constexpr int kMostRounds = 200;  // along all angles; in a narrow valley each would gain a little
constexpr double kFirstTurn = 0.2, kLastTurn = 1e-6;  // [rad]
constexpr double kExactHeight = 1e-9;                 // [m]
constexpr int kMostSteps = 50;                        // to it
constexpr double kMirrored = 1e-3;       // of the reach, of a direction: with the same zeros
constexpr double kMirroredPlace = 0.03;  // of the reach: hinges of legs that are mirror images
constexpr double kMirroredLine = 0.05;   // [rad]: the same of their axes
constexpr double kSameZero = 1e-3;       // [rad]: angles of mirror images that are rounded
constexpr double kOnAxis = 0.05;         // of the reach: what no turn about an axis moves much

VectorXd rest_of(const SearchedLeg& leg) {
  VectorXd out(static_cast<Eigen::Index>(leg.joints.size()));
  for (std::size_t k = 0; k < leg.joints.size(); ++k)
    out[static_cast<Eigen::Index>(k)] = std::clamp(0.0, leg.lower[k], leg.upper[k]);
  return out;
}

/// Least cost of a leg's angles: a grid, then steps along one angle each, from its best points.
class LegSearch {
 public:
  using Cost = std::function<double()>;  // of the pose in data
  LegSearch(const SearchedLeg& leg, const mjModel& model, mjData& data, Cost cost)
      : leg_(leg), model_(model), data_(data), cost_(std::move(cost)), rest_(rest_of(leg)) {}

  /// Leaves the best angles in the data.
  void run() {
    grid(rest_, 0);
    std::stable_sort(points_.begin(), points_.end(),
                     [](const Point& a, const Point& b) { return a.cost < b.cost; });
    points_.resize(std::min(points_.size(), kSearchStarts));
    Point best{std::numeric_limits<double>::infinity(), rest_};
    for (Point& point : points_) {
      descend(point);
      if (point.cost < best.cost) best = point;
    }
    leg_.set_angles(model_, data_, best.angles);
  }

 private:
  struct Point {
    double cost;
    VectorXd angles;
  };

  double cost_at(const VectorXd& angles) {
    leg_.set_angles(model_, data_, angles);
    return cost_() + kNearRest * (angles - rest_).squaredNorm();
  }

  void grid(VectorXd angles, std::size_t joint) {
    if (joint == leg_.joints.size()) {
      points_.push_back({cost_at(angles), angles});
      return;
    }
    const auto k = static_cast<Eigen::Index>(joint);
    // No leg has as many hinges as an arm with its fingers: what is beyond is left in the middle.
    const int count = leg_.joints.size() <= 3 ? 7 : joint < kMostHingesOnGrid ? 3 : 1;
    for (int n = 0; n < count; ++n) {
      const double share = (n + 0.5) / count;
      angles[k] = leg_.lower[joint] + share * (leg_.upper[joint] - leg_.lower[joint]);
      grid(angles, joint + 1);
    }
  }

  void descend(Point& point) {
    double step = kFirstTurn;
    for (int round = 0; round < kMostRounds && step > kLastTurn; ++round) {
      bool better = false;
      for (Eigen::Index k = 0; k < point.angles.size(); ++k)
        for (const double sign : {1.0, -1.0}) {
          const auto joint = static_cast<std::size_t>(k);
          VectorXd next = point.angles;
          next[k] = std::clamp(next[k] + sign * step, leg_.lower[joint], leg_.upper[joint]);
          const double cost = cost_at(next);
          if (!(cost < point.cost)) continue;
          point = {cost, std::move(next)};
          better = true;
        }
      step *= better ? 1.0 : 0.5;
    }
  }

  const SearchedLeg& leg_;
  const mjModel& model_;
  mjData& data_;
  const Cost cost_;
  const VectorXd rest_;
  std::vector<Point> points_;
};

/// The direction that most hinges have, as those that pitch at hip, knee and ankle; of as many the
/// last, as a knee below a hip that rolls.
Vector3d bending_axis(const mjData& data, const std::vector<int>& joints) {
  const auto axis = [&](int joint) {
    return Vector3d(Vector3d::Map(data.xaxis + std::ptrdiff_t{3} * joint));
  };
  Vector3d best = axis(joints.back());
  std::ptrdiff_t most = 0;
  for (const int joint : joints) {
    const auto parallel = std::count_if(joints.begin(), joints.end(), [&](int other) {
      return std::abs(axis(joint).dot(axis(other))) > kParallel;
    });
    if (parallel < most) continue;
    most = parallel;
    best = axis(joint);
  }
  return best;
}

/// The turn about an axis that leads one vector nearest to another; 0 where one is along the axis.
double turn_about(const Vector3d& axis, const Vector3d& from, const Vector3d& to, double least) {
  const Vector3d a = from - axis.dot(from) * axis, b = to - axis.dot(to) * axis;
  return std::min(a.norm(), b.norm()) > least ? std::atan2(axis.dot(a.cross(b)), a.dot(b)) : 0.0;
}

}  // namespace

Vector3d SearchedLeg::touch(const mjModel& model, const mjData& data) const {
  int geom = -1;
  double low = std::numeric_limits<double>::infinity();
  for (const bool drawn : {false, true}) {
    for (const int body : bodies)
      for (int k = 0; k < model.body_geomnum[body]; ++k) {
        const int g = model.body_geomadr[body] + k;
        if (!drawn && !collides(model, g)) continue;
        if (const double own = lowest_point(model, data, g); own < low) {
          low = own;
          geom = g;
        }
      }
    if (geom >= 0) break;
  }
  if (geom < 0) return Vector3d::Map(data.xpos + std::ptrdiff_t{3} * bodies.back());
  return lowest_place(model, data, geom);
}

Vector3d SearchedLeg::tip(const mjModel& model, const mjData& data) const {
  Vector3d sums[2] = {Vector3d::Zero(), Vector3d::Zero()};  // of what is drawn, of what collides
  int counts[2] = {0, 0};
  for (const int body : bodies)
    for (int g = model.body_geomadr[body]; g < model.body_geomadr[body] + model.body_geomnum[body];
         ++g) {
      const int which = collides(model, g) ? 1 : 0;
      sums[which] += Vector3d::Map(data.geom_xpos + std::ptrdiff_t{3} * g);
      ++counts[which];
    }
  for (const int which : {1, 0})
    if (counts[which] > 0) return sums[which] / counts[which];
  return Vector3d::Map(data.xipos + std::ptrdiff_t{3} * bodies.back());
}

VectorXd SearchedLeg::angles_in(const mjModel& model, const mjData& data) const {
  VectorXd out(static_cast<Eigen::Index>(joints.size()));
  for (std::size_t k = 0; k < joints.size(); ++k)
    out[static_cast<Eigen::Index>(k)] = data.qpos[model.jnt_qposadr[joints[k]]];
  return out;
}

void SearchedLeg::set_angles(const mjModel& model, mjData& data, const VectorXd& angles) const {
  for (std::size_t k = 0; k < joints.size(); ++k)
    data.qpos[model.jnt_qposadr[joints[k]]] = angles[static_cast<Eigen::Index>(k)];
  mj_kinematics(&model, &data);
}

Vector3d SearchedLeg::ahead() const {
  const Vector3d out = side.cross(Vector3d::UnitZ());
  const bool along_x = std::abs(out.x()) >= std::abs(out.y()) - kDiagonal;
  return (along_x ? out.x() : out.y()) < 0.0 ? Vector3d(-out) : out;
}

Vector3d SearchedLeg::below_hip() const {
  Vector3d out = stands_beside() ? rest : hip + (rest - hip).dot(side) * side;
  out.z() = 0.0;
  return out;
}

bool SearchedLeg::turns_level() const { return std::abs(axes.front().z()) > kParallel; }

bool SearchedLeg::sprawls() const { return joints.size() > 2 && turns_level(); }

Vector3d SearchedLeg::outwards() const {
  Vector3d out = hip - anchors.front();
  out.z() = 0.0;
  return out.norm() > 1e-3 * reach ? Vector3d(out.normalized()) : Vector3d::Zero().eval();
}

void SearchedLeg::measure(const mjModel& model, mjData& data) {
  const VectorXd before = angles_in(model, data);
  set_angles(model, data, rest_of(*this));
  hip = Vector3d::Map(data.xanchor + std::ptrdiff_t{3} * hip_joint());
  rest = touch(model, data);
  end = tip(model, data);
  for (const int joint : joints) {
    anchors.push_back(Vector3d::Map(data.xanchor + std::ptrdiff_t{3} * joint));
    axes.push_back(Vector3d::Map(data.xaxis + std::ptrdiff_t{3} * joint));
  }
  const Vector3d axis = bending_axis(data, joints);
  if (const double level = axis.head<2>().norm(); level > kLevelKnee)
    side = Vector3d(axis.x() / level, axis.y() / level, 0.0);
  LegSearch(*this, model, data, [&] { return touch(model, data).z(); }).run();
  reach = std::max(1e-6, data.xanchor[3 * hip_joint() + 2] - touch(model, data).z());
  set_angles(model, data, before);
}

bool SearchedLeg::turn_to_image(const Image& image, bool own_zeros, VectorXd& at_rest,
                                const mjModel& model, mjData& data) const {
  const double place = (own_zeros ? kMirrored : kMirroredPlace) * reach,
               line = own_zeros ? kMirrored : kMirroredLine;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    set_angles(model, data, at_rest);
    const auto anchor = [&](std::size_t joint) {
      return Vector3d(Vector3d::Map(data.xanchor + std::ptrdiff_t{3} * joints[joint]));
    };
    const Vector3d axis = Vector3d::Map(data.xaxis + std::ptrdiff_t{3} * joints[k]);
    const double sign = axis.dot(image.axes[k]) > 0.0 ? 1.0 : -1.0;
    if ((image.anchors[k] - anchor(k)).norm() > place ||
        (image.axes[k] - sign * axis).norm() > line)
      return false;
    if (own_zeros) continue;
    const bool last = k + 1 == joints.size();
    const Vector3d next = last ? tip(model, data) : anchor(k + 1),
                   wanted = last ? image.tip : image.anchors[k + 1];
    const double turn =
        turn_about(axis, next - anchor(k), wanted - image.anchors[k], kOnAxis * reach);
    if (std::abs(turn) > kSameZero) at_rest[static_cast<Eigen::Index>(k)] += turn;
  }
  set_angles(model, data, at_rest);
  return (tip(model, data) - image.tip).norm() <= kMirroredPlace * reach;
}

std::optional<VectorXd> SearchedLeg::mirror_of(const SearchedLeg& other, const Vector3d& trunk,
                                               const Vector3d& plane, const mjModel& model,
                                               mjData& data) const {
  if (other.joints.size() != joints.size()) return std::nullopt;
  const auto image_of = [&](const Vector3d& place) {
    return Vector3d(trunk + plane.cwiseProduct(place - trunk));
  };
  Image image{{}, {}, image_of(other.end)};
  for (std::size_t k = 0; k < joints.size(); ++k) {
    image.anchors.push_back(image_of(other.anchors[k]));
    image.axes.emplace_back(plane.cwiseProduct(other.axes[k]));
  }
  const VectorXd before = angles_in(model, data);
  VectorXd out = rest_of(*this);
  bool found = turn_to_image(image, true, out, model, data);
  if (!found) out = rest_of(*this);
  found = found || turn_to_image(image, false, out, model, data);
  std::vector<bool> along(joints.size());  // then a turn of the image is the other way round
  for (std::size_t k = 0; k < joints.size(); ++k)
    along[k] = image.axes[k].dot(Vector3d::Map(data.xaxis + std::ptrdiff_t{3} * joints[k])) > 0.0;
  set_angles(model, data, before);
  const VectorXd turns = other.angles_in(model, data) - rest_of(other);
  for (std::size_t k = 0; k < joints.size() && found; ++k) {
    double& angle = out[static_cast<Eigen::Index>(k)];
    angle += (along[k] ? -1.0 : 1.0) * turns[static_cast<Eigen::Index>(k)];
    found = angle >= lower[k] && angle <= upper[k];
  }
  return found ? std::optional(out) : std::nullopt;
}

bool SearchedLeg::put(const mjModel& model, mjData& data, const Vector3d& place,
                      const Vector3d& knee_to) const {
  const Vector3d forwards = ahead();
  const auto cost = [&] {
    const Vector3d miss = (touch(model, data) - place) / reach;
    const Vector3d knee = Vector3d::Map(data.xanchor + std::ptrdiff_t{3} * joints.back()) - hip;
    const double along = forwards.dot(miss), beside = side.dot(miss);
    return along * along + kBesideWeight * beside * beside + kBelowWeight * miss.z() * miss.z() -
           kKneeBack * knee_to.dot(knee) / reach;
  };
  LegSearch(*this, model, data, cost).run();
  return rise_to(place.z(), model, data) || rise_towards_rest(place.z(), model, data);
}

bool SearchedLeg::rise_to(double height, const mjModel& model, mjData& data) const {
  VectorXd angles = angles_in(model, data);
  for (int step = 0; step < kMostSteps; ++step) {
    const double miss = touch(model, data).z() - height;
    if (std::abs(miss) <= kExactHeight) return true;
    VectorXd slope(angles.size());
    for (Eigen::Index k = 0; k < angles.size(); ++k) {
      constexpr double kTurn = 1e-6;
      VectorXd next = angles;
      next[k] += kTurn;
      set_angles(model, data, next);
      slope[k] = (touch(model, data).z() - height - miss) / kTurn;
    }
    if (!(slope.norm() > 1e-6 * reach)) break;
    angles -= miss / slope.squaredNorm() * slope;
    for (std::size_t k = 0; k < joints.size(); ++k) {
      double& angle = angles[static_cast<Eigen::Index>(k)];
      angle = std::clamp(angle, lower[k], upper[k]);
    }
    set_angles(model, data, angles);
  }
  set_angles(model, data, angles);
  return std::abs(touch(model, data).z() - height) <= kExactHeight;
}

bool SearchedLeg::rise_towards_rest(double height, const mjModel& model, mjData& data) const {
  const VectorXd from = angles_in(model, data), to = rest_of(*this);
  const auto miss = [&](double share) {
    set_angles(model, data, (1.0 - share) * from + share * to);
    return touch(model, data).z() - height;
  };
  double below = 0.0, above = 1.0;
  if (!(miss(below) < 0.0) || !(miss(above) > 0.0)) return false;
  double off = miss(below);
  for (int step = 0; step < kMostSteps && std::abs(off) > kExactHeight; ++step) {
    const double middle = 0.5 * (below + above);
    off = miss(middle);
    (off < 0.0 ? below : above) = middle;
  }
  return std::abs(off) <= kExactHeight;
}

}  // namespace legwright
