// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/initial_guess.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "optimizer/design/inertia.hpp"
#include "optimizer/motion/cycle_target.hpp"
#include "optimizer/motion/margins.hpp"
#include "optimizer/motion/over_cycle.hpp"
#include "optimizer/motion/standing.hpp"
#include "optimizer/motion/whole_body_ik.hpp"

namespace legwright {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Steps of inverse kinematics, at knot 0 and from knot to knot.
constexpr int kFirstSteps = 60, kSteps = 12;
constexpr double kEasyPose = 0.03;  // (q − home)² against (miss/leg length)² of feet on the ground

/// Wanted places of COM and feet at each knot.
class WalkWithoutDynamics {
 public:
  WalkWithoutDynamics(const Morphology& morphology, const Layout& layout, const Task& task,
                      const WantedPath& path, const StyleTargets& style)
      : morphology_(morphology), layout_(layout), task_(task), path_(path), style_(style) {}

  WholeBodyIk::Places at(int knot) const {
    WholeBodyIk::Places wanted{com(knot), {}};
    for (int j = 0; j < layout_.foot_count(); ++j) wanted.feet.push_back(foot(knot, j));
    wanted.heading = path_.heading(time(knot));
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
    const Stance stance = task_.gait.stance_around(knot, foot, layout_.planted_margin());
    return footprint(0.5 * (stance.first + stance.last), foot);
  }

  Vector3d foot(int knot, int foot) const {
    if (planted(knot, foot)) return stand(knot, foot);
    int before = knot, after = knot;
    while (!planted(before, foot)) --before;
    while (!planted(after, foot)) ++after;
    const double share = static_cast<double>(knot - before) / (after - before);
    const Vector3d from = stand(before, foot), to = stand(after, foot);
    Vector3d place = from + share * share * (3.0 - 2.0 * share) * (to - from);
    const CycleTarget* height = target_of(task_.foot_heights, foot);
    place.z() += height != nullptr
                     ? height->at(phase(knot))
                     : style_.swing_height * std::pow(std::sin(std::numbers::pi * share), 1.5);
    return place;
  }

  const Morphology& morphology_;
  const Layout& layout_;
  const Task& task_;
  const WantedPath& path_;
  const StyleTargets& style_;
};

void share_weight(const Morphology& morphology, const Layout& layout, const Task& task, int knot,
                  const WholeBodyIk::Places& wanted, VectorXd& m) {
  const double weight = morphology.total_mass() * kGravity;
  std::vector<Vector3d> stance;
  std::vector<int> slots;
  for (int j = 0; j < layout.foot_count(); ++j)
    if (layout.force(knot, j) >= 0) {
      stance.push_back(wanted.feet[j]);
      slots.push_back(layout.force(knot, j) - layout.design_size());
    }
  Vector3d below = wanted.com;
  below.head<2>() -= below.z() / task.up.z() * task.up.head<2>();
  const double least = (0.02 + task.min_normal) * weight;
  const std::vector<double> force =
      shares_of_weight(below, stance, weight, morphology.leg_length, least);
  for (std::size_t k = 0; k < slots.size(); ++k) m.segment<3>(slots[k]) = force[k] * task.up;
}

/// The home pose with the root at a place.
VectorXd home_at(const Morphology& morphology, const Vector3d& place) {
  VectorXd q = VectorXd::Zero(morphology.pose_size());
  q.head<3>() = place;
  q.tail(morphology.joint_count()) = morphology.nominal_joints();
  return q;
}

/// The footprint as near to the wanted one as is easy for the joints: feet on the ground, COM at
/// its height.
StyleTargets reachable(const Morphology& morphology, const GeometryAtDesign& geometry,
                       const StyleTargets& style) {
  WholeBodyIkWeights weights;
  weights.foot.z() = 100.0;
  weights.pose = kEasyPose;
  WholeBodyIk ik(morphology, geometry, weights);
  WholeBodyIk::Places wanted{Vector3d(0.0, 0.0, style.com_height), {}};
  for (std::size_t j = 0; j < morphology.feet.size(); ++j)
    wanted.feet.emplace_back(style.footprint[j].x(), style.footprint[j].y(),
                             morphology.feet[j].radius);
  VectorXd q = home_at(morphology, wanted.com);
  ik.improve(wanted, kFirstSteps, q);
  const WholeBodyIk::Places found = ik.places_at(q);
  StyleTargets result = style;
  for (std::size_t j = 0; j < morphology.feet.size(); ++j)
    result.footprint[j] = (found.feet[j] - found.com).head<2>();
  return result;
}

/// Poses of knots 0 … T by inverse kinematics, each from the one before.
std::vector<VectorXd> poses_at(const Morphology& morphology, const GeometryAtDesign& geometry,
                               const Task& task, const WantedPath& path,
                               const std::vector<WholeBodyIk::Places>& wanted) {
  WholeBodyIk ik(morphology, geometry, {});
  std::vector<VectorXd> poses;
  for (std::size_t i = 0; i + 1 < wanted.size(); ++i) {
    VectorXd q = i == 0 ? home_at(morphology, wanted[0].com) : poses.back();
    if (i > 0) q.head<3>() += wanted[i].com - wanted[i - 1].com;
    q[5] = path.heading(static_cast<double>(i) * task.gait.time_step());
    ik.improve(wanted[i], i == 0 ? kFirstSteps : kSteps, q);
    poses.push_back(std::move(q));
  }
  VectorXd last = poses.front();  // one cycle later
  last.head<3>() = path.turn() * last.head<3>() + path.travel();
  last[5] += path.turn_angle();
  poses.push_back(std::move(last));
  return poses;
}

}  // namespace

StyleTargets style_targets(const Morphology& morphology, const VectorXd& initial,
                           const Task& task) {
  StyleTargets home = home_stance(morphology, initial);
  const double height = task.com_height.value_or(home.com_height);
  for (Vector2d& foot : home.footprint) foot -= height / task.up.z() * task.up.head<2>();
  StyleTargets style{height, task.footprint.value_or(home.footprint),
                     swing_height(task, standing_leg(morphology, initial))};
  if (task.follow_hips.value_or(!task.footprint))
    style.footprint_slopes = hip_slopes(morphology, initial);
  return style;
}

StyleTargets at_design(StyleTargets style, const VectorXd& change) {
  for (std::size_t j = 0; j < style.footprint_slopes.size(); ++j)
    style.footprint[j] += style.footprint_slopes[j] * change;
  return style;
}

VectorXd initial_guess(const Morphology& morphology, const Layout& layout, const Task& task,
                       const WantedPath& path, const StyleTargets& style, const VectorXd& s) {
  const GeometryAtDesign geometry(morphology, s);
  const StyleTargets within_reach = reachable(morphology, geometry, style);
  const WalkWithoutDynamics walk(morphology, layout, task, path, within_reach);
  std::vector<WholeBodyIk::Places> wanted;
  for (int i = 0; i <= layout.knot_count(); ++i) wanted.push_back(walk.at(i));
  const std::vector<VectorXd> poses = poses_at(morphology, geometry, task, path, wanted);
  const int n = layout.design_size();
  VectorXd m = VectorXd::Zero(layout.motion_size());
  for (int i = 0; i <= layout.knot_count(); ++i) {
    m.segment(layout.pose(i) - n, layout.pose_size()) = poses[i];
    m.segment<3>(layout.com(i) - n) = wanted[i].com;
    for (int j = 0; j < layout.foot_count(); ++j)
      m.segment<3>(layout.foot(i, j) - n) = wanted[i].feet[j];
    share_weight(morphology, layout, task, i, wanted[i], m);
  }
  return m;
}

}  // namespace legwright
