// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/link_hulls.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mjcf/assembly/outline_hulls.hpp"

namespace legwright {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr int kPadCorners = 8;
constexpr double kLeastFacing = 0.3;      // cosine between an attachment's normal and the way to it
constexpr double kElbowStep = 2e-3;       // [m] between bosses that are tried
constexpr double kClearanceGrain = 1e-9;  // [m]

using PadPoints = std::vector<Vector3d>;

Vector3d across_normal(const Vector3d& normal, const Vector3d& wanted) {
  const Vector3d rest = wanted - normal.dot(wanted) * normal;
  if (rest.norm() > 1e-6) return rest.normalized();
  return normal.unitOrthogonal();
}

/// A round plate of some corners, from `low` to `high` along its normal.
PadPoints pad(const Vector3d& centre, const Vector3d& normal, const Vector3d& towards,
              double radius, double low, double high) {
  const Vector3d side = across_normal(normal, towards), other = normal.cross(side);
  PadPoints out;
  for (const double height : {low, high})
    for (int k = 0; k < kPadCorners; ++k) {
      const double turn = 2.0 * std::numbers::pi * (k + 0.5) / kPadCorners;
      out.push_back(centre + height * normal +
                    radius * (std::cos(turn) * side + std::sin(turn) * other));
    }
  return out;
}

bool lets_cable_out(const Module& module, const Attachment& at) {
  return std::find(module.cable.begin(), module.cable.end(), at.name) != module.cable.end();
}

class LinkShaper {
 public:
  LinkShaper(const LinkEnds& ends, const PadSizes& pads)
      : ends_(ends),
        radius_(pads.radius),
        end_radius_(pads.end_radius),
        wall_(pads.wall),
        clearance_(pads.clearance) {}

  LinkHulls run() {
    find_facing();
    if (facing_.empty()) return {};
    sweep_servo();
    LinkHulls best;
    best.clearance = -1.0;
    const auto is_enough = [&](const std::vector<LinkHull>& hulls) {
      const double least = least_distance(hulls);
      if (least > best.clearance) best = {hulls, least, cable_at_};
      return least >= clearance_ - kClearanceGrain;
    };
    const Vector3d way = middle_ - ends_.axis.dot(middle_) * ends_.axis;
    if (is_enough({straight()})) return best;
    for (double reach = radius_; reach < way.norm(); reach += kElbowStep)
      if (is_enough(bent(reach * way.normalized()))) return best;
    is_enough({pulled_back()});
    return best;
  }

 private:
  /// Height over the horn's plane of what is fixed to the horn, which stands out by the clearance.
  double low() const { return clearance_; }
  double high() const { return clearance_ + wall_; }

  /// The attachments of the other module that look at the horn: the one that does most, and those
  /// that do nearly as much. Where cables leave, whose slots are cut through what lies there, only
  /// if no other does.
  void find_facing() {
    const Vector3d horn = 0.5 * (low() + high()) * ends_.axis;
    const auto facing = [&](const Attachment& at) {
      const Vector3d point = ends_.place + ends_.other_pose * at.position;
      return (ends_.other_pose.linear() * at.normal).dot((horn - point).normalized());
    };
    std::vector<const Attachment*> free, at_cables;
    for (const Attachment& at : ends_.other->attachments)
      if (!at.on_horn && facing(at) > kLeastFacing)
        (lets_cable_out(*ends_.other, at) ? at_cables : free).push_back(&at);
    double most = kLeastFacing;
    const auto& candidates = free.empty() ? at_cables : free;
    for (const Attachment* at : candidates) most = std::max(most, facing(*at));
    for (const Attachment* at : candidates)
      if (facing(*at) >= most - 1e-9) facing_.push_back(at);
    if (free.empty() && !facing_.empty()) cable_at_ = facing_.front()->name;
    for (const Attachment* at : facing_)
      middle_ +=
          (ends_.place + ends_.other_pose * at->position) / static_cast<double>(facing_.size());
  }

  /// Where the servo is, as seen from the link, at angles at which the modules keep clear of each
  /// other; at all where they do at none.
  void sweep_servo() {
    const OutlineHulls others = other_end_of_link(ends_);
    OutlineHulls all;
    for (int k = 0; k < kSampledAngles; ++k) {
      const OutlineHulls servo = servo_seen_from_link(ends_, k);
      const bool is_clear = hull_distance(servo, others) >= clearance_;
      for (OutlineHulls* into : {&all, is_clear ? &swept_ : nullptr})
        if (into) into->insert(into->end(), servo.begin(), servo.end());
    }
    if (swept_.empty()) swept_ = all;
  }

  double least_distance(const std::vector<LinkHull>& hulls) const {
    double least = std::numeric_limits<double>::infinity();
    for (const LinkHull& hull : hulls) {
      OutlineHull whole{hull.near, 0.0};
      for (const Vector3d& point : hull.far) whole.points.push_back(ends_.place + point);
      for (const OutlineHull& servo : swept_) least = std::min(least, hull_distance(whole, servo));
    }
    return least;
  }

  PadPoints near_pad(const Vector3d& centre) const {
    return pad(centre, ends_.axis, middle_, radius_, low(), high());
  }

  /// On the faces of a servo; within a foot, whose face may be round.
  PadPoints far_pads() const {
    const bool is_foot = ends_.other->kind == ModuleKind::foot;
    PadPoints out;
    for (const Attachment* at : facing_) {
      const PadPoints one =
          pad(ends_.other_pose * at->position, ends_.other_pose.linear() * at->normal, ends_.axis,
              end_radius_, is_foot ? -wall_ : 0.0, is_foot ? 0.0 : wall_);
      out.insert(out.end(), one.begin(), one.end());
    }
    return out;
  }

  LinkHull straight() const { return {"arm", near_pad(Vector3d::Zero()), far_pads()}; }

  std::vector<LinkHull> bent(const Vector3d& elbow) const {
    LinkHull boss{"boss", near_pad(Vector3d::Zero()), {}};
    const PadPoints end = near_pad(elbow);
    boss.near.insert(boss.near.end(), end.begin(), end.end());
    return {boss, {"arm", end, far_pads()}};
  }

  LinkHull pulled_back() const {
    LinkHull out = straight();
    for (Vector3d& point : out.far) {
      const double height = ends_.axis.dot(ends_.place + point);
      point += std::max(0.0, low() - height) * ends_.axis;
    }
    return out;
  }

  const LinkEnds& ends_;
  const double radius_, end_radius_, wall_, clearance_;  // [m]
  std::vector<const Attachment*> facing_;
  std::string cable_at_;                // that of those where a cable leaves; empty: none
  Vector3d middle_ = Vector3d::Zero();  // of those, in the link
  OutlineHulls swept_;
};

}  // namespace

Isometry3d turn_to_link(const LinkEnds& ends, int sample) {
  const double share = sample / (kSampledAngles - 1.0);
  const double angle = ends.range[0] + share * (ends.range[1] - ends.range[0]);
  return Isometry3d(Eigen::AngleAxisd(-angle, ends.axis));
}

OutlineHulls servo_seen_from_link(const LinkEnds& ends, int sample) {
  return outline_hulls(*ends.servo, turn_to_link(ends, sample) * ends.servo_pose);
}

OutlineHulls other_end_of_link(const LinkEnds& ends) {
  Isometry3d pose = ends.other_pose;
  pose.translation() += ends.place;
  return outline_hulls(*ends.other, pose);
}

LinkHulls link_hulls(const LinkEnds& ends, const PadSizes& pads) {
  return LinkShaper(ends, pads).run();
}

}  // namespace legwright
