// SPDX-License-Identifier: Apache-2.0
#include "mjcf/write/rewrite_robot.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include "mjcf/read/bindings.hpp"
#include "mjcf/read/connectors.hpp"
#include "mjcf/read/feet.hpp"
#include "mjcf/read/linear_actuators.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/read/stretch.hpp"
#include "mjcf/shape/growing_axes.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/elements.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/text/numbers.hpp"
#include "mjcf/text/refusals.hpp"
#include "mjcf/text/text_edits.hpp"
#include "mjcf/write/capsule_masses.hpp"
#include "mjcf/write/connector_hulls.hpp"
#include "mjcf/write/keyframes.hpp"
#include "mjcf/write/mesh_scales.hpp"
#include "mjcf/write/skins.hpp"
#include "mjcf/write/turned_bodies.hpp"
#include "mjcf/write/verify.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

using RigidMap = std::map<const XmlElement*, Vector3d>;
using ShiftMap = std::map<const XmlElement*, AffineVector>;
using ArmMap = std::map<const XmlElement*, Vector3d>;

/// One stretched body: how its points move, and how to write that into its elements.
class BodyRewriter {
 public:
  BodyRewriter(const XmlFile& xml, const mjModel& model, const XmlElement& body,
               const std::vector<Stretch>& stretches, const PlaceMap& places, const VectorXd& s,
               const RigidMap& rigid, const ShiftMap& feet, const ArmMap& hinges, TextEdits& edits)
      : xml_(xml),
        model_(model),
        body_(body),
        stretches_(stretches),
        places_(places),
        s_(s),
        rigid_(rigid),
        feet_(feet),
        hinges_(hinges),
        map_(stretch_matrix(stretches, s)),
        shift_(stretch_shift(stretches, s)),
        id_(mj_name2id(&model, mjOBJ_BODY, body.Attribute("name"))),
        edits_(edits) {}

  void run() { parts(body_, Eigen::Isometry3d::Identity()); }

 private:
  /// What stands in the body, or in a frame of it.
  /// @param frame body ← frame: the frame's origin moves with the body, its axes stay.
  void parts(const XmlElement& holder, const Eigen::Isometry3d& frame) {
    const Matrix3d map = frame.linear().transpose() * map_ * frame.linear();
    // What moves the frame moves what stands in it.
    const bool in_frame = &holder != &body_;
    const Vector3d moved_frame =
        in_frame ? Vector3d(map_ * frame.translation() + shift_ - frame.translation())
                 : Vector3d::Zero();
    const Vector3d shift = in_frame ? Vector3d::Zero() : shift_;
    for (const XmlElement* part = holder.FirstChildElement(); part;
         part = part->NextSiblingElement()) {
      if (is_tag(*part, "inertial")) inertial(*part);
      if (is_tag(*part, "frame")) move(*part, "pos", map, shift);
      if (is_tag(*part, "body")) move(*part, "pos", map, shift + hinge_shift(*part, frame, map));
      if (is_tag(*part, "frame")) parts(*part, frame * pose_of(xml_, *part));
      const bool is_geom = is_tag(*part, "geom");
      const bool is_placed = is_tag(*part, "site") && has_attribute(*part, "name") &&
                             places_.count(part->Attribute("name")) > 0;  // write_places
      if (const auto foot = rigid_.find(part); foot != rigid_.end())
        move_by(*part, frame.linear().transpose() * (foot->second - moved_frame));
      else if (is_geom || (is_tag(*part, "site") && !is_placed))
        shape(*part, map, shift, frame.linear());
      const bool is_view = (is_tag(*part, "camera") || is_tag(*part, "light")) && is_fixed(*part);
      if (is_view || is_tag(*part, "joint")) move(*part, "pos", map, shift);
    }
  }

  /// What a body below moves by besides its origin, in the axes of what it stands in: it goes with
  /// its hinge.
  Vector3d hinge_shift(const XmlElement& below, const Eigen::Isometry3d& frame,
                       const Matrix3d& map) const {
    const auto found = hinges_.find(&below);
    if (found == hinges_.end()) return Vector3d::Zero();
    const Vector3d arm = frame.linear().transpose() * found->second;
    return map * arm - arm;
  }

  /// Cameras and lights that follow the robot or turn to it look at it from outside.
  bool is_fixed(const XmlElement& view) const {
    const char* const mode = inherited_attribute(xml_, view, "mode");
    return !mode || mode == std::string_view("fixed");
  }

  /// Writes mapped points; an attribute whose numbers stay is left alone, also where a class holds
  /// it, or where there is none: at the origin.
  void move(const XmlElement& part, const char* name, const Matrix3d& map,
            const Vector3d& farther) {
    const char* const told = inherited_attribute(xml_, part, name);
    const auto numbers = parse_numbers(told ? told : "0 0 0");
    if (!numbers || numbers->size() % 3 != 0) return;
    VectorXd moved = VectorXd::Map(numbers->data(), static_cast<Eigen::Index>(numbers->size()));
    for (Eigen::Index i = 0; i + 2 < moved.size(); i += 3)
      moved.segment<3>(i) = map * moved.segment<3>(i) + farther;
    write(part, name, *numbers, moved);
  }

  /// Moves a part by a distance in the axes of what it stands in.
  void move_by(const XmlElement& part, const Vector3d& distance) {
    const char* const pos = inherited_attribute(xml_, part, "pos");
    const auto numbers = parse_numbers(pos ? pos : "0 0 0");
    if (numbers && numbers->size() == 3)
      write(part, "pos", *numbers, Vector3d::Map(numbers->data()) + distance);
  }

  void write(const XmlElement& part, const char* name, const std::vector<double>& before,
             const VectorXd& after) {
    if (VectorXd::Map(before.data(), after.size()) == after) return;
    edits_.set_numbers(part, name, after);
  }

  /// A geom or site: end points if it has some, else its place, and its size along the axes that
  /// grow with the body. A foot that keeps its thickness moves as its sole does.
  void shape(const XmlElement& part, const Matrix3d& map, const Vector3d& shift,
             const Matrix3d& frame) {
    const auto foot = feet_.find(&part);
    const Vector3d farther =
        foot == feet_.end() ? shift : (shift + frame.transpose() * foot->second.at(s_)).eval();
    if (inherited_attribute(xml_, part, "fromto")) return move(part, "fromto", map, farther);
    move(part, "pos", map, farther);
    const char* type = inherited_attribute(xml_, part, "type");
    const char* size = inherited_attribute(xml_, part, "size");
    const std::string_view name = type ? type : "sphere";
    const bool is_box = name == "box", is_rod = name == "cylinder" || name == "capsule";
    if (!size || (!is_box && !is_rod)) return;
    const auto numbers = parse_numbers(size);
    if (!numbers || numbers->size() < (is_box ? 3u : 2u)) return;
    const auto grows =
        growing_axes(is_box ? mjGEOM_BOX : mjGEOM_CYLINDER,
                     half_sizes(is_box ? mjGEOM_BOX : mjGEOM_CYLINDER, numbers->data()),
                     pose_in_body(xml_, part).linear(), false, stretches_);
    VectorXd grown = VectorXd::Map(numbers->data(), static_cast<Eigen::Index>(numbers->size()));
    for (std::size_t k = 0; k < 3; ++k)
      if (grows[k])
        grown[is_box ? static_cast<Eigen::Index>(k) : 1] *=
            s_[grows[k]->parameter] / grows[k]->initial;
    write(part, "size", *numbers, grown);
  }

  /// MuJoCo refuses a plate whose largest moment is, by rounding, more than the sum of the others.
  static Vector3d of_a_body(const Vector3d& moments) {
    Vector3d out = rounded(moments);
    Eigen::Index most = 0;
    const double largest = out.maxCoeff(&most);
    const double others = out[(most + 1) % 3] + out[(most + 2) % 3];
    if (largest > others && largest - others < 1e-11 * largest) out[most] = (1 - 1e-11) * others;
    return out;
  }

  /// Centre and second moments are mapped like point masses; the mass stays.
  void inertial(const XmlElement& part) {
    if (map_ == Matrix3d::Identity()) return;
    move(part, "pos", map_, shift_);
    const BodyInertia before = inertia_of(part, model_, id_);
    const Matrix3d second = before.inertia.trace() / 2 * Matrix3d::Identity() - before.inertia;
    const Matrix3d moved = map_ * second * map_.transpose();
    // The difference is added, so that what does not change keeps its digits.
    const Matrix3d change = moved - second;
    const Matrix3d added = change.trace() * Matrix3d::Identity() - change;
    if (added.isZero(0.0)) return;  // a point mass has nothing to map
    Matrix3d inertia = before.inertia + added;
    inertia = (0.5 * (inertia + inertia.transpose())).eval();
    const bool diagonal = before.diagonal && std::abs(inertia(0, 1)) + std::abs(inertia(0, 2)) +
                                                     std::abs(inertia(1, 2)) <=
                                                 1e-15 * inertia.trace();
    if (diagonal) {
      edits_.set_numbers(part, "diaginertia", of_a_body(inertia.diagonal()));
      return;
    }
    for (const char* name : {"diaginertia", "quat", "euler", "axisangle", "xyaxes", "zaxis"})
      edits_.remove(part, name);
    VectorXd full(6);
    full << inertia(0, 0), inertia(1, 1), inertia(2, 2), inertia(0, 1), inertia(0, 2),
        inertia(1, 2);
    edits_.set_numbers(part, "fullinertia", full);
  }

  const XmlFile& xml_;
  const mjModel& model_;
  const XmlElement& body_;
  const std::vector<Stretch>& stretches_;
  const PlaceMap& places_;
  const VectorXd& s_;
  const RigidMap& rigid_;
  const ShiftMap& feet_;
  const ArmMap& hinges_;
  const Matrix3d map_;
  const Vector3d shift_;
  const int id_;
  TextEdits& edits_;
};

void check_design(const DesignSpace& space, const VectorXd& s) {
  if (s.size() != space.size())
    throw std::invalid_argument(
        fmt::format("design of {} numbers, the robot has {}", s.size(), space.size()));
  for (int k = 0; k < space.size(); ++k)
    if (!(s[k] >= space.parameters[k].lower && s[k] <= space.parameters[k].upper))
      throw std::invalid_argument(
          fmt::format("{} = {} lies outside of its bounds {} to {}", space.parameters[k].name, s[k],
                      space.parameters[k].lower, space.parameters[k].upper));
}

/// The design that the file will tell: values that differ from the file's are rounded as all other
/// numbers are, so that geometry and declared values agree.
VectorXd written_design(const DesignSpace& space, const VectorXd& s) {
  VectorXd written = space.initial();
  for (int k = 0; k < space.size(); ++k)
    if (const double value = rounded(s[k]); value != rounded(written[k])) written[k] = value;
  return space.clamp(written);
}

ShiftMap shifted_feet(const XmlFile& xml, const mjModel& model, const TreeElements& elements,
                      const Structure& structure, const StretchMap& stretches) {
  ShiftMap out;
  for (const FootContact& foot : structure.feet) {
    const auto own = stretches.find(name_of(model, mjOBJ_BODY, foot_body(model, foot)));
    if (foot.geom < 0 || own == stretches.end()) continue;
    AffineVector shift = foot_shift(xml, elements, model, foot, own->second);
    if (shift.slopes.empty()) continue;
    for (int g = 0; g < model.ngeom; ++g)
      if (is_of_foot(foot, g)) out.emplace(elements.geoms[static_cast<std::size_t>(g)], shift);
  }
  return out;
}

/// From the origin of a body to its hinge where that is elsewhere, in the frame of the body above.
ArmMap arms_to_hinges(const mjModel& model, const TreeElements& elements,
                      const Structure& structure) {
  ArmMap out;
  for (int body = structure.trunk + 1; body < model.nbody; ++body) {
    const Vector3d arm = carried_point(model, structure, body) - vector_at(model.body_pos, body);
    if (!arm.isZero(0.0)) out.emplace(elements.bodies[static_cast<std::size_t>(body)], arm);
  }
  return out;
}

/// The bounds stay those of the file: a task may have narrowed the robot's.
void write_values(const RobotModel& robot, const XmlFile& xml, const VectorXd& s,
                  TextEdits& edits) {
  for (int k = 0; k < robot.space.size(); ++k) {
    const DesignParameter& parameter = robot.space.parameters[k];
    const XmlElement& numeric = *find_declaration(xml, parameter.name).numeric;
    const auto numbers = parse_numbers(attribute(numeric, "data"));
    edits.set_exactly(numeric, "data", Vector3d(s[k], (*numbers)[1], (*numbers)[2]));
  }
}

void write_axes(const RobotModel& robot, const XmlFile& xml, const VectorXd& s, TextEdits& edits) {
  const VectorXd initial = robot.space.initial();
  for (const Link& link : robot.morphology.links) {
    bool changed = false;
    for (const JointAxis::Turn& turn : link.joint.axis.turns)
      changed = changed || s[turn.parameter] != initial[turn.parameter];
    if (!changed) continue;
    Vector3d axis = link.joint.axis.at(s);
    for (double& x : axis)
      if (std::abs(x) < 1e-15) x = 0.0;
    edits.set_numbers(*find_named(xml.root(), "joint", link.joint.name), "axis", axis);
  }
}

/// Attachments: what is placed follows its parameter, the rest of the point the stretch of its
/// body.
void write_places(const RobotModel& robot, const XmlFile& xml, const StretchMap& stretches,
                  const PlaceMap& places, const VectorXd& s, TextEdits& edits) {
  const VectorXd initial = robot.space.initial();
  for (const auto& [site, own] : places) {
    const XmlElement& element = *find_named(xml.root(), "site", site);
    const auto body =
        stretches.find(std::string(attribute(*element.Parent()->ToElement(), "name")));
    const auto numbers = parse_numbers(attribute(element, "pos"));
    const Vector3d before = Vector3d::Map(numbers->data());
    const AffineVector point =
        placed_point(before, body == stretches.end() ? std::vector<Stretch>{} : body->second, own);
    // The difference is added, so that what does not change keeps its digits.
    Vector3d after = before + (point.at(s) - point.at(initial));
    for (const Place& place : own)
      if (s[place.parameter] != initial[place.parameter])
        after[place.axis] = place.factor * s[place.parameter];
    if (before != after) edits.set_numbers(element, "pos", after);
  }
}

/// Compiles the text and compares it with what it shall be; empty where it is that.
std::string difference_from_intent(const RobotModel& robot, const VectorXd& s,
                                   const std::string& text, const std::vector<StandingKey>& keys) {
  try {
    const RobotModel written = parse_robot(text, robot.file, &robot.structure);
    if (written.space.size() != s.size() || written.space.initial() != s) return "declared values";
    std::string difference = find_difference(with_hulls_at(robot, s), s, written.morphology, s);
    if (!difference.empty() || keys.empty()) return difference;
    return find_lifted_foot(written.structure, keys, *load_xml(text, robot.file),
                            *compile_mjcf(text, robot.file));
  } catch (const InputError& error) {
    return std::string("it is refused: ") + error.what();
  }
}

/// All that changes with the body; keyframes stay.
TextEdits edited_body(const RobotModel& robot, const XmlFile& xml, const mjModel& model,
                      const VectorXd& s) {
  TextEdits edits(xml);
  write_values(robot, xml, s, edits);
  write_axes(robot, xml, s, edits);
  Refusals reasons;  // none, of a robot that was read
  const StretchMap all = collect_stretches(robot.space, robot.bindings, robot.file, reasons);
  const PlaceMap places = collect_places(robot.space, robot.bindings, robot.file, reasons);
  reasons.throw_if_any();
  const TreeElements elements = find_elements(xml, model);
  const RigidMap rigid = rigid_feet(xml, model, elements, robot.structure, all, s);
  const ShiftMap feet = shifted_feet(xml, model, elements, robot.structure, all);
  const ArmMap hinges = arms_to_hinges(model, elements, robot.structure);
  for (const auto& [body, stretches] : all)
    BodyRewriter(xml, model, *find_named(xml.root(), "body", body), stretches, places, s, rigid,
                 feet, hinges, edits)
        .run();
  write_places(robot, xml, all, places, s, edits);
  write_mesh_scales(xml, model, elements, all, rigid, s, edits);
  write_capsule_masses(xml, model, elements, all, s, edits);
  write_connectors(robot, xml, model, elements, s, edits);
  write_turned_bodies(robot, model, elements, s, edits);
  hide_skins(xml, model, all, s, edits);
  return edits;
}

}  // namespace

std::string rewrite_body(const RobotModel& robot, const VectorXd& design) {
  check_design(robot.space, design);
  const VectorXd s = written_design(robot.space, design);
  if (s == robot.space.initial()) return robot.xml;
  const auto xml = load_xml(robot.xml, robot.file);
  return edited_body(robot, *xml, *compile_mjcf(robot.xml, robot.file), s).apply();
}

std::string rewrite_robot(const RobotModel& robot, const VectorXd& design) {
  check_design(robot.space, design);
  const VectorXd s = written_design(robot.space, design);
  if (s == robot.space.initial()) return robot.xml;
  const auto xml = load_xml(robot.xml, robot.file);
  const ModelPointer model = compile_mjcf(robot.xml, robot.file);
  const TextEdits edits = edited_body(robot, *xml, *model, s);
  // A pose that the robot's reader would refuse is given up; the design itself never is.
  std::string first;
  for (const KeyframeEffort effort :
       {KeyframeEffort::angles, KeyframeEffort::height, KeyframeEffort::none}) {
    TextEdits with_keys = edits;
    const std::vector<StandingKey> keys = solve_keyframes(robot, *xml, *model, s, effort);
    edit_keyframes(*model, keys, with_keys);
    std::string text = with_keys.apply();
    const std::string difference = difference_from_intent(robot, s, text, keys);
    if (difference.empty()) return text;
    if (first.empty()) first = difference;
  }
  throw std::logic_error("the rewritten robot is not the intended one: " + first);
}

}  // namespace legwright
