// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/printed.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "mjcf/read/feet.hpp"
#include "mjcf/shape/growing_axes.hpp"
#include "mjcf/text/elements.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/text/numbers.hpp"
#include "mjcf/text/refusals.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kOff = 1e-6;  // [m]; a declared length may be as wrong

/// A geom of a stretched body.
struct Solid {
  const XmlElement* element;
  int type;
  Vector3d size, centre;  // as in mjModel [m]
  Matrix3d axes;          // body ← geom
  bool from_to;
  double density;  // [kg/m³]
  bool mass_given;
  AffineVector shift;  // of a foot, besides that of its centre
};

class Printer {
 public:
  Printer(const XmlFile& xml, const std::vector<Stretch>& stretches)
      : xml_(xml), stretches_(stretches) {}

  void add(const Solid& solid) {
    if (!(solid.density > 0.0)) return;
    switch (solid.type) {
      case mjGEOM_SPHERE:
        return add_part(solid, 4.0 / 3 * std::numbers::pi * std::pow(solid.size[0], 3),
                        solid.centre, Vector3d::Zero(),
                        std::sqrt(0.6) * Vector3d::Constant(solid.size[0]), {false, false, false});
      case mjGEOM_ELLIPSOID:
        refuse_if(solid.from_to, solid, "an ellipsoid placed by fromto; use pos and size");
        return add_part(solid, 4.0 / 3 * std::numbers::pi * solid.size.prod(), solid.centre,
                        Vector3d::Zero(), std::sqrt(0.6) * solid.size, {false, false, false});
      case mjGEOM_BOX:
        return add_box(solid);
      case mjGEOM_CYLINDER:
      case mjGEOM_CAPSULE:
        return add_rod(solid);
      default:
        refuse_if(true, solid, "this type of geom; use boxes, capsules, cylinders and spheres");
    }
  }

  std::vector<PointMass> take() { return std::move(masses_); }

 private:
  void refuse_if(bool fault, const Solid& solid, const std::string& what) const {
    if (fault)
      throw xml_.error(*solid.element,
                       fmt::format("{} {}, as the body has no <inertial>; how that grows "
                                   "with the body is not known of {}; or give the body an "
                                   "<inertial>",
                                   place_of(*solid.element),
                                   solid.mass_given ? "weighs what its mass says"
                                                    : "weighs density times geometry",
                                   what));
  }

  /// "in body 'shank'", or that it has no name.
  static std::string place_of(const XmlElement& geom) {
    const XmlElement* body = geom.Parent()->ToElement();
    while (body != nullptr && !is_tag(*body, "body"))  // a <frame>
      body = body->Parent()->ToElement();
    return body == nullptr || !has_attribute(*body, "name")
               ? "of a body without name"
               : fmt::format("in body '{}'", attribute(*body, "name"));
  }

  /// The stretch along a direction; nullptr if all are across it.
  const Stretch* along(const Solid& solid, const Vector3d& axis, bool must_fit) const {
    const Stretch* found = nullptr;
    for (const Stretch& stretch : stretches_) {
      const double share = std::abs(stretch.direction.dot(axis));
      if (share > 1.0 - 1e-9) found = &stretch;
      refuse_if(must_fit && share > 1e-9 && share < 1.0 - 1e-9, solid,
                "a rod placed by fromto oblique to a stretch; turn it along or across");
    }
    return found;
  }

  void add_box(const Solid& solid) {
    refuse_if(solid.from_to, solid, "a box placed by fromto; use pos and size");
    std::array<bool, 3> grows{};
    for (int k = 0; k < 3; ++k) grows[k] = along(solid, solid.axes.col(k), false) != nullptr;
    add_part(solid, 8.0 * solid.size.prod(), solid.centre, Vector3d::Zero(), solid.size, grows);
  }

  void add_rod(Solid solid) {
    const double r = solid.size[0], h = solid.size[1];
    const Vector3d axis = solid.axes.col(2);
    if (solid.from_to) along(solid, axis, true);  // for its check
    const bool grows =
        growing_axes(solid.type, {r, r, h}, solid.axes, solid.from_to, stretches_)[2] != nullptr;
    if (solid.type == mjGEOM_CAPSULE && grows) solid.mass_given = false;  // its density is kept
    add_part(solid, std::numbers::pi * r * r * 2 * h, solid.centre, Vector3d::Zero(),
             {std::sqrt(0.75) * r, std::sqrt(0.75) * r, h}, {false, false, grows});
    if (solid.type == mjGEOM_CYLINDER) return;
    // The round ends ride on the ends of the rod; a half ball's centre is 3/8 r off its base.
    const double across = std::sqrt(0.6) * r, lengthwise = std::sqrt(3 * (0.2 - 9.0 / 64)) * r;
    for (const double sign : {1.0, -1.0}) {
      const Vector3d end = sign * h * axis;
      const Vector3d base = grows ? (solid.centre + end).eval() : solid.centre;
      add_part(solid, 2.0 / 3 * std::numbers::pi * r * r * r, base,
               sign * 0.375 * r * axis + (grows ? Vector3d::Zero().eval() : end),
               {across, across, lengthwise}, {false, false, false});
    }
  }

  /// Six points that have the mass, centre and second moments of a part: `base` moves with the
  /// stretches, `offset` from it does not; `arms` along the geom's axes, those that `grows` names
  /// with their stretch.
  void add_part(const Solid& solid, double volume, const Vector3d& base, const Vector3d& offset,
                const Vector3d& arms, const std::array<bool, 3>& grows) {
    // A part with a mass of its own keeps it, whatever its size becomes: a servo, bought and not
    // printed.
    std::vector<PointMass::Growth> growth;
    for (int k = 0; k < 3 && !solid.mass_given; ++k) {
      if (!grows[k]) continue;
      const Stretch* stretch = along(solid, solid.axes.col(k), false);
      growth.push_back({stretch->parameter, stretch->initial});
    }
    AffineVector centre = stretched_point(base, stretches_);
    centre.constant += offset;
    if (!solid.shift.slopes.empty()) centre = sum(centre, solid.shift);
    for (int k = 0; k < 3; ++k)
      for (const double sign : {1.0, -1.0}) {
        const Vector3d arm = sign * arms[k] * solid.axes.col(k);
        const AffineVector out = grows[k] ? stretched_arm(arm, stretches_) : AffineVector{arm, {}};
        masses_.push_back({solid.density * volume / 6, sum(centre, out), growth,
                           solid.mass_given ? 0.0 : volume / 6});
      }
  }

  const XmlFile& xml_;
  const std::vector<Stretch>& stretches_;
  std::vector<PointMass> masses_;
};

double volume_of(int type, const Vector3d& size) {
  const double r = size[0], ball = 4.0 / 3 * std::numbers::pi * r * r * r;
  switch (type) {
    case mjGEOM_SPHERE:
      return ball;
    case mjGEOM_ELLIPSOID:
      return 4.0 / 3 * std::numbers::pi * size.prod();
    case mjGEOM_BOX:
      return 8.0 * size.prod();
    case mjGEOM_CAPSULE:
      return 2 * std::numbers::pi * r * r * size[1] + ball;
    default:
      return 2 * std::numbers::pi * r * r * size[1];
  }
}

std::vector<Solid> solids_of(const XmlFile& xml, const mjModel& model, const TreeElements& elements,
                             int id) {
  std::vector<Solid> solids;
  const int first = model.body_geomadr[id];
  for (int geom = first; geom < first + model.body_geomnum[id]; ++geom) {
    const XmlElement* part = elements.geoms[static_cast<std::size_t>(geom)];
    Solid solid{part,
                model.geom_type[geom],
                vector_at(model.geom_size, geom),
                vector_at(model.geom_pos, geom),
                rotation_at(model.geom_quat, geom),
                inherited_attribute(xml, *part, "fromto") != nullptr,
                1000.0,
                false,
                {}};
    if (const char* text = inherited_attribute(xml, *part, "density"))
      solid.density = parse_numbers(text)->front();
    if (const char* text = inherited_attribute(xml, *part, "mass")) {
      solid.mass_given = true;
      solid.density = parse_numbers(text)->front() / volume_of(solid.type, solid.size);
    }
    solids.push_back(solid);
  }
  return solids;
}

/// Σ m p̂ p̂ᵀ of MuJoCo's body in its frame.
Eigen::Matrix4d moments_of(const mjModel& model, int id) {
  const double mass = model.body_mass[id];
  const Vector3d inertia = vector_at(model.body_inertia, id),
                 centre = vector_at(model.body_ipos, id);
  const Matrix3d axes = rotation_at(model.body_iquat, id);
  const Vector3d second = Vector3d::Constant(inertia.sum() / 2) - inertia;
  Eigen::Matrix4d out;
  out.topLeftCorner<3, 3>() =
      axes * second.asDiagonal() * axes.transpose() + mass * centre * centre.transpose();
  out.topRightCorner<3, 1>() = mass * centre;
  out.bottomLeftCorner<1, 3>() = mass * centre.transpose();
  out(3, 3) = mass;
  return out;
}

/// The same of point masses, at the design that the file holds.
Eigen::Matrix4d moments_of(const std::vector<PointMass>& masses,
                           const std::vector<Stretch>& stretches) {
  Eigen::Matrix4d found = Eigen::Matrix4d::Zero();
  for (const PointMass& point : masses) {
    Vector3d p = point.position.constant;
    for (const AffineVector::Slope& slope : point.position.slopes)
      for (const Stretch& stretch : stretches)
        if (stretch.parameter == slope.parameter) {
          p += slope.slope * stretch.initial;
          break;
        }
    found += point.mass * p.homogeneous() * p.homogeneous().transpose();
  }
  return found;
}

/// Meshes with a weight: what MuJoCo weighs besides the other geoms. They keep it, and ride where
/// the file places them; several must ride alike, as their weights are known together only.
void add_meshes(const XmlFile& xml, const XmlElement& body, const std::vector<Solid>& meshes,
                const std::vector<Stretch>& stretches, const Eigen::Matrix4d& rest,
                std::vector<PointMass>& masses) {
  for (const char* setting : {"settotalmass", "boundmass", "boundinertia", "balanceinertia",
                              "inertiagrouprange", "inertiafromgeom"})
    if (!compiler_setting(xml, setting, "").empty())
      throw xml.error(body,
                      fmt::format("is stretched, has no <inertial>, and a mesh with a weight, "
                                  "while <compiler {}> changes weights; give it an <inertial>",
                                  setting));
  const Vector3d place = pose_in_body(xml, *meshes.front().element).translation();
  for (const Solid& mesh : meshes)
    for (const Stretch& stretch : stretches)
      if (std::abs(stretch.direction.dot(pose_in_body(xml, *mesh.element).translation() - place)) >
          1e-9)
        throw xml.error(*mesh.element,
                        "one of several meshes with a weight, which a stretch moves against each "
                        "other; give what is only drawn mass=\"0\", or the body an <inertial>");
  const double mass = rest(3, 3);
  if (!(mass > 0.0)) return;
  const Vector3d centre = rest.topRightCorner<3, 1>() / mass;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> principal(rest.topLeftCorner<3, 3>() -
                                                          mass * centre * centre.transpose());
  const AffineVector origin = stretched_point(place, stretches);
  for (int k = 0; k < 3; ++k)
    for (const double sign : {1.0, -1.0}) {
      const double arm = std::sqrt(3 * std::max(0.0, principal.eigenvalues()[k]) / mass);
      AffineVector point = origin;
      point.constant += centre - place + sign * arm * principal.eigenvectors().col(k);
      masses.push_back({mass / 6, point});
    }
}

/// A foot that is a mesh with a weight keeps its size and moves as its origin does, so its sole
/// only where it should if it is off that across the stretches alone.
void check_mesh_foot(const XmlFile& xml, const mjModel& model, const TreeElements& elements,
                     const FootContact& foot, const std::vector<Stretch>& stretches) {
  const XmlElement& element = *elements.geoms[static_cast<std::size_t>(foot.geom)];
  const Vector3d arm = foot_point(xml, elements, model, foot, {}).constant -
                       pose_in_body(xml, element).translation();
  for (const Stretch& stretch : stretches)
    if (const double off = arm.dot(stretch.direction); std::abs(off) > kOff)
      throw xml.error(
          element, fmt::format("is a foot that gives its body, which has no <inertial>, a weight: "
                               "it keeps its size, and its sole, {:.3g} m along the stretch from "
                               "the mesh's origin, would not go where the stretch takes it; give "
                               "the body an <inertial>, or put a ball as a foot there",
                               off));
}

void check_weight(const XmlFile& xml, const XmlElement& body, const std::vector<PointMass>& masses,
                  const std::vector<Stretch>& stretches, const mjModel& model, int id) {
  const Eigen::Matrix4d wanted = moments_of(model, id), found = moments_of(masses, stretches);
  const double mass = wanted(3, 3), spread = wanted.topLeftCorner<3, 3>().trace();
  const bool same =
      std::abs(found(3, 3) - mass) <= 1e-9 * mass &&
      (found - wanted).topRightCorner<3, 1>().norm() <= 1e-9 * std::sqrt(mass * spread) &&
      (found - wanted).topLeftCorner<3, 3>().norm() <= 1e-9 * spread;
  if (!same)
    throw xml.error(body,
                    "is stretched and has no <inertial>, but MuJoCo does not weigh it as density "
                    "times geometry of its geoms (a shell, inertiagrouprange, settotalmass, "
                    "boundmass, balanceinertia?); remove that setting or give an <inertial>");
}

std::vector<PointMass> masses_of_printed(const XmlFile& xml, const mjModel& model,
                                         const Structure& structure, const TreeElements& elements,
                                         const std::string& name, const std::vector<Stretch>& own) {
  const XmlElement& body = *find_named(xml.root(), "body", name);
  const int id = mj_name2id(&model, mjOBJ_BODY, name.c_str());
  Printer printer(xml, own);
  std::vector<Solid> meshes;
  Refusals reasons;
  const auto add = [&](Solid& solid) {
    for (const FootContact& foot : structure.feet) {
      const auto& geoms = elements.geoms;
      const auto geom = std::find(geoms.begin(), geoms.end(), solid.element) - geoms.begin();
      if (!is_of_foot(foot, static_cast<int>(geom))) continue;
      solid.shift = foot_shift(xml, elements, model, foot, own);
      if (solid.type == mjGEOM_MESH && solid.density > 0.0)
        check_mesh_foot(xml, model, elements, foot, own);
    }
    if (solid.type != mjGEOM_MESH)
      printer.add(solid);
    else if (solid.density > 0.0)
      meshes.push_back(solid);
  };
  for (Solid& solid : solids_of(xml, model, elements, id)) reasons.collect([&] { add(solid); });
  reasons.throw_if_any();
  std::vector<PointMass> masses = printer.take();
  if (!meshes.empty())
    add_meshes(xml, body, meshes, own, moments_of(model, id) - moments_of(masses, own), masses);
  check_weight(xml, body, masses, own, model, id);
  return masses;
}

}  // namespace

PrintedMap read_printed(const XmlFile& xml, const mjModel& model, const Structure& structure,
                        const StretchMap& stretches, Refusals& reasons) {
  PrintedMap printed;
  if (stretches.empty()) return printed;
  const TreeElements elements = find_elements(xml, model);
  for (const auto& [name, own] : stretches)
    if (!find_named(xml.root(), "body", name)->FirstChildElement("inertial"))
      reasons.collect([&, &name = name, &own = own] {
        printed.emplace(name, masses_of_printed(xml, model, structure, elements, name, own));
      });
  return printed;
}

}  // namespace legwright
