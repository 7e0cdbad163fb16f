// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/tree.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "mjcf/read/feet.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/read/trunk_capsules.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/elements.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/model_arrays.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::size_t kMostCapsulePairs = 20000;  // a robot of many shapes has some thousand

bool belongs_to(const mjModel& model, int body, int trunk) {
  return model.body_rootid[body] == trunk;
}

/// @param link_from_body turns a body's directions into its link's.
std::optional<Sole> sole_of(const FootContact& foot, const Matrix3d& link_from_body) {
  if (!foot.normal) return std::nullopt;
  Eigen::Index across = 0;
  foot.normal->cwiseAbs().minCoeff(&across);
  const Vector3d ahead =
      (Vector3d::Unit(across) - (*foot.normal)[across] * *foot.normal).normalized();
  return Sole{link_from_body * ahead, link_from_body * foot.normal->cross(ahead)};
}

/// Where a body is, as seen from the link it belongs to.
struct Placement {
  int link = 0;
  AffineVector origin;
  Matrix3d rotation = Matrix3d::Identity();
};

class MorphologyBuilder {
 public:
  MorphologyBuilder(const mjModel& model, const Structure& structure, const DesignSpace& space,
                    const std::vector<Binding>& bindings, const MovedParts& moved,
                    std::vector<Connector>& connectors)
      : model_(model),
        structure_(structure),
        trunk_(structure.trunk),
        space_(space),
        bindings_(bindings),
        moved_(moved),
        connectors_(connectors),
        initial_(space.initial()),
        placements_(static_cast<std::size_t>(model.nbody)) {}

  /// @param xml the file that was compiled.
  Morphology build(const XmlFile& xml, const std::vector<TendonSpan>& tendons) {
    Link trunk;
    trunk.name = name_of(model_, mjOBJ_BODY, trunk_);
    out_.links.push_back(std::move(trunk));
    for (int b = trunk_; b < model_.nbody; ++b) {
      if (!belongs_to(model_, b, trunk_)) continue;
      if (b != trunk_) place(b);
      add_masses(b);
    }
    const TreeElements elements = find_elements(xml, model_);
    for (const FootContact& foot : structure_.feet) {
      const int body = foot_body(model_, foot);
      const Placement& at = placements_[static_cast<std::size_t>(body)];
      const AffineVector own = foot_point(xml, elements, model_, foot, stretches_of(body));
      out_.feet.push_back({foot.name, at.link, sum(at.origin, rotated(at.rotation, own)),
                           foot.radius, sole_of(foot, at.rotation)});
    }
    for (const TendonSpan& span : tendons) add_linear_actuator(span);
    if (!out_.feet.empty()) out_.leg_length = stretched_limb(out_, 0, initial_);
    add_capsules(xml, elements);
    return std::move(out_);
  }

 private:
  const std::vector<Stretch>& stretches_of(int body) const {
    static const std::vector<Stretch> none;
    const auto found = moved_.stretches.find(name_of(model_, mjOBJ_BODY, body));
    return found == moved_.stretches.end() ? none : found->second;
  }

  /// A point of a body's frame in the frame of its link.
  AffineVector point(int body, const Vector3d& p) const {
    const Placement& at = placements_[body];
    return sum(at.origin, rotated(at.rotation, stretched_point(p, stretches_of(body))));
  }

  /// Finds the link of a body; each of its hinges starts a new one, whose frame sits at the hinge's
  /// anchor. Joints that are held turn and shift the body within its link.
  void place(int body) {
    const int parent = model_.body_parentid[body];
    const Vector3d carried = carried_point(model_, structure_, body);
    AffineVector origin = point(parent, carried);
    origin.constant += placements_[parent].rotation * (vector_at(model_.body_pos, body) - carried);
    Placement at{placements_[parent].link, std::move(origin),
                 placements_[parent].rotation * rotation_at(model_.body_quat, body)};
    const int first = model_.body_jntadr[body], count = model_.body_jntnum[body];
    const std::vector<int> moving = moving_joints(model_, structure_, body);
    for (int j = first; j < first + count; ++j) {
      const AffineVector anchor = stretched_point(vector_at(model_.jnt_pos, j), stretches_of(body));
      if (!structure_.moves[static_cast<std::size_t>(j)]) {
        hold(held_motion(model_, j), anchor, at);
        continue;
      }
      Link link;
      const std::string name = name_of(model_, mjOBJ_BODY, body);
      link.joint = joint(j);
      link.name = j != moving.back() ? link.joint.name : name.empty() ? link.joint.name : name;
      link.parent = at.link;
      link.origin = sum(at.origin, rotated(at.rotation, anchor));
      // The file draws the body at the angle `ref`; a link's own frame is that of angle zero.
      link.orientation = at.rotation;
      if (const double ref = model_.qpos0[model_.jnt_qposadr[j]]; ref != 0.0)
        link.orientation =
            at.rotation * Eigen::AngleAxisd(-ref, vector_at(model_.jnt_axis, j)).toRotationMatrix();
      out_.links.push_back(std::move(link));
      at = {static_cast<int>(out_.links.size()) - 1, negative(anchor), Matrix3d::Identity()};
    }
    placements_[body] = at;
  }

  static void hold(const Eigen::Isometry3d& moved, const AffineVector& anchor, Placement& at) {
    AffineVector shift = sum(anchor, negative(rotated(moved.linear(), anchor)));
    shift.constant += moved.translation();
    at.origin = sum(at.origin, rotated(at.rotation, shift));
    at.rotation = at.rotation * moved.linear();
  }

  Joint joint(int j) const {
    Joint out;
    out.name = name_of(model_, mjOBJ_JOINT, j);
    out.axis = axis(j, out.name);
    out.nominal = home_qpos(model_)[model_.jnt_qposadr[j]];
    if (model_.jnt_limited[j]) {
      const mjtNum* const range = model_.jnt_range + std::ptrdiff_t{2} * j;
      out.lower = range[0];
      out.upper = range[1];
    }
    const int dof = model_.jnt_dofadr[j];
    out.armature = model_.dof_armature[dof];
    out.damping = model_.dof_damping[dof];
    out.friction_loss = model_.dof_frictionloss[dof];
    out.stiffness = model_.jnt_stiffness[j];
    out.slack_angle = model_.qpos_spring[model_.jnt_qposadr[j]];
    return out;
  }

  /// What turns a joint's axis, in the frame of its body.
  std::vector<JointAxis::Turn> turns_of(const std::string& joint) const {
    std::vector<JointAxis::Turn> out;
    for (int k = 0; k < space_.size(); ++k) {
      if (space_.parameters[k].kind != ParameterKind::axis_angle) continue;
      for (const Binding::Target& target : bindings_[k].targets)
        if (target.name == joint) out.push_back({k, target.direction, target.factor});
    }
    return out;
  }

  JointAxis axis(int j, const std::string& name) const {
    JointAxis out{Vector3d::Zero(), turns_of(name)};
    // The file's axis has the file's turns in it.
    out.reference = turned_back(out.turns, initial_, vector_at(model_.jnt_axis, j)).normalized();
    return out;
  }

  AffineVector attachment(int site) const {
    const int body = model_.site_bodyid[site];
    const auto found = moved_.places.find(name_of(model_, mjOBJ_SITE, site));
    const AffineVector own =
        placed_point(vector_at(model_.site_pos, site), stretches_of(body),
                     found == moved_.places.end() ? std::vector<Place>{} : found->second);
    return sum(placements_[body].origin, rotated(placements_[body].rotation, own));
  }

  void add_linear_actuator(const TendonSpan& span) {
    LinearActuator out;
    out.name = name_of(model_, mjOBJ_TENDON, span.tendon);
    out.joint = placements_[model_.site_bodyid[span.lower_site]].link - 1;
    out.upper = attachment(span.upper_site);
    out.lower = attachment(span.lower_site);
    if (model_.tendon_limited[span.tendon]) {
      const mjtNum* const range = model_.tendon_range + std::ptrdiff_t{2} * span.tendon;
      out.shortest = range[0];
      out.longest = range[1];
    }
    out_.linear_actuators.push_back(std::move(out));
  }

  /// What covers the geoms of trunk and limbs that can collide with each other, and its pairs.
  void add_capsules(const XmlFile& xml, const TreeElements& elements) {
    const TrunkCapsules found = trunk_capsules(
        xml, elements, model_, structure_,
        [&](int body) -> const std::vector<Stretch>& { return stretches_of(body); }, initial_,
        out_.leg_length);
    std::map<int, std::pair<int, int>> of_geom;  // first capsule and the one behind the last
    for (const auto& [geom, capsules] : found.of_geom) {
      const Placement& at = placements_[static_cast<std::size_t>(model_.geom_bodyid[geom])];
      const int first = static_cast<int>(out_.capsules.size());
      for (Capsule capsule : capsules) {
        capsule.link = at.link;
        capsule.part = geom;
        for (AffineVector* end : {&capsule.from, &capsule.to})
          *end = sum(at.origin, rotated(at.rotation, *end));
        out_.capsules.push_back(std::move(capsule));
      }
      of_geom[geom] = {first, static_cast<int>(out_.capsules.size())};
    }
    for (const GeomPair& pair : found.pairs) {
      const auto trunk = of_geom.at(pair.trunk), limb = of_geom.at(pair.limb);
      for (int a = trunk.first; a < trunk.second; ++a)
        for (int b = limb.first; b < limb.second; ++b)
          out_.capsule_pairs.push_back({a, b, pair.hidden});
      if (out_.capsule_pairs.size() > kMostCapsulePairs)
        throw InputError(
            xml.file.string(), 0, "",
            fmt::format("the {} pairs of shapes of the trunk and of legs that can "
                        "touch are covered by more than {} pairs of capsules, the most "
                        "that plans look at; let fewer shapes collide: contype=\"0\" "
                        "conaffinity=\"0\" on the small ones, or <exclude>",
                        found.pairs.size(), kMostCapsulePairs));
    }
  }

  /// A printed body has its own points. Else six equal masses on the principal axes have a body's
  /// mass, centre and inertia.
  void add_masses(int body) {
    const std::string name = name_of(model_, mjOBJ_BODY, body);
    const auto found = moved_.printed.find(name);
    if (found != moved_.printed.end()) {
      const Placement& at = placements_[body];
      tell_connector(name, at);
      for (PointMass point : found->second) {
        point.position = sum(at.origin, rotated(at.rotation, point.position));
        out_.links[at.link].masses.push_back(std::move(point));
      }
      return;
    }
    const double mass = model_.body_mass[body];
    if (!(mass > 0.0)) return;
    const Vector3d inertia = vector_at(model_.body_inertia, body),
                   centre = vector_at(model_.body_ipos, body);
    const Matrix3d axes = rotation_at(model_.body_iquat, body);
    const std::vector<JointAxis::Turn> turns = turns_of_part(body, name);
    for (int k = 0; k < 3; ++k) {
      const double second_moment = std::max(0.0, inertia.sum() / 2 - inertia[k]);
      const Vector3d arm = std::sqrt(3 * second_moment / mass) * axes.col(k);
      for (const double sign : {1.0, -1.0})
        out_.links[placements_[body].link].masses.push_back(
            turns.empty() ? PointMass{mass / 6, point(body, centre + sign * arm)}
                          : turning_mass(mass / 6, body, centre + sign * arm, turns));
    }
  }

  /// What turns a body with a joint's axis, in the frame of its link; nothing for most.
  std::vector<JointAxis::Turn> turns_of_part(int body, const std::string& name) const {
    const TurningPart* const part = find_turning_part(moved_.turning, name);
    if (!part) return {};
    std::vector<JointAxis::Turn> out = turns_of(part->joint);
    const Matrix3d& around = placements_[model_.body_parentid[body]].rotation;
    for (JointAxis::Turn& turn : out) turn.about = around * (part->frame * turn.about);
    return out;
  }

  /// @param at in the body's frame
  PointMass turning_mass(double mass, int body, const Vector3d& at,
                         const std::vector<JointAxis::Turn>& turns) const {
    const Placement& place = placements_[body];
    PointMass out{mass, place.origin};
    out.arm = {turned_back(turns, initial_, place.rotation * at), turns};
    return out;
  }

  /// Of a connector whose masses come next.
  void tell_connector(const std::string& body, const Placement& at) {
    for (Connector& connector : connectors_) {
      if (connector.body != body) continue;
      connector.link = at.link;
      connector.origin = at.origin;
      connector.link_from_body = at.rotation;
      connector.first_mass = static_cast<std::ptrdiff_t>(out_.links[at.link].masses.size());
    }
  }

  const mjModel& model_;
  const Structure& structure_;
  const int trunk_;
  const DesignSpace& space_;
  const std::vector<Binding>& bindings_;
  const MovedParts& moved_;
  std::vector<Connector>& connectors_;
  const Eigen::VectorXd initial_;
  std::vector<Placement> placements_;  // by body id
  Morphology out_;
};

}  // namespace

Eigen::Isometry3d held_motion(const mjModel& model, int j) {
  const mjtNum *q = home_qpos(model) + model.jnt_qposadr[j],
               *q0 = model.qpos0 + model.jnt_qposadr[j];
  const Vector3d axis = vector_at(model.jnt_axis, j);
  Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
  if (model.jnt_type[j] == mjJNT_SLIDE)
    out.translation() = (q[0] - q0[0]) * axis;
  else if (model.jnt_type[j] == mjJNT_BALL)
    out.linear() = rotation_of(q);
  else if (q[0] != q0[0])
    out.linear() = Eigen::AngleAxisd(q[0] - q0[0], axis).toRotationMatrix();
  return out;
}

Eigen::Isometry3d held_displacement(const mjModel& model, int joint) {
  const Vector3d anchor = vector_at(model.jnt_pos, joint);
  const Eigen::Isometry3d moved = held_motion(model, joint);
  Eigen::Isometry3d out = moved;
  out.translation() += anchor - moved.linear() * anchor;
  return out;
}

Morphology build_morphology(const XmlFile& xml, const mjModel& model, const Structure& structure,
                            const DesignSpace& space, const std::vector<Binding>& bindings,
                            const MovedParts& moved, const std::vector<TendonSpan>& tendons,
                            std::vector<Connector>& connectors) {
  Morphology out =
      MorphologyBuilder(model, structure, space, bindings, moved, connectors).build(xml, tendons);
  out.name = std::string(model.names);  // the model's name comes first
  return out;
}

}  // namespace legwright
