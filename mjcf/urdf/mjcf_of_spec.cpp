// SPDX-License-Identifier: Apache-2.0
#include "mjcf/urdf/mjcf_of_spec.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "mjcf/read/motor_lines.hpp"
#include "mjcf/read/robot_model.hpp"
#include "mjcf/text/listed.hpp"
#include "mjcf/text/numbers.hpp"
#include "mjcf/urdf/plain_names.hpp"
#include "mjcf/urdf/print_xml.hpp"
#include "mjcf/urdf/spec_elements.hpp"
#include "mjcf/urdf/speed_limits.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::VectorXd;

constexpr double kNoNumber = 1e-12;  // what is below is a rounding error of an angle
/// Reflected inertia of a servo over its damping gain [s]: 0.0004 kg m² for each N m of its gains,
/// as geared motors of legs have. Without any, a damped servo on a light link is stiffer than a
/// time step.
constexpr double kRotorTime = 1e-3;
constexpr int kCollisionGroup = 3;  // which MuJoCo's viewer does not draw unless it is asked to
constexpr double kBallSquare = 0.4 * 0.05 * 0.05;  // moments of a ball of 5 cm over its mass [m²]

std::string number_list(const double* values, int size) {
  return format_numbers(VectorXd::Map(values, size));
}

/// A turn without the rounding errors of right angles.
std::string quaternion(const double* q) {
  Eigen::Vector4d out = Eigen::Vector4d::Map(q);
  for (double& x : out)
    if (std::abs(x) < kNoNumber) x = 0.0;
  return format_numbers(out);
}

std::vector<std::string> names_of(mjSpec& spec, mjtObj type) {
  std::vector<std::string> out;
  for_each(spec, type, [&](mjsElement* element) { out.push_back(element_name(element)); });
  return out;
}

class MjcfWriter {
 public:
  MjcfWriter(mjSpec& spec, const UrdfMending& mending, const MeshSources& meshes,
             const std::map<std::string, double>& speeds, std::vector<std::string>& notes)
      : spec_(spec), mending_(mending), meshes_(meshes), speeds_(speeds), notes_(notes) {
    for_each(spec_, mjOBJ_EQUALITY, [&](mjsElement* element) {
      coupled_.insert(mjs_getString(mjs_asEquality(element)->name1));
    });
  }

  MjcfOfSpec write(mjsBody& trunk) {
    open_element(out_, "mujoco", {{"model", mjs_getString(spec_.modelname)}});
    out_.PushComment(" Made of a URDF by legwright init. ");  // its name may hold what ends one
    add_element(out_, "compiler", {{"angle", "radian"}});
    add_meshes();
    out_.OpenElement("worldbody");
    add_body(trunk, true);
    out_.CloseElement();
    add_exclusions();
    add_couplings();
    add_servos();
    add_motor_lines();
    out_.CloseElement();
    tell_names();
    tell_moments();
    return {out_.CStr(), std::move(without_moments_)};
  }

 private:
  void add_meshes() {
    if (mjs_firstElement(&spec_, mjOBJ_MESH) == nullptr) return;
    out_.OpenElement("asset");
    for_each(spec_, mjOBJ_MESH, [&](mjsElement* element) {
      const mjsMesh& mesh = *mjs_asMesh(element);
      std::string file = mjs_getString(mesh.file);
      if (const auto real = meshes_.path_of.find(file); real != meshes_.path_of.end())
        file = real->second;
      XmlAttributes own{{"name", element_name(element)}};
      if (const ColladaMesh* const found = meshes_.collada.find(file);
          found != nullptr && found->fault.empty())
        add_drawn(found->mesh, own);
      else
        own.emplace_back("file", file);
      if (differs(mesh.scale, {1, 1, 1})) own.emplace_back("scale", number_list(mesh.scale, 3));
      add_element(out_, "mesh", own);
    });
    out_.CloseElement();
  }

  /// Pictures are open surfaces as a rule, whose inertia is that of a shell.
  static void add_drawn(const DrawnMesh& mesh, XmlAttributes& own) {
    own.emplace_back("inertia", "shell");
    own.emplace_back("vertex", fmt::format("{:.6g}", fmt::join(mesh.vertices, " ")));
    own.emplace_back("face", fmt::format("{}", fmt::join(mesh.faces, " ")));
  }

  void add_body(mjsBody& body, bool is_trunk) {
    XmlAttributes own{{"name", names_of_bodies_(element_name(body.element))}};
    if (!is_trunk && differs(body.pos, {0, 0, 0}))
      own.emplace_back("pos", number_list(body.pos, 3));
    if (!is_trunk && differs(body.quat, {1, 0, 0, 0}))
      own.emplace_back("quat", quaternion(body.quat));
    open_element(out_, "body", own);
    if (is_trunk && count_of(body, mjOBJ_JOINT) == 0) add_element(out_, "freejoint", {});
    for_each(body, mjOBJ_JOINT, [&](mjsElement* joint) { add_joint(joint); });
    if (body.explicitinertial != 0) add_inertial(body);
    bool has_pictures = false;
    for_each(body, mjOBJ_GEOM, [&](mjsElement* geom) {
      has_pictures = has_pictures || is_picture(*mjs_asGeom(geom));
    });
    for_each(body, mjOBJ_GEOM, [&](mjsElement* geom) { add_geom(geom, has_pictures); });
    for_each(body, mjOBJ_BODY, [&](mjsElement* below) { add_body(*mjs_asBody(below), false); });
    out_.CloseElement();
  }

  void add_inertial(const mjsBody& body) {
    XmlAttributes own{{"pos", number_list(body.ipos, 3)}, {"mass", format_number(body.mass)}};
    const Matrix3d inertia = moments_of(body);
    const double least = kNoNumber * inertia.trace();
    const std::array<double, 3> off{inertia(0, 1), inertia(0, 2), inertia(1, 2)};
    if (std::all_of(off.begin(), off.end(), [&](double x) { return std::abs(x) <= least; })) {
      own.emplace_back("diaginertia", format_numbers(inertia.diagonal()));
    } else {
      VectorXd full(6);
      full << inertia.diagonal(), off[0], off[1], off[2];
      own.emplace_back("fullinertia", format_numbers(full));
    }
    add_element(out_, "inertial", own);
  }

  /// Those of the file, where no others are known to be right.
  Matrix3d moments_of(const mjsBody& body) {
    const std::string name = names_of_bodies_(element_name(body.element));
    Matrix3d own = inertia_of_link(body);
    const bool none = own.cwiseAbs().maxCoeff() == 0.0;
    if (const auto given = mending_.moments.find(name); given != mending_.moments.end()) {
      (none ? none_ : wide_).push_back(name);
      return given->second.asDiagonal();
    }
    if (!none) return own;
    without_moments_.push_back(name);
    return body.mass * kBallSquare * Matrix3d::Identity();
  }

  void add_joint(mjsElement* element) {
    const mjsJoint& joint = *mjs_asJoint(element);
    XmlAttributes own{{"name", names_of_joints_(element_name(element))}};
    if (joint.type == mjJNT_FREE) return add_element(out_, "freejoint", own);
    if (joint.type != mjJNT_HINGE)
      own.emplace_back("type", joint.type == mjJNT_SLIDE ? "slide" : "ball");
    own.emplace_back("axis", number_list(joint.axis, 3));
    if (joint.range[0] < joint.range[1]) own.emplace_back("range", number_list(joint.range, 2));
    if (joint.damping[0] != 0.0) own.emplace_back("damping", format_number(joint.damping[0]));
    if (joint.frictionloss != 0.0)
      own.emplace_back("frictionloss", format_number(joint.frictionloss));
    if (has_servo(joint))
      own.emplace_back("armature", format_number(rounded(kRotorTime * damping_of(joint))));
    add_element(out_, "joint", own);
  }

  static bool is_picture(const mjsGeom& geom) { return geom.contype == 0 && geom.conaffinity == 0; }

  /// @param hides where the link has pictures, shapes that collide are in a group that is not drawn
  void add_geom(mjsElement* element, bool hides) {
    static const std::array<const char*, 8> kTypes = {"plane",     "hfield",   "sphere", "capsule",
                                                      "ellipsoid", "cylinder", "box",    "mesh"};
    static const std::array<int, 8> kSizes = {0, 0, 1, 2, 3, 2, 3, 0};
    const mjsGeom& geom = *mjs_asGeom(element);
    const auto type = static_cast<std::size_t>(geom.type);
    if (type >= kTypes.size() || type < mjGEOM_SPHERE) return;
    XmlAttributes own;
    if (const std::string name = element_name(element); !name.empty() && names_.insert(name).second)
      own.emplace_back("name", names_of_geoms_(name));
    own.emplace_back("type", kTypes[type]);
    if (type == mjGEOM_MESH) own.emplace_back("mesh", mjs_getString(geom.meshname));
    if (kSizes[type] > 0) own.emplace_back("size", number_list(geom.size, kSizes[type]));
    if (differs(geom.pos, {0, 0, 0})) own.emplace_back("pos", number_list(geom.pos, 3));
    if (differs(geom.quat, {1, 0, 0, 0})) own.emplace_back("quat", quaternion(geom.quat));
    own.emplace_back("mass", "0");  // a URDF's masses are those of <inertial> alone
    if (is_picture(geom)) {
      own.emplace_back("contype", "0");
      own.emplace_back("conaffinity", "0");
    }
    const int group = hides && !is_picture(geom) ? kCollisionGroup : geom.group;
    if (group != 0) own.emplace_back("group", std::to_string(group));
    if (const Eigen::Vector4f colour = Eigen::Vector4f::Map(geom.rgba);
        colour != Eigen::Vector4f(0.5F, 0.5F, 0.5F, 1.0F))
      own.emplace_back("rgba",
                       fmt::format("{} {} {} {}", colour[0], colour[1], colour[2], colour[3]));
    add_element(out_, "geom", own);
  }

  void add_exclusions() {
    if (mending_.overlapping.empty()) return;
    std::vector<std::string> pairs;
    out_.OpenElement("contact");
    for (const BodyTouch& touch : mending_.overlapping) {
      add_element(out_, "exclude", {{"body1", touch.first}, {"body2", touch.second}});
      pairs.push_back(
          fmt::format("{} and {}, {:.2g} mm deep", touch.first, touch.second, 1e3 * touch.depth));
    }
    out_.CloseElement();
    notes_.push_back(fmt::format(
        "collision shapes that overlap at rest pass through each other, as where <gazebo> has no "
        "selfCollide: {}",
        listed(pairs, 3, "; ")));
  }

  void tell_names() {
    std::vector<std::string> renamed;
    for (const PlainNames* names : {&names_of_bodies_, &names_of_joints_, &names_of_geoms_})
      if (!names->renamed().empty()) renamed.push_back(names->renamed());
    if (!renamed.empty())
      notes_.push_back(
          fmt::format("names with blanks or one of ; , | ~ ^ have _ in their place, like {}: "
                      "trajectories could "
                      "not name them",
                      fmt::join(renamed, ", ")));
  }

  void tell_moments() {
    if (!none_.empty())
      notes_.push_back(
          fmt::format("moments of inertia of {} are 0: they get those of a box around the shape",
                      listed(none_)));
    if (!wide_.empty())
      notes_.push_back(
          fmt::format("moments of inertia of {} are those of a body many times as large as the "
                      "shape (another unit, or a placeholder): they get those of a box around it",
                      listed(wide_)));
    if (!without_moments_.empty())
      notes_.push_back(
          fmt::format("moments of inertia of {} are 0, and no shape tells them: they "
                      "get those of a ball of 5 cm radius",
                      listed(without_moments_)));
  }

  /// <mimic>.
  void add_couplings() {
    if (mjs_firstElement(&spec_, mjOBJ_EQUALITY) == nullptr) return;
    out_.OpenElement("equality");
    for_each(spec_, mjOBJ_EQUALITY, [&](mjsElement* element) {
      const mjsEquality& equality = *mjs_asEquality(element);
      for (const mjString* name : {equality.name1, equality.name2})
        if (mjs_findElement(&spec_, mjOBJ_JOINT, mjs_getString(name)) == nullptr) return;
      add_element(out_, "joint",
                  {{"joint1", names_of_joints_(mjs_getString(equality.name1))},
                   {"joint2", names_of_joints_(mjs_getString(equality.name2))},
                   {"polycoef", number_list(equality.data, 5)}});
    });
    out_.CloseElement();
  }

  bool has_servo(const mjsJoint& joint) const {
    return joint.type == mjJNT_HINGE && coupled_.count(element_name(joint.element)) == 0;
  }

  /// Of a motor without <limit effort>; any before the robot's weight is known [N m].
  double stand_in_torque() const {
    return std::isfinite(mending_.most_torque) ? rounded(mending_.most_torque) : 1.0;
  }

  double torque_of(const mjsJoint& joint) const {
    return joint.actfrcrange[1] > 0.0 ? joint.actfrcrange[1] : stand_in_torque();
  }
  double gain_of(const mjsJoint& joint) const {
    return std::min(torque_of(joint), mending_.most_torque) / kFullTorqueError;
  }
  double damping_of(const mjsJoint& joint) const { return kDampingTime * gain_of(joint); }

  /// A URDF has torques of its motors, or none, but no gains.
  void add_servos() {
    out_.OpenElement("actuator");
    int added = 0, beyond = 0;
    std::vector<std::string> without;
    for_each(spec_, mjOBJ_JOINT, [&](mjsElement* element) {
      const mjsJoint& joint = *mjs_asJoint(element);
      if (!has_servo(joint)) return;
      const std::string name = names_of_joints_(element_name(element));
      const double torque = torque_of(joint);
      if (!(joint.actfrcrange[1] > 0.0))
        without.push_back(name);
      else
        ++added;
      beyond += joint.actfrcrange[1] > mending_.most_torque;
      add_element(out_, "position",
                  {{"name", name},
                   {"joint", name},
                   {"kp", format_number(rounded(gain_of(joint)))},
                   {"kv", format_number(rounded(damping_of(joint)))},
                   {"forcerange", format_number(-torque) + " " + format_number(torque)}});
    });
    out_.CloseElement();
    tell_servos(added, beyond, without);
  }

  void add_motor_lines() {
    std::vector<double> used;
    for_each(spec_, mjOBJ_JOINT, [&](mjsElement* element) {
      const mjsJoint& joint = *mjs_asJoint(element);
      const auto speed = speeds_.find(element_name(element));
      if (!has_servo(joint) || speed == speeds_.end()) return;
      if (used.empty()) out_.OpenElement("custom");
      used.push_back(speed->second);
      add_element(out_, "numeric",
                  {{"name", std::string(kMotorPrefix) + names_of_joints_(element_name(element))},
                   {"data", motor_line_data(torque_of(joint), speed->second)}});
    });
    if (used.empty()) return;
    out_.CloseElement();
    const auto [least, most] = std::minmax_element(used.begin(), used.end());
    notes_.push_back(speed_limits_note(static_cast<int>(used.size()), *least, *most));
  }

  void tell_servos(int added, int beyond, const std::vector<std::string>& without) {
    if (!without.empty())
      notes_.push_back(fmt::format(
          "{} {} no <limit effort> above 0: the motor gets {:.3g} N m, twice what carries the "
          "robot on stretched legs; write what it has there",
          listed(without), without.size() == 1 ? "has" : "have", stand_in_torque()));
    if (added > 0)
      notes_.push_back(
          fmt::format("{} joints get position servos of their <limit effort>, which "
                      "they give at an error of {} rad; a URDF has no gains",
                      added, kFullTorqueError));
    if (added > 0 || !without.empty())
      notes_.push_back(fmt::format(
          "motors get the reflected inertia of geared ones, which a URDF has not: {:.2g} "
          "kg m² for each N m at which their gains saturate",
          kRotorTime * kDampingTime / kFullTorqueError));
    if (beyond > 0)
      notes_.push_back(
          fmt::format("{} of these torques are more than twice what carries the robot "
                      "on stretched legs, {:.3g} N m, and the gains are those of that",
                      beyond, mending_.most_torque));
  }

  mjSpec& spec_;
  const UrdfMending& mending_;
  const MeshSources& meshes_;
  const std::map<std::string, double>& speeds_;
  std::vector<std::string>& notes_;
  tinyxml2::XMLPrinter out_;
  std::set<std::string> names_, coupled_;                   // coupled_: as the spec calls them
  std::vector<std::string> none_, wide_, without_moments_;  // bodies, by their moments of inertia
  PlainNames names_of_bodies_{names_of(spec_, mjOBJ_BODY)},
      names_of_joints_{names_of(spec_, mjOBJ_JOINT)}, names_of_geoms_{names_of(spec_, mjOBJ_GEOM)};
};

}  // namespace

MjcfOfSpec mjcf_of_spec(mjSpec& spec, mjsBody& trunk, const UrdfMending& mending,
                        const MeshSources& meshes, const std::map<std::string, double>& speeds,
                        std::vector<std::string>& notes) {
  return MjcfWriter(spec, mending, meshes, speeds, notes).write(trunk);
}

}  // namespace legwright
