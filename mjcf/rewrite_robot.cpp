// SPDX-License-Identifier: Apache-2.0
#include "mjcf/rewrite_robot.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include "mjcf/bindings.hpp"
#include "mjcf/compile.hpp"
#include "mjcf/keyframes.hpp"
#include "mjcf/linear_actuators.hpp"
#include "mjcf/numbers.hpp"
#include "mjcf/stretch.hpp"
#include "mjcf/text_edits.hpp"
#include "mjcf/verify.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// One stretched body: how its points move, and how to write that into its elements.
class BodyRewriter {
 public:
  BodyRewriter(const XmlFile& xml, const mjModel& model, const XmlElement& body,
               const std::vector<Stretch>& stretches, const PlaceMap& places, const VectorXd& s,
               TextEdits& edits)
      : xml_(xml),
        model_(model),
        body_(body),
        stretches_(stretches),
        places_(places),
        s_(s),
        map_(stretch_matrix(stretches, s)),
        id_(mj_name2id(&model, mjOBJ_BODY, body.Attribute("name"))),
        edits_(edits) {}

  void run() {
    int geom = 0;
    for (const XmlElement* g = body_.FirstChildElement("geom"); g;
         g = g->NextSiblingElement("geom"))
      ++geom_count_;
    for (const XmlElement* part = body_.FirstChildElement(); part;
         part = part->NextSiblingElement()) {
      if (is_tag(*part, "inertial")) inertial(*part);
      if (is_tag(*part, "body"))
        if (has_attribute(*part, "pos")) move(*part, "pos");
      const bool is_geom = is_tag(*part, "geom");
      const bool is_placed = is_tag(*part, "site") && has_attribute(*part, "name") &&
                             places_.count(part->Attribute("name")) > 0;  // write_places
      if (is_geom || (is_tag(*part, "site") && !is_placed)) shape(*part, is_geom ? geom++ : -1);
      if (is_tag(*part, "camera") || is_tag(*part, "light") || is_tag(*part, "joint"))
        if (inherited_attribute(xml_, *part, "pos")) move(*part, "pos");
    }
  }

 private:
  /// Writes mapped points; an attribute whose numbers stay is left alone, also where a class holds
  /// it.
  void move(const XmlElement& part, const char* name) {
    const auto numbers = parse_numbers(inherited_attribute(xml_, part, name));
    if (!numbers || numbers->size() % 3 != 0) return;
    VectorXd moved = VectorXd::Map(numbers->data(), static_cast<Eigen::Index>(numbers->size()));
    for (Eigen::Index i = 0; i + 2 < moved.size(); i += 3)
      moved.segment<3>(i) = map_ * moved.segment<3>(i);
    write(part, name, *numbers, moved);
  }

  void write(const XmlElement& part, const char* name, const std::vector<double>& before,
             const VectorXd& after) {
    if (VectorXd::Map(before.data(), after.size()) == after) return;
    edits_.set_numbers(part, name, after);
  }

  /// Orientation of a geom in the body; of a site only where nothing turns it.
  Matrix3d orientation(const XmlElement& part, int geom) const {
    for (const char* name : {"quat", "euler", "axisangle", "xyaxes", "zaxis"}) {
      if (!inherited_attribute(xml_, part, name)) continue;
      if (geom < 0 || geom_count_ != model_.body_geomnum[id_])
        return Matrix3d::Zero();  // unknown: size stays
      const mjtNum* q = model_.geom_quat + 4 * (model_.body_geomadr[id_] + geom);
      return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
    }
    return Matrix3d::Identity();
  }

  /// A geom or site: end points if it has some, else its place; a box also grows along its own
  /// axes.
  void shape(const XmlElement& part, int geom) {
    if (inherited_attribute(xml_, part, "fromto")) return move(part, "fromto");
    if (inherited_attribute(xml_, part, "pos")) move(part, "pos");
    const char* type = inherited_attribute(xml_, part, "type");
    const char* size = inherited_attribute(xml_, part, "size");
    if (!type || std::string_view(type) != "box" || !size) return;
    const auto numbers = parse_numbers(size);
    if (!numbers || numbers->size() != 3) return;
    VectorXd grown = Vector3d::Map(numbers->data());
    const Matrix3d axes = orientation(part, geom);
    for (const Stretch& stretch : stretches_)
      for (int k = 0; k < 3; ++k)
        if (std::abs(axes.col(k).dot(stretch.direction)) > 1.0 - 1e-9)
          grown[k] *= s_[stretch.parameter] / stretch.initial;
    write(part, "size", *numbers, grown);
  }

  /// Centre and second moments are mapped like point masses; the mass stays.
  void inertial(const XmlElement& part) {
    if (map_ == Matrix3d::Identity()) return;
    move(part, "pos");
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
      edits_.set_numbers(part, "diaginertia", inertia.diagonal());
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
  const Matrix3d map_;
  const int id_;
  int geom_count_ = 0;
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

/// The bounds stay those of the file: a task may have narrowed the robot's.
void write_values(const RobotModel& robot, const XmlFile& xml, const VectorXd& s,
                  TextEdits& edits) {
  for (int k = 0; k < robot.space.size(); ++k) {
    const DesignParameter& parameter = robot.space.parameters[k];
    const XmlElement& numeric = *find_declaration(xml, parameter.name).numeric;
    const auto numbers = parse_numbers(attribute(numeric, "data"));
    edits.set_numbers(numeric, "data", Vector3d(s[k], (*numbers)[1], (*numbers)[2]));
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

/// Attachments: what is placed follows its parameter, the rest of the point the stretch of its body.
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
    const RobotModel written = parse_robot(text, robot.file);
    if (written.space.size() != s.size() || written.space.initial() != s) return "declared values";
    const std::string difference = find_difference(robot.morphology, s, written.morphology, s);
    if (!difference.empty() || keys.empty()) return difference;
    return find_lifted_foot(robot.morphology, keys, *compile_mjcf(text, robot.file));
  } catch (const InputError& error) {
    return std::string("it is refused: ") + error.what();
  }
}

}  // namespace

std::string rewrite_robot(const RobotModel& robot, const VectorXd& s) {
  check_design(robot.space, s);
  if (s == robot.space.initial()) return robot.xml;
  const auto xml = load_xml(robot.xml, robot.file);
  const ModelPointer model = compile_mjcf(robot.xml, robot.file);
  TextEdits edits(*xml);
  write_values(robot, *xml, s, edits);
  write_axes(robot, *xml, s, edits);
  const StretchMap all = collect_stretches(robot.space, robot.bindings, robot.file);
  const PlaceMap places = collect_places(robot.space, robot.bindings, robot.file);
  for (const auto& [body, stretches] : all)
    BodyRewriter(*xml, *model, *find_named(xml->root(), "body", body), stretches, places, s, edits)
        .run();
  write_places(robot, *xml, all, places, s, edits);
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
