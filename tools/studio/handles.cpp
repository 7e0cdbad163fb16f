// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/handles.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "mjcf/text/model_arrays.hpp"
#include "tools/drawables/drawn_design.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

// Shares of a step below which something does not move: texts have 12 digits.
constexpr double kStill = 1e-4;
constexpr double kStep = 1e-4;  // of a parameter's scale

/// Two designs, one of whose parameters differ by `step`.
struct Neighbours {
  const mjModel& at;
  const mjModel& moved;
  double step;

  Vector3d rate(const mjtNum* here, const mjtNum* there, int id) const {
    return (vector_at(there, id) - vector_at(here, id)) / step;
  }
};

/// About which axis, and by how much for each unit, a joint's axis turns.
std::optional<Vector3d> turn_of(const Neighbours& two, int joint) {
  const Vector3d before = vector_at(two.at.jnt_axis, joint);
  const Vector3d rate = two.rate(two.at.jnt_axis, two.moved.jnt_axis, joint);
  if (rate.norm() < kStill) return std::nullopt;
  return before.cross(rate);
}

std::vector<HandleAnchor> turns(const Neighbours& two) {
  std::vector<HandleAnchor> out;
  for (int joint = 0; joint < two.at.njnt; ++joint)
    if (const auto about = turn_of(two, joint))
      out.push_back({HandleAnchor::Kind::joint, joint, two.at.jnt_bodyid[joint], *about});
  return out;
}

/// Bodies whose places in their parents move, by parent.
std::vector<HandleAnchor> moved_bodies(const Neighbours& two) {
  std::vector<HandleAnchor> out;
  for (int body = 1; body < two.at.nbody; ++body) {
    const Vector3d rate = two.rate(two.at.body_pos, two.moved.body_pos, body);
    if (two.at.body_parentid[body] > 0 && rate.norm() > kStill)
      out.push_back({HandleAnchor::Kind::body, body, two.at.body_parentid[body], rate});
  }
  return out;
}

std::vector<HandleAnchor> moved_parts(const Neighbours& two, HandleAnchor::Kind kind) {
  const bool geoms = kind == HandleAnchor::Kind::geom;
  const int count = static_cast<int>(geoms ? two.at.ngeom : two.at.nsite);
  const int* bodies = geoms ? two.at.geom_bodyid : two.at.site_bodyid;
  std::vector<HandleAnchor> out;
  for (int id = 0; id < count; ++id) {
    const Vector3d rate = geoms ? two.rate(two.at.geom_pos, two.moved.geom_pos, id)
                                : two.rate(two.at.site_pos, two.moved.site_pos, id);
    if (rate.norm() > kStill) out.push_back({kind, id, bodies[id], rate});
  }
  return out;
}

/// Of each body the anchor that moves most: the end of a link, not its middle.
std::vector<HandleAnchor> most_of_each_body(const std::vector<HandleAnchor>& all) {
  std::vector<HandleAnchor> out;
  for (const HandleAnchor& one : all) {
    const auto same = std::find_if(
        out.begin(), out.end(), [&](const HandleAnchor& other) { return other.body == one.body; });
    if (same == out.end())
      out.push_back(one);
    else if (one.direction.norm() > 1.001 * same->direction.norm())
      *same = one;
  }
  return out;
}

/// Whether parts of one body go opposite ways: it is stretched about its middle.
bool is_stretched(const std::vector<HandleAnchor>& all) {
  for (const HandleAnchor& a : all)
    for (const HandleAnchor& b : all)
      if (a.body == b.body && a.direction.dot(b.direction) < 0.0) return true;
  return false;
}

/// The two faces of each body that is stretched, seen along the way in which it is.
std::vector<HandleAnchor> faces(const std::vector<HandleAnchor>& all) {
  std::vector<HandleAnchor> out;
  for (const HandleAnchor& one : most_of_each_body(all))
    for (const double side : {1.0, -1.0})
      out.push_back({HandleAnchor::Kind::face, one.body, one.body, side * one.direction});
  return out;
}

Handle handle_of(const Neighbours& two) {
  if (auto found = turns(two); !found.empty()) return {HandleKind::turn, std::move(found)};
  std::vector<HandleAnchor> moved = moved_bodies(two);
  const std::vector<HandleAnchor> geoms = moved_parts(two, HandleAnchor::Kind::geom);
  std::vector<HandleAnchor> all = moved;
  all.insert(all.end(), geoms.begin(), geoms.end());
  if (is_stretched(moved)) return {HandleKind::scale, faces(moved)};
  // A body's end is where its child is; of the last one where its outermost geom is.
  for (const HandleAnchor& geom : most_of_each_body(geoms)) {
    const bool has_child = std::any_of(moved.begin(), moved.end(), [&](const HandleAnchor& body) {
      return body.body == geom.body;
    });
    const bool rides = std::any_of(moved.begin(), moved.end(),
                                   [&](const HandleAnchor& body) { return body.id == geom.body; });
    if (!has_child && !rides) moved.push_back(geom);
  }
  moved = most_of_each_body(moved);
  if (moved.empty()) moved = moved_parts(two, HandleAnchor::Kind::site);
  if (moved.empty() && is_stretched(all)) return {HandleKind::scale, faces(all)};
  return {HandleKind::move, std::move(moved)};
}

/// The middle of a body's outermost face towards a direction, by the boxes around its geoms.
Vector3d face_of(const mjModel& model, int body, const Vector3d& towards) {
  const Vector3d way = towards.normalized();
  Vector3d low = Vector3d::Constant(1e9), high = -low;
  for (int geom = 0; geom < model.ngeom; ++geom) {
    if (model.geom_bodyid[geom] != body || model.geom_type[geom] == mjGEOM_PLANE) continue;
    const Eigen::Matrix3d turned = rotation_at(model.geom_quat, geom);
    const mjtNum* box = model.geom_aabb + 6L * geom;
    const Vector3d middle =
        vector_at(model.geom_pos, geom) + turned * Vector3d(box[0], box[1], box[2]);
    const Vector3d half = turned.cwiseAbs() * Vector3d(box[3], box[4], box[5]);
    low = low.cwiseMin(middle - half);
    high = high.cwiseMax(middle + half);
  }
  if (high.x() < low.x()) return Vector3d::Zero();  // no geom
  const Vector3d middle = 0.5 * (low + high), half = 0.5 * (high - low);
  return middle + way * half.dot(way.cwiseAbs());
}

Json vector_json(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Json anchor_json(const HandleAnchor& anchor, const mjModel& model) {
  return {{"body", anchor.body},
          {"at", vector_json(place_of(model, anchor))},
          {"direction", vector_json(anchor.direction)}};
}

}  // namespace

std::string_view to_string(HandleKind kind) {
  switch (kind) {
    case HandleKind::move:
      return "move";
    case HandleKind::turn:
      return "turn";
    case HandleKind::scale:
      return "scale";
  }
  return "unknown";
}

Vector3d place_of(const mjModel& model, const HandleAnchor& anchor) {
  switch (anchor.kind) {
    case HandleAnchor::Kind::body:
      return vector_at(model.body_pos, anchor.id);
    case HandleAnchor::Kind::geom:
      return vector_at(model.geom_pos, anchor.id);
    case HandleAnchor::Kind::site:
      return vector_at(model.site_pos, anchor.id);
    case HandleAnchor::Kind::joint:
      return vector_at(model.jnt_pos, anchor.id);
    case HandleAnchor::Kind::face:
      return face_of(model, anchor.id, anchor.direction);
  }
  return Vector3d::Zero();
}

std::vector<Handle> find_handles(const RobotModel& robot, const Eigen::VectorXd& s) {
  const ModelPointer at = drawn_model(robot, s);
  const Eigen::VectorXd lower = robot.space.lower(), upper = robot.space.upper(),
                        scale = robot.space.scale();
  std::vector<Handle> out;
  for (int i = 0; i < robot.space.size(); ++i) {
    const double room = std::max(upper[i] - s[i], s[i] - lower[i]);
    if (!(room > 0.0)) {  // cannot move
      out.emplace_back();
      continue;
    }
    double step = std::min(kStep * scale[i], room);
    if (s[i] + step > upper[i]) step = -step;
    Eigen::VectorXd beside = s;
    beside[i] += step;
    const ModelPointer moved = drawn_model(robot, beside);
    out.push_back(handle_of({*at, *moved, step}));
  }
  return out;
}

Json handle_json(const Handle& handle, const mjModel& model) {
  if (handle.anchors.empty()) return nullptr;
  Json out{{"kind", to_string(handle.kind)}};
  out.update(anchor_json(handle.anchors.front(), model));
  out["also"] = Json::array();
  for (std::size_t k = 1; k < handle.anchors.size(); ++k)
    out["also"].push_back(anchor_json(handle.anchors[k], model));
  return out;
}

Json places_json(const std::vector<Handle>& handles, const mjModel& model) {
  Json out = Json::array();
  for (const Handle& handle : handles) {
    Json places = Json::array();
    for (const HandleAnchor& anchor : handle.anchors)
      places.push_back(vector_json(place_of(model, anchor)));
    out.push_back(std::move(places));
  }
  return out;
}

}  // namespace legwright
