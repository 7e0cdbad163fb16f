// SPDX-License-Identifier: Apache-2.0
#include "mjcf/tree.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "mjcf/checks.hpp"
#include "mjcf/compile.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d vector_at(const mjtNum* array, int index) { return Vector3d::Map(array + 3 * index); }

Matrix3d rotation_at(const mjtNum* array, int index) {
  const mjtNum* q = array + 4 * index;
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

/// The body whose hinge moves `body`: itself or the one it is fixed to; the trunk moves itself.
int moving_body(const mjModel& model, int body, int trunk) {
  while (body != trunk && model.body_jntnum[body] == 0) body = model.body_parentid[body];
  return body;
}

bool belongs_to(const mjModel& model, int body, int trunk) {
  return model.body_rootid[body] == trunk;
}

/// Where a body is, as seen from the link it belongs to.
struct Placement {
  int link = 0;
  AffineVector origin;
  Matrix3d rotation = Matrix3d::Identity();
};

class Builder {
 public:
  Builder(const mjModel& model, int trunk, const DesignSpace& space,
          const std::vector<Binding>& bindings, const StretchMap& stretches, const PlaceMap& places,
          const PrintedMap& printed)
      : model_(model),
        trunk_(trunk),
        space_(space),
        bindings_(bindings),
        stretches_(stretches),
        places_(places),
        printed_(printed),
        placements_(model.nbody),
        home_(home_keyframe(model)) {}

  Morphology build(const std::vector<int>& foot_geoms, const std::vector<TendonSpan>& tendons) {
    Link trunk;
    trunk.name = name_of(model_, mjOBJ_BODY, trunk_);
    out_.links.push_back(std::move(trunk));
    for (int b = trunk_; b < model_.nbody; ++b) {
      if (!belongs_to(model_, b, trunk_)) continue;
      if (b != trunk_) place(b);
      add_masses(b);
    }
    for (const int g : foot_geoms) {
      const int body = model_.geom_bodyid[g];
      out_.feet.push_back({name_of(model_, mjOBJ_GEOM, g), placements_[body].link,
                           point(body, vector_at(model_.geom_pos, g)), model_.geom_size[3 * g]});
    }
    for (const TendonSpan& span : tendons) add_linear_actuator(span);
    return std::move(out_);
  }

 private:
  const std::vector<Stretch>& stretches_of(int body) const {
    static const std::vector<Stretch> none;
    const auto found = stretches_.find(name_of(model_, mjOBJ_BODY, body));
    return found == stretches_.end() ? none : found->second;
  }

  /// A point of a body's frame in the frame of its link.
  AffineVector point(int body, const Vector3d& p) const {
    const Placement& at = placements_[body];
    return sum(at.origin, rotated(at.rotation, stretched_point(p, stretches_of(body))));
  }

  /// Finds the link of a body; each of its hinges starts a new one, whose frame sits at the hinge's
  /// anchor.
  void place(int body) {
    const int parent = model_.body_parentid[body];
    Placement at{placements_[parent].link, point(parent, vector_at(model_.body_pos, body)),
                 placements_[parent].rotation * rotation_at(model_.body_quat, body)};
    const int first = model_.body_jntadr[body], count = model_.body_jntnum[body];
    for (int j = first; j < first + count; ++j) {
      const AffineVector anchor = stretched_point(vector_at(model_.jnt_pos, j), stretches_of(body));
      Link link;
      const std::string name = name_of(model_, mjOBJ_BODY, body);
      link.joint = joint(j);
      link.name = j + 1 < first + count ? link.joint.name : name.empty() ? link.joint.name : name;
      link.parent = at.link;
      link.origin = sum(at.origin, rotated(at.rotation, anchor));
      link.orientation = at.rotation;
      out_.links.push_back(std::move(link));
      at = {static_cast<int>(out_.links.size()) - 1, negative(anchor), Matrix3d::Identity()};
    }
    placements_[body] = at;
  }

  Joint joint(int j) const {
    Joint out;
    out.name = name_of(model_, mjOBJ_JOINT, j);
    out.axis = axis(j, out.name);
    if (home_ >= 0) out.nominal = model_.key_qpos[home_ * model_.nq + model_.jnt_qposadr[j]];
    if (model_.jnt_limited[j]) {
      out.lower = model_.jnt_range[2 * j];
      out.upper = model_.jnt_range[2 * j + 1];
    }
    out.armature = model_.dof_armature[model_.jnt_dofadr[j]];
    return out;
  }

  JointAxis axis(int j, const std::string& name) const {
    JointAxis out;
    for (int k = 0; k < space_.size(); ++k) {
      if (space_.parameters[k].kind != ParameterKind::axis_angle) continue;
      for (const Binding::Target& target : bindings_[k].targets)
        if (target.name == name) out.turns.push_back({k, target.direction, target.factor});
    }
    // The file's axis has the file's turns in it, outermost first; take them back in this order.
    out.reference = vector_at(model_.jnt_axis, j);
    for (const JointAxis::Turn& turn : out.turns)
      out.reference =
          Eigen::AngleAxisd(-turn.factor * space_.parameters[turn.parameter].initial, turn.about) *
          out.reference;
    out.reference.normalize();
    return out;
  }

  AffineVector attachment(int site) const {
    const int body = model_.site_bodyid[site];
    const auto found = places_.find(name_of(model_, mjOBJ_SITE, site));
    const AffineVector own =
        placed_point(vector_at(model_.site_pos, site), stretches_of(body),
                     found == places_.end() ? std::vector<Place>{} : found->second);
    return sum(placements_[body].origin, rotated(placements_[body].rotation, own));
  }

  void add_linear_actuator(const TendonSpan& span) {
    LinearActuator out;
    out.name = name_of(model_, mjOBJ_TENDON, span.tendon);
    out.joint = placements_[model_.site_bodyid[span.lower_site]].link - 1;
    out.upper = attachment(span.upper_site);
    out.lower = attachment(span.lower_site);
    if (model_.tendon_limited[span.tendon]) {
      out.shortest = model_.tendon_range[2 * span.tendon];
      out.longest = model_.tendon_range[2 * span.tendon + 1];
    }
    out_.linear_actuators.push_back(std::move(out));
  }

  /// A printed body has its own points. Else six equal masses on the principal axes have a body's mass, centre and
  /// inertia.
  void add_masses(int body) {
    const auto found = printed_.find(name_of(model_, mjOBJ_BODY, body));
    if (found != printed_.end()) {
      const Placement& at = placements_[body];
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
    for (int k = 0; k < 3; ++k) {
      const double second_moment = std::max(0.0, inertia.sum() / 2 - inertia[k]);
      const Vector3d arm = std::sqrt(3 * second_moment / mass) * axes.col(k);
      for (const double sign : {1.0, -1.0})
        out_.links[placements_[body].link].masses.push_back(
            {mass / 6, point(body, centre + sign * arm)});
    }
  }

  const mjModel& model_;
  const int trunk_;
  const DesignSpace& space_;
  const std::vector<Binding>& bindings_;
  const StretchMap& stretches_;
  const PlaceMap& places_;
  const PrintedMap& printed_;
  std::vector<Placement> placements_;  // by body id
  const int home_;
  Morphology out_;
};

/// Bodies that end a limb: no hinge hangs below them.
std::vector<int> limb_ends(const mjModel& model, int trunk) {
  std::vector<bool> carries(model.nbody, false);
  std::vector<int> ends;
  for (int b = model.nbody - 1; b > trunk; --b) {
    if (!belongs_to(model, b, trunk) || model.body_jntnum[b] == 0) continue;
    if (!carries[b]) ends.insert(ends.begin(), b);
    carries[moving_body(model, model.body_parentid[b], trunk)] = true;
  }
  return ends;
}

}  // namespace

int home_keyframe(const mjModel& model) { return mj_name2id(&model, mjOBJ_KEY, "home"); }

std::vector<int> find_feet(const XmlFile& xml, const mjModel& model, int trunk) {
  const int home = home_keyframe(model);
  const DataPointer data =
      kinematics_at(model, home >= 0 ? model.key_qpos + home * model.nq : nullptr, xml.file);
  std::vector<int> feet;
  const std::vector<int> ends = limb_ends(model, trunk);
  if (ends.empty())
    throw error_at(xml, model, mjOBJ_BODY, trunk,
                   "has no limb: no hinge hangs on the trunk; add legs");
  for (const int end : ends) {
    int foot = -1;
    const auto lowest = [&](int g) { return data->geom_xpos[3 * g + 2] - model.geom_size[3 * g]; };
    for (int g = 0; g < model.ngeom; ++g) {
      const int body = model.geom_bodyid[g];
      const bool collides = model.geom_contype[g] || model.geom_conaffinity[g];
      if (model.geom_type[g] != mjGEOM_SPHERE || !collides || !belongs_to(model, body, trunk))
        continue;
      if (moving_body(model, body, trunk) == end && (foot < 0 || lowest(g) < lowest(foot)))
        foot = g;
    }
    if (foot < 0)
      throw error_at(xml, model, mjOBJ_BODY, end,
                     "ends a leg without a foot; add <geom type=\"sphere\"> that collides "
                     "(contype=\"1\") at its end");
    const std::string name = name_of(model, mjOBJ_GEOM, foot);
    if (name.empty())
      throw error_at(xml, model, mjOBJ_GEOM, foot, "the foot has no name; give the ball one");
    if (name.find_first_of(" \t\r\n;,|") != std::string::npos)
      throw error_at(
          xml, model, mjOBJ_GEOM, foot,
          "the name holds a blank or one of ; , |, which trajectories cannot name; rename it");
    feet.push_back(foot);
  }
  return feet;
}

Morphology build_morphology(const mjModel& model, int trunk, const std::vector<int>& foot_geoms,
                            const DesignSpace& space, const std::vector<Binding>& bindings,
                            const StretchMap& stretches, const PlaceMap& places,
                            const PrintedMap& printed, const std::vector<TendonSpan>& tendons) {
  Morphology out =
      Builder(model, trunk, space, bindings, stretches, places, printed).build(foot_geoms, tendons);
  out.name = std::string(model.names);  // the model's name comes first
  out.leg_length = stretched_limb(out, 0, space.initial());
  return out;
}

}  // namespace legwright
