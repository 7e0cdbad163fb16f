// SPDX-License-Identifier: Apache-2.0
#include "mjcf/urdf/write_urdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>

#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/urdf/speed_limits.hpp"
#include "mjcf/urdf/urdf_shapes.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kNoMass = 1e-12, kNoInertia = 1e-14;  // [kg], [kg m²]; MuJoCo wants 1e-15
constexpr double kNoPlaceLimit = 1000.0;               // of slides [m]
constexpr double kNoEffortLimit = 1e6;                 // [N m], [N]

class UrdfWriter {
 public:
  UrdfWriter(const RobotModel& robot, const mjModel& model, const std::string& mesh_prefix)
      : robot_(robot), model_(model), shapes_(model, mesh_prefix) {
    for (int body = 1; body < model.nbody; ++body) links_.insert(name_of(model, mjOBJ_BODY, body));
  }

  UrdfRobot write() {
    open_element(out_, "robot", {{"name", robot_.morphology.name}});
    // What only MuJoCo reads: without, it would merge links and leave out what does not touch.
    out_.OpenElement("mujoco");
    add_element(out_, "compiler",
                {{"fusestatic", "false"}, {"discardvisual", "false"}, {"strippath", "false"}});
    out_.CloseElement();
    const int trunk = mj_name2id(&model_, mjOBJ_BODY, robot_.root_body.c_str());
    for (int body = trunk; body < model_.nbody; ++body)
      if (model_.body_rootid[body] == trunk) add_body(body, body == trunk);
    add_feet();
    out_.CloseElement();
    UrdfRobot done;
    done.text = "<?xml version=\"1.0\"?>\n";
    done.text += out_.CStr();
    done.meshes = shapes_.meshes();
    done.joints = joints_;
    done.lost = lost(trunk);
    return done;
  }

 private:
  std::string unique_link(std::string name) {
    while (!links_.insert(name).second) name += "_";
    return name;
  }
  std::string body_link(int body) {
    const std::string name = name_of(model_, mjOBJ_BODY, body);
    return name.empty() ? unique_link(fmt::format("body_{}", body)) : name;
  }
  std::string joint_name(int joint) {
    const std::string name = name_of(model_, mjOBJ_JOINT, joint);
    return name.empty() ? fmt::format("joint_{}", joint) : name;
  }

  /// The links of a body, behind the joints that lead to them.
  void add_body(int body, bool trunk) {
    const std::string own = body_link(body);
    std::string parent = trunk ? "" : link_of_body_.at(model_.body_parentid[body]);
    Vector3d origin = Vector3d::Zero();  // of the last link so far, in the frame of the body
    Vector3d place = vector_at(model_.body_pos, body);
    Matrix3d rotation = rotation_at(model_.body_quat, body);
    if (!trunk) place -= origin_of_body_.at(model_.body_parentid[body]);
    const int first = model_.body_jntadr[body], count = trunk ? 0 : model_.body_jntnum[body];
    for (int joint = first; joint < first + count; ++joint) {
      check(joint);
      const Vector3d anchor = vector_at(model_.jnt_pos, joint);
      const bool last = joint + 1 == first + count;
      const std::string link = last ? own : unique_link(own + "__" + joint_name(joint));
      add_joint(joint, parent, link, place + rotation * (anchor - origin), rotation);
      link_of_joint_[joint] = link;
      if (!last) {
        add_empty_link(link);
        parent = link;
        place.setZero();
        rotation.setIdentity();
      }
      origin = anchor;
    }
    if (!trunk && count == 0) add_fixed(parent, own, place, rotation);
    link_of_body_[body] = own;
    origin_of_body_[body] = origin;
    add_link(body, own, origin);
  }

  void check(int joint) const {
    const int type = model_.jnt_type[joint];
    if (type == mjJNT_HINGE || type == mjJNT_SLIDE) return;
    throw InputError(robot_.file.string(), 0,
                     fmt::format("joint '{}'", name_of(model_, mjOBJ_JOINT, joint)),
                     fmt::format("URDF has no {} joint within a robot; give the body hinges in its "
                                 "place, or none",
                                 type == mjJNT_BALL ? "ball" : "free"));
  }

  void add_link(int body, const std::string& name, const Vector3d& origin) {
    open_element(out_, "link", {{"name", name}});
    const Matrix3d axes = rotation_at(model_.body_iquat, body);
    const Matrix3d inertia =
        axes * vector_at(model_.body_inertia, body).asDiagonal() * axes.transpose();
    add_inertial(vector_at(model_.body_ipos, body) - origin, model_.body_mass[body], inertia);
    shapes_.add_geoms(out_, body, origin);
    out_.CloseElement();
  }

  void add_empty_link(const std::string& name) {
    ++empty_links_;
    open_element(out_, "link", {{"name", name}});
    add_inertial(Vector3d::Zero(), kNoMass, kNoInertia * Matrix3d::Identity());
    out_.CloseElement();
  }

  void add_inertial(const Vector3d& centre, double mass, const Matrix3d& inertia) {
    out_.OpenElement("inertial");
    add_origin(out_, centre, Matrix3d::Identity());
    add_element(out_, "mass", {{"value", urdf_number(mass)}});
    add_element(out_, "inertia",
                {{"ixx", urdf_number(inertia(0, 0))},
                 {"iyy", urdf_number(inertia(1, 1))},
                 {"izz", urdf_number(inertia(2, 2))},
                 {"ixy", urdf_number(inertia(0, 1))},
                 {"ixz", urdf_number(inertia(0, 2))},
                 {"iyz", urdf_number(inertia(1, 2))}});
    out_.CloseElement();
  }

  void add_fixed(const std::string& parent, const std::string& link, const Vector3d& place,
                 const Matrix3d& rotation) {
    open_element(out_, "joint", {{"name", link + "_fixed"}, {"type", "fixed"}});
    add_element(out_, "parent", {{"link", parent}});
    add_element(out_, "child", {{"link", link}});
    add_origin(out_, place, rotation);
    out_.CloseElement();
  }

  /// @param place, rotation of the drawn body in the frame of the parent link
  void add_joint(int joint, const std::string& parent, const std::string& link, Vector3d place,
                 const Matrix3d& rotation) {
    const bool slide = model_.jnt_type[joint] == mjJNT_SLIDE;
    const bool limited = model_.jnt_limited[joint] != 0;
    const Vector3d axis = vector_at(model_.jnt_axis, joint);
    const double drawn = model_.qpos0[model_.jnt_qposadr[joint]];  // ref: the joint is there
    Matrix3d zero = rotation;
    if (slide) place -= drawn * (rotation * axis);
    if (!slide) zero = rotation * Eigen::AngleAxisd(-drawn, axis);
    const char* const type = slide ? "prismatic" : limited ? "revolute" : "continuous";
    joints_.push_back(joint_name(joint));
    open_element(out_, "joint", {{"name", joints_.back()}, {"type", type}});
    add_element(out_, "parent", {{"link", parent}});
    add_element(out_, "child", {{"link", link}});
    add_origin(out_, place, zero);
    add_element(out_, "axis", {{"xyz", urdf_numbers(axis)}});
    XmlAttributes limit;
    const mjtNum* const range = model_.jnt_range + std::ptrdiff_t{2} * joint;
    if (limited || slide) {
      limit.emplace_back("lower", urdf_number(limited ? range[0] : -kNoPlaceLimit));
      limit.emplace_back("upper", urdf_number(limited ? range[1] : kNoPlaceLimit));
      unlimited_slides_ += limited ? 0 : 1;
    }
    limit.emplace_back("effort", urdf_number(effort_of(joint)));
    limit.emplace_back("velocity", urdf_number(speed_of(joint)));
    add_element(out_, "limit", limit);
    const int dof = model_.jnt_dofadr[joint];
    add_element(out_, "dynamics",
                {{"damping", urdf_number(model_.dof_damping[dof])},
                 {"friction", urdf_number(model_.dof_frictionloss[dof])}});
    out_.CloseElement();
    armatures_ += model_.dof_armature[dof] > 0.0 ? 1 : 0;
    springs_ += model_.jnt_stiffness[joint] != 0.0 ? 1 : 0;
  }

  /// Without load, of motors at the joint whose torque falls with speed [rad/s].
  double speed_of(int joint) {
    const std::string name = name_of(model_, mjOBJ_JOINT, joint);
    for (const Servo& servo : robot_.servos)
      if (servo.joint == name && servo.line && servo.tendon.empty())
        return servo.line->no_load_speed;
    ++unlimited_speeds_;
    return kNoSpeedLimit;
  }

  /// That of the plan's motors; of what rides along, of the file. 0: nothing moves it.
  double effort_of(int joint) {
    const std::string name = name_of(model_, mjOBJ_JOINT, joint);
    for (std::size_t i = 1; i < robot_.morphology.links.size(); ++i) {
      const Joint& planned = robot_.morphology.links[i].joint;
      if (planned.name == name && std::isfinite(planned.torque_limit)) return planned.torque_limit;
    }
    const std::ptrdiff_t two = 2;
    if (model_.jnt_actfrclimited[joint] != 0) return model_.jnt_actfrcrange[two * joint + 1];
    for (int a = 0; a < model_.nu; ++a) {
      if (model_.actuator_trntype[a] != mjTRN_JOINT || model_.actuator_trnid[two * a] != joint)
        continue;
      const double gear = std::abs(model_.actuator_gear[std::ptrdiff_t{6} * a]);
      if (model_.actuator_forcelimited[a] != 0)
        return gear * model_.actuator_forcerange[two * a + 1];
      ++unlimited_motors_;
      return kNoEffortLimit;
    }
    return 0.0;
  }

  void add_feet() {
    const Eigen::VectorXd s = robot_.space.initial();
    for (const Foot& foot : robot_.morphology.feet) {
      std::string parent =
          link_of_body_.at(mj_name2id(&model_, mjOBJ_BODY, robot_.root_body.c_str()));
      if (foot.link > 0) {
        const std::string& joint =
            robot_.morphology.links[static_cast<std::size_t>(foot.link)].joint.name;
        parent = link_of_joint_.at(mj_name2id(&model_, mjOBJ_JOINT, joint.c_str()));
      }
      const std::string link = unique_link(foot.name + "_foot_centre");
      add_element(out_, "link", {{"name", link}});
      add_fixed(parent, link, foot.position.at(s), Matrix3d::Identity());
    }
  }

  std::vector<std::string> lost(int trunk) const {
    std::vector<std::string> out;
    const auto say = [&](long long count, const char* sentence) {
      if (count > 0) out.push_back(fmt::format(fmt::runtime(sentence), count));
    };
    say(shapes_.capsules(), "capsules ({}): each is a cylinder and two spheres");
    say(shapes_.ellipsoids(), "ellipsoids ({}): each is a mesh of 720 triangles");
    say(shapes_.left_out(), "geoms that are planes or height fields, or not drawn nor touch ({})");
    say(empty_links_, "links of 1e-12 kg between the joints of one body ({})");
    say(armatures_, "armature, the reflected inertia of rotors (joints: {})");
    say(springs_, "springs (joints: {})");
    say(unlimited_motors_, "motors without a limit ({}): their effort of 1e6 stands for none");
    say(unlimited_slides_, "slides without a range ({}): theirs is from -1000 to 1000 m");
    say(unlimited_speeds_,
        "speeds of motors that the file does not tell (joints: {}): the velocity of 1000 stands "
        "for none");
    say(static_cast<long long>(joints_.size()) - unlimited_speeds_,
        "torques of motors between rest and their speed without load (joints: {})");
    say(model_.nu, "gains of actuators ({})");
    say(model_.neq, "equality constraints ({})");
    say(model_.ntendon, "tendons, linear actuators among them ({})");
    say(model_.nsensor, "sensors ({})");
    say(model_.nkey, "keyframes, the home pose among them ({})");
    say(model_.nexclude + model_.npair, "rules on which bodies touch ({})");
    say(model_.ntex, "textures ({})");
    long long others = model_.body_geomnum[0];
    for (int body = 1; body < model_.nbody; ++body)
      others += model_.body_rootid[body] == trunk ? 0 : 1;
    say(others, "bodies and geoms of the world ({})");
    out.emplace_back(
        "friction and softness of contacts, which geoms may touch, and solver options");
    return out;
  }

  const RobotModel& robot_;
  const mjModel& model_;
  UrdfShapes shapes_;
  tinyxml2::XMLPrinter out_;
  std::set<std::string> links_;
  std::map<int, std::string> link_of_body_, link_of_joint_;
  std::map<int, Vector3d> origin_of_body_;
  std::vector<std::string> joints_;
  int empty_links_ = 0, armatures_ = 0, springs_ = 0, unlimited_motors_ = 0, unlimited_slides_ = 0;
  int unlimited_speeds_ = 0;
};

}  // namespace

UrdfRobot urdf_of(const RobotModel& robot, const mjModel& model, const std::string& mesh_prefix) {
  return UrdfWriter(robot, model, mesh_prefix).write();
}

}  // namespace legwright
