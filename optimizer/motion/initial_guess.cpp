// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/initial_guess.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "optimizer/design/inertia.hpp"
#include "optimizer/motion/over_cycle.hpp"
#include "optimizer/motion/reach.hpp"

namespace legwright {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kFirstSteps = 60,
              kSteps = 12;  // of inverse kinematics, at knot 0 and from knot to knot

/// Where COM and feet shall be at each knot.
class WalkWithoutDynamics {
 public:
  WalkWithoutDynamics(const Morphology& morphology, const Layout& layout, const Task& task,
                      const WantedPath& path, const StyleTargets& style)
      : morphology_(morphology), layout_(layout), task_(task), path_(path), style_(style) {}

  Reach::Wanted at(int knot) const {
    Reach::Wanted wanted{com(knot), {}};
    for (int j = 0; j < layout_.foot_count(); ++j) wanted.feet.push_back(foot(knot, j));
    return wanted;
  }

 private:
  double phase(double knot) const { return knot / layout_.knot_count(); }
  double time(double knot) const { return knot * task_.gait.time_step(); }
  bool planted(int knot, int foot) const {
    return task_.gait.planted(knot, foot, layout_.planted_margin());
  }

  Vector3d com(int knot) const {
    Vector3d place = path_.position(time(knot));
    if (!task_.com_path.empty())
      place.head<2>() +=
          path_.heading_rotation(time(knot)) * over_cycle(task_.com_path, phase(knot));
    place.z() =
        task_.com_heights.empty() ? style_.com_height : over_cycle(task_.com_heights, phase(knot));
    return place;
  }

  /// Where the footprint is at a time, on the ground.
  Vector3d footprint(double knot, int foot) const {
    const auto index = static_cast<std::size_t>(foot);
    const bool listed = index < task_.foot_targets.size() && !task_.foot_targets[index].empty();
    const Vector2d from_path =
        listed ? over_cycle(task_.foot_targets[index], phase(knot)) : style_.footprint[index];
    Vector3d place = path_.position(time(knot));
    place.head<2>() += path_.heading_rotation(time(knot)) * from_path;
    place.z() = morphology_.feet[index].radius;
    return place;
  }

  /// The footprint in the middle of the stance that a planted knot belongs to.
  Vector3d stand(int knot, int foot) const {
    int first = knot, last = knot;
    const int most = layout_.knot_count();  // of a foot that never lifts
    while (knot - first < most && planted(first - 1, foot)) --first;
    while (last - knot < most && planted(last + 1, foot)) ++last;
    return footprint(0.5 * (first + last), foot);
  }

  Vector3d foot(int knot, int foot) const {
    if (planted(knot, foot)) return stand(knot, foot);
    int before = knot, after = knot;
    while (!planted(before, foot)) --before;
    while (!planted(after, foot)) ++after;
    const double share = static_cast<double>(knot - before) / (after - before);
    const Vector3d from = stand(before, foot), to = stand(after, foot);
    Vector3d place = from + share * share * (3.0 - 2.0 * share) * (to - from);
    place.z() += task_.swing_height * std::pow(std::sin(M_PI * share), 1.5);
    return place;
  }

  const Morphology& morphology_;
  const Layout& layout_;
  const Task& task_;
  const WantedPath& path_;
  const StyleTargets& style_;
};

/// Vertical forces of stance feet that carry the weight without tipping the robot about its COM, the
/// smallest in the sense of least squares, none below `least`.
std::vector<double> shares_of_weight(const Vector3d& com, const std::vector<Vector3d>& stance,
                                     double weight, double length, double least) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  const auto lever = [&](const Vector3d& foot) {
    return Vector3d(1.0, (foot.x() - com.x()) / length, (foot.y() - com.y()) / length);
  };
  for (const Vector3d& foot : stance) normal += lever(foot) * lever(foot).transpose();
  normal.diagonal().array() += 1e-3;  // two feet in line with the COM, or one
  const Vector3d multiplier = normal.inverse() * Vector3d(weight, 0.0, 0.0);
  std::vector<double> force;
  double sum = 0.0;
  for (const Vector3d& foot : stance) {
    force.push_back(std::max(least, multiplier.dot(lever(foot))));
    sum += force.back();
  }
  for (double& f : force) f *= weight / sum;
  return force;
}

void share_weight(const Morphology& morphology, const Layout& layout, const Task& task, int knot,
                  const Reach::Wanted& wanted, VectorXd& m) {
  const double weight = morphology.total_mass() * kGravity;
  std::vector<Vector3d> stance;
  std::vector<int> slots;
  for (int j = 0; j < layout.foot_count(); ++j)
    if (layout.force(knot, j) >= 0) {
      stance.push_back(wanted.feet[j]);
      slots.push_back(layout.force(knot, j) - layout.design_size() + 2);
    }
  const double least = (0.02 + task.min_normal) * weight;
  const std::vector<double> force =
      shares_of_weight(wanted.com, stance, weight, morphology.leg_length, least);
  for (std::size_t k = 0; k < slots.size(); ++k) m[slots[k]] = force[k];
}

}  // namespace

VectorXd initial_guess(const Morphology& morphology, const Layout& layout, const Task& task,
                       const WantedPath& path, const StyleTargets& style, const VectorXd& s) {
  const GeometryAtDesign geometry(morphology, s);
  const WalkWithoutDynamics walk(morphology, layout, task, path, style);
  Reach reach(morphology, geometry);
  const int n = layout.design_size(), T = layout.knot_count();
  VectorXd m = VectorXd::Zero(layout.motion_size()), q = VectorXd::Zero(morphology.pose_size());
  q.tail(morphology.joint_count()) = morphology.nominal_joints();
  for (int i = 0; i <= T; ++i) {
    const double time = i * task.gait.time_step();
    const Reach::Wanted wanted = walk.at(i);
    if (i == T)
      q.tail(morphology.joint_count()) =
          m.segment(layout.pose(0) - n, q.size()).tail(morphology.joint_count());
    q.head<3>() = i == 0 ? wanted.com : Vector3d(q.head<3>() + wanted.com - walk.at(i - 1).com);
    q.segment<3>(3) = Vector3d(0.0, 0.0, path.heading(time));
    reach.improve(wanted, i == 0 ? kFirstSteps : kSteps, q);
    m.segment(layout.pose(i) - n, q.size()) = q;
    m.segment<3>(layout.com(i) - n) = wanted.com;
    for (int j = 0; j < layout.foot_count(); ++j)
      m.segment<3>(layout.foot(i, j) - n) = wanted.feet[j];
    share_weight(morphology, layout, task, i, wanted, m);
  }
  return m;
}

}  // namespace legwright
