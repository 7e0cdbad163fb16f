// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/mirror.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "mjcf/read/moving_parts.hpp"
#include "mjcf/read/tree.hpp"
#include "mjcf/text/model_arrays.hpp"

namespace legwright {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kAgree =
    0.1;  // [rad]: frames that are mirror images but for the hand that drew them
constexpr double kRound = 1e-6;  // a quarter turn but for the digits of the file

Isometry3d placed(const mjModel& model, int body) {
  Isometry3d out = Isometry3d::Identity();
  out.translation() = vector_at(model.body_pos, body);
  out.linear() = rotation_at(model.body_quat, body);
  return out;
}

enum class Pose { home, drawn };

/// The frame in which a hinge's axis is given, seen from the trunk: its body's before the hinge
/// turns it. Origin: that of the body.
Isometry3d frame_of(const mjModel& model, int trunk, int joint, Pose pose) {
  const auto before = [&](int body, int end) {
    Isometry3d out = placed(model, body);
    for (int j = model.body_jntadr[body]; pose == Pose::home && j < end; ++j)
      out = out * held_displacement(model, j);
    return out;
  };
  int body = model.jnt_bodyid[joint];
  Isometry3d out = before(body, joint);
  for (body = model.body_parentid[body]; body > 0 && body != trunk;
       body = model.body_parentid[body])
    out = before(body, model.body_jntadr[body] + model.body_jntnum[body]) * out;
  return out;
}

/// From the frame that would be the mirror image to the one that is there: identity where they
/// agree.
Matrix3d disagreement(const mjModel& model, int trunk, int from, int to, Across across, Pose pose) {
  const Matrix3d image = turn_in_mirror(Vector3d::Ones(), across).asDiagonal();
  return frame_of(model, trunk, to, pose).linear().transpose() * image *
         frame_of(model, trunk, from, pose).linear() * image;
}

bool agrees(const Matrix3d& turn) { return Eigen::AngleAxisd(turn).angle() <= kAgree; }

/// Exact where frames are a quarter or half turn apart, as files mean them.
Matrix3d without_rounding(const Matrix3d& turn) {
  const Matrix3d round = turn.array().round().matrix();
  return (turn - round).cwiseAbs().maxCoeff() < kRound ? round : turn;
}

}  // namespace

Vector3d turn_in_mirror(const Vector3d& n, Across across) {
  Vector3d out = -n;
  out[static_cast<int>(across)] = n[static_cast<int>(across)];
  return out;
}

Vector3d point_in_mirror(const Vector3d& p, Across across, double middle) {
  Vector3d out = p;
  out[static_cast<int>(across)] = 2.0 * middle - p[static_cast<int>(across)];
  return out;
}

Vector3d mirrored_turn(const mjModel& model, int trunk, int from, int to, Across across,
                       const Vector3d& n) {
  Vector3d image = turn_in_mirror(n, across);
  const Matrix3d turn = disagreement(model, trunk, from, to, across, Pose::home);
  if (agrees(turn) || agrees(disagreement(model, trunk, from, to, across, Pose::drawn)))
    return image;
  return without_rounding(turn) * image;
}

bool at_mirrored_angles(const mjModel& model, int trunk, int from, int to, Across across) {
  const auto angle = [&](int joint) {
    const int at = model.jnt_qposadr[joint];
    return home_qpos(model)[at] - model.qpos0[at];
  };
  const Vector3d turn =
      mirrored_turn(model, trunk, from, to, across, vector_at(model.jnt_axis, from));
  const double way = turn.dot(vector_at(model.jnt_axis, to)) < 0.0 ? -1.0 : 1.0;
  return std::abs(std::remainder(way * angle(to) - angle(from), 2 * std::numbers::pi)) <= kAgree;
}

int mirror_image(const mjModel& model, int trunk, int joint, Across across,
                 const std::vector<int>& among) {
  const auto anchor = [&](int j) -> Vector3d {
    return frame_of(model, trunk, j, Pose::home) * vector_at(model.jnt_pos, j);
  };
  Eigen::AlignedBox3d hinges;
  for (int j = 0; j < model.njnt; ++j)
    if (model.jnt_type[j] == mjJNT_HINGE && model.body_rootid[model.jnt_bodyid[j]] == trunk)
      hinges.extend(anchor(j));
  int found = -1;
  double nearest = std::numeric_limits<double>::infinity();
  for (const double middle : {0.0, hinges.center()[static_cast<int>(across)]}) {
    const Vector3d wanted = point_in_mirror(anchor(joint), across, middle);
    for (const int other : among)
      if (const double far = (anchor(other) - wanted).norm(); far < nearest - 1e-9) {
        nearest = far;
        found = other;
      }
  }
  return found;
}

}  // namespace legwright
