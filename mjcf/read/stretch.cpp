// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/stretch.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "mjcf/read/feet.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/elements.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/text/numbers.hpp"
#include "mjcf/text/refusals.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kSamePlace = 1e-6;  // [m]: files have six digits
constexpr double kOblique = 1e-3;    // cosine: what is nearer to right angles is drawn so

/// Direct child bodies that carry a moving joint somewhere: for a trunk the roots of its limbs.
std::vector<int> limb_children(const mjModel& model, const Structure& structure, int body) {
  std::vector<int> children;
  for (int b = body + 1; b < model.nbody; ++b) {
    if (moving_joints(model, structure, b).empty()) continue;
    for (int up = b; up > body; up = model.body_parentid[up])
      if (model.body_parentid[up] == body &&
          std::find(children.begin(), children.end(), up) == children.end())
        children.push_back(up);
  }
  return children;
}

bool joints_at_origin(const mjModel& model, int body) {
  for (int j = model.body_jntadr[body]; j < model.body_jntadr[body] + model.body_jntnum[body]; ++j)
    if (!vector_at(model.jnt_pos, j).isZero(1e-12)) return false;
  return true;
}

/// The point a link's length reaches to, in the body's frame.
Vector3d distal_point(const XmlFile& xml, const mjModel& model, const XmlElement& place, int body,
                      const Structure& structure) {
  const std::string name = name_of(model, mjOBJ_BODY, body);
  const std::vector<int> children = limb_children(model, structure, body);
  if (children.size() > 1)
    throw xml.error(
        place,
        fmt::format("body '{}' branches, so its length is not clear; stretch the bodies below it",
                    name));
  if (children.size() == 1) {
    const int child = children.front();
    if (moving_joints(model, structure, end_of_fixed(model, structure, child)).empty())
      throw xml.error(
          place,
          fmt::format("between body '{}' and the joint below it is the body '{}', whose joint is "
                      "held or which branches; put that joint's body directly into '{}'",
                      name, name_of(model, mjOBJ_BODY, child), name));
    return carried_point(model, structure, child);
  }
  const TreeElements elements = find_elements(xml, model);
  for (const FootContact& foot : structure.feet) {
    int holder = foot_body(model, foot);
    if (holder == body) return foot_point(xml, elements, model, foot, {}).constant;
    // A foot on a fixed body, or on one fixed to that: its body's origin is the end of the link.
    while (holder > body && model.body_parentid[holder] != body)
      holder = model.body_parentid[holder];
    if (holder > body &&
        moving_body(model, structure, holder) == moving_body(model, structure, body) &&
        joints_at_origin(model, holder))
      return carried_point(model, structure, holder);
  }
  throw xml.error(
      place,
      fmt::format("body '{}' has neither a joint below it nor a foot, so its length is not clear; "
                  "name the body that has",
                  name));
}

/// What is stretched obliquely tilts the plane in which it stands.
void check_sole_tilt(const XmlFile& xml, const mjModel& model, const XmlElement& place, int body,
                     const Vector3d& direction, const Structure& structure) {
  for (const FootContact& foot : structure.feet) {
    if (!foot.normal || foot_body(model, foot) != body) continue;
    const double along = std::abs(direction.dot(*foot.normal));
    // Parts of a sole keep their thickness, each its own.
    if (along > kOblique && (foot.middle || along < 1.0 - kOblique))
      throw xml.error(
          place, fmt::format("body '{}' is a flat foot, whose sole this stretch would tilt; leave "
                             "it out, or stretch along x, y or z, whichever lie in the sole{}",
                             name_of(model, mjOBJ_BODY, body), foot.middle ? "" : " or across it"));
  }
}

}  // namespace

StretchMeasure measure_stretch(const XmlFile& xml, const mjModel& model, const XmlElement& place,
                               int body, const std::string& word, const Structure& structure) {
  const Vector3d axis = word == "x"   ? Vector3d::UnitX()
                        : word == "y" ? Vector3d::UnitY()
                        : word == "z" ? Vector3d::UnitZ()
                                      : Vector3d::Zero().eval();
  const std::vector<int> hinges = moving_joints(model, structure, body);
  if (word != "link" && hinges.empty()) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const int child : limb_children(model, structure, body)) {
      const double at = axis.dot(carried_point(model, structure, child));
      low = std::min(low, at);
      high = std::max(high, at);
    }
    if (!(high - low > 1e-9))
      throw xml.error(
          place,
          fmt::format("the limbs of body '{}' are not spread along {}, so it has no length there",
                      name_of(model, mjOBJ_BODY, body), word));
    return {axis, high - low, 0.0};
  }
  if (hinges.empty())
    throw xml.error(place,
                    fmt::format("body '{}' has no hinge of its own; stretch it along x, y or z",
                                name_of(model, mjOBJ_BODY, body)));
  const Vector3d hinge = vector_at(model.jnt_pos, hinges.back());
  const Vector3d reach = distal_point(xml, model, place, body, structure) - hinge;
  const double length = word == "link" ? reach.norm() : std::abs(axis.dot(reach));
  if (!(length > 1e-9))
    throw xml.error(place, fmt::format("body '{}' has no length along {}",
                                       name_of(model, mjOBJ_BODY, body), word));
  const Vector3d direction = word == "link" ? (reach / length).eval() : axis;
  for (int j = model.body_jntadr[body]; j < model.body_jntadr[body] + model.body_jntnum[body]; ++j)
    if (std::abs(direction.dot(vector_at(model.jnt_pos, j) - hinge)) > kSamePlace)
      throw xml.error(
          place, fmt::format(
                     "stretching body '{}' from its hinge '{}' on would move its hinge '{}' in the "
                     "body above, as their pos differ along the stretch; give each hinge a body "
                     "of its own",
                     name_of(model, mjOBJ_BODY, body), name_of(model, mjOBJ_JOINT, hinges.back()),
                     name_of(model, mjOBJ_JOINT, j)));
  check_sole_tilt(xml, model, place, body, direction, structure);
  return {direction, length, direction.dot(hinge)};
}

BodyInertia inertia_of(const XmlElement& inertial, const mjModel& model, int body) {
  BodyInertia out{vector_at(model.body_ipos, body), Matrix3d::Zero(), false};
  const auto diagonal = parse_numbers(attribute(inertial, "diaginertia"));
  const auto full = parse_numbers(attribute(inertial, "fullinertia"));
  bool has_orientation = false;
  for (const char* name : {"quat", "euler", "axisangle", "xyaxes", "zaxis"})
    has_orientation = has_orientation || has_attribute(inertial, name);
  if (diagonal && diagonal->size() == 3 && !has_orientation) {
    out.inertia.diagonal() = Vector3d::Map(diagonal->data());
    out.diagonal = true;
  } else if (full && full->size() == 6) {
    const std::vector<double>& f = *full;
    out.inertia << f[0], f[3], f[4], f[3], f[1], f[5], f[4], f[5], f[2];
  } else {
    const Matrix3d axes = rotation_at(model.body_iquat, body);
    out.inertia = axes * vector_at(model.body_inertia, body).asDiagonal() * axes.transpose();
  }
  return out;
}

namespace {

/// A mesh moves with its body; what MuJoCo computes from one would not.
void check_parts(const XmlFile& xml, const XmlElement& holder) {
  for (const XmlElement* part = holder.FirstChildElement(); part;
       part = part->NextSiblingElement()) {
    if (is_tag(*part, "frame")) check_parts(xml, *part);
    if (!is_tag(*part, "geom")) continue;
    const char* const type = inherited_attribute(xml, *part, "type");
    const std::string_view shape = type ? type : "sphere";
    const bool fitted = shape != "mesh" && inherited_attribute(xml, *part, "mesh");
    if (fitted || shape == "sdf" || shape == "hfield")
      throw xml.error(*part, fmt::format("{} in a stretched body is not supported; use a mesh or "
                                         "plain geoms",
                                         fitted ? "a geom fitted to a mesh" : "this type of geom"));
  }
}

}  // namespace

void check_stretchable(const XmlFile& xml, const mjModel& model, const XmlElement& body) {
  const int id = mj_name2id(&model, mjOBJ_BODY, body.Attribute("name"));
  check_parts(xml, body);
  const XmlElement* inertial = body.FirstChildElement("inertial");
  if (!inertial) return;  // printed: read_printed checks its geoms
  const auto mass = parse_numbers(attribute(*inertial, "mass"));
  const BodyInertia written = inertia_of(*inertial, model, id);
  const Matrix3d axes = rotation_at(model.body_iquat, id);
  const Matrix3d used = axes * vector_at(model.body_inertia, id).asDiagonal() * axes.transpose();
  const auto pos = parse_numbers(attribute(*inertial, "pos"));
  const bool same = mass && mass->size() == 1 &&
                    std::abs(mass->front() - model.body_mass[id]) <= 1e-9 * model.body_mass[id] &&
                    (used - written.inertia).norm() <= 1e-9 * (1e-6 + used.norm()) && pos &&
                    pos->size() == 3 &&
                    (Vector3d::Map(pos->data()) - vector_at(model.body_ipos, id)).norm() <= 1e-9;
  if (!same)
    throw xml.error(*inertial,
                    "MuJoCo does not use these numbers as written (inertiafromgeom, settotalmass, "
                    "boundmass or balanceinertia of <compiler> changes them); remove that setting");
}

StretchMap collect_stretches(const DesignSpace& space, const std::vector<Binding>& bindings,
                             const std::filesystem::path& file, Refusals& reasons) {
  StretchMap stretches;
  const auto add = [&](int k, const Binding::Target& target) {
    std::vector<Stretch>& own = stretches[target.name];
    for (const Stretch& other : own)
      if (std::abs(other.direction.dot(target.direction)) > 1e-9)
        throw InputError(
            file.string(), target.line,
            fmt::format("text 'legwright/{}'", space.parameters[k].name),
            fmt::format(
                "body '{}' is already stretched along nearly this direction by 'legwright/{}'; "
                "use perpendicular directions",
                target.name, space.parameters[other.parameter].name));
    own.push_back({k, target.direction, space.parameters[k].initial, target.still});
  };
  for (int k = 0; k < space.size(); ++k)
    if (space.parameters[k].kind == ParameterKind::length)
      for (const Binding::Target& target : bindings[k].targets)
        reasons.collect([&] { add(k, target); });
  return stretches;
}

}  // namespace legwright
