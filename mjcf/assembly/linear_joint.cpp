// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/linear_joint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kLeastArm = 1e-3;         // [m]
constexpr double kLeastShareOfArm = 0.25;  // of the most, at the ends of the range
constexpr double kAngles = 100.0;          // tried in a radian
constexpr double kStrokeGrain = 1e-9;      // [m]
constexpr double kRiseTime = 0.03;         // [s], of motor and gears without load
constexpr double kNoWayAcross = 1e-9;      // [m]: no way across an axis

Vector3d across(const Vector3d& axis, const Vector3d& v) { return v - axis.dot(v) * axis; }

/// A unit vector square to the axis along the way to the joint above; of hinges about it another.
Vector3d way_above(const AssemblyJoint& joint) {
  const Vector3d way = across(joint.axis, -joint.offset);
  return way.norm() > kNoWayAcross ? way.normalized() : joint.axis.unitOrthogonal();
}

Vector3d turned_lever(const AssemblyJoint& joint, const LinearPivots& pivots, double angle) {
  return Eigen::AngleAxisd(angle, joint.axis) * pivots.lever;
}

double length_of(const AssemblyJoint& joint, const LinearPivots& pivots, double angle) {
  return (turned_lever(joint, pivots, angle) - pivots.mount).norm();
}

double arm_of(const AssemblyJoint& joint, const LinearPivots& pivots, double angle) {
  const Vector3d lever = turned_lever(joint, pivots, angle), along = lever - pivots.mount;
  return along.dot(joint.axis.cross(lever)) / along.norm();
}

}  // namespace

LinearPivots pivots_of(const AssemblyJoint& joint) {
  const ModuleSlide& slide = *joint.servo.slide;
  const Vector3d above = way_above(joint);
  LinearPivots out;
  if (joint.lever) {
    out.lever = *joint.lever;
  } else {
    Vector3d side = joint.axis.cross(above);
    if (side.x() < 0.0) side = -side;
    out.lever = 0.5 * slide.stroke * side;
  }
  out.mount = joint.mount.value_or(out.lever + slide.middle() * above);
  return out;
}

double length_at(const AssemblyJoint& joint, double angle) {
  return length_of(joint, pivots_of(joint), angle);
}

double moment_arm_at(const AssemblyJoint& joint, double angle) {
  return arm_of(joint, pivots_of(joint), angle);
}

std::array<double, 2> linear_range(const AssemblyJoint& joint) {
  const ModuleSlide& slide = *joint.servo.slide;
  const LinearPivots pivots = pivots_of(joint);
  const double sign = std::copysign(1.0, arm_of(joint, pivots, 0.0));
  double most = 0.0;
  const auto holds = [&](double angle) {
    const double length = length_of(joint, pivots, angle);
    return length >= slide.retracted - kStrokeGrain && length <= slide.extended() + kStrokeGrain &&
           sign * arm_of(joint, pivots, angle) > 0.0;
  };
  const auto end = [&](double direction, double least_arm) {
    int k = 0;
    while ((k + 1) / kAngles < std::numbers::pi && holds(direction * (k + 1) / kAngles) &&
           sign * arm_of(joint, pivots, direction * (k + 1) / kAngles) >= least_arm)
      ++k;
    return k;
  };
  for (int k = -end(-1.0, 0.0); k <= end(1.0, 0.0); ++k)
    most = std::max(most, sign * arm_of(joint, pivots, k / kAngles));
  const double least = kLeastShareOfArm * most;
  std::array out{-end(-1.0, least) / kAngles, end(1.0, least) / kAngles};
  if (joint.range) out = {std::max(out[0], (*joint.range)[0]), std::min(out[1], (*joint.range)[1])};
  return out;
}

Eigen::Isometry3d linear_pose(const AssemblyJoint& joint) {
  const ModuleSlide& slide = *joint.servo.slide;
  const LinearPivots pivots = pivots_of(joint);
  const auto frame = [](const Vector3d& along, const Vector3d& wanted) {
    const Vector3d rest = across(along, wanted);
    const Vector3d side = rest.norm() > kNoWayAcross ? rest.normalized() : along.unitOrthogonal();
    Eigen::Matrix3d out;
    out << along, side, along.cross(side);
    return out;
  };
  const Vector3d along = (pivots.lever - pivots.mount).normalized(),
                 body = inertia_of(without_rod(joint.servo)).centre - slide.position;
  Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
  out.linear() = Eigen::AngleAxisd(joint.roll, along) * frame(along, pivots.mount) *
                 frame(slide.axis, body).transpose();
  out.translation() = pivots.mount - out.linear() * slide.position;
  return out;
}

std::optional<double> reflected_mass(const ModuleSlide& slide) {
  if (slide.reflected_mass) return slide.reflected_mass;
  if (!slide.no_load_speed) return std::nullopt;
  return kRiseTime * slide.line_force() / *slide.no_load_speed;
}

std::string why_not_turned(const AssemblyJoint& joint) {
  const ModuleSlide& slide = *joint.servo.slide;
  const double length = length_at(joint, 0.0);
  if (length < slide.retracted || length > slide.extended())
    return fmt::format(
        "puts the pivots of {} {:.4g} mm apart; between them it is {:.4g} to {:.4g} mm long. Give "
        "another mount or lever, or no mount: then it stands at half its stroke",
        joint.servo.name, 1e3 * length, 1e3 * slide.retracted, 1e3 * slide.extended());
  const double arm = moment_arm_at(joint, 0.0);
  if (std::abs(arm) < kLeastArm)
    return fmt::format(
        "gives {} a moment arm of {:.2g} mm about the joint as drawn; expected {:.2g} and more: "
        "move lever or mount off the line through the joint",
        joint.servo.name, 1e3 * std::abs(arm), 1e3 * kLeastArm);
  return "";
}

}  // namespace legwright
