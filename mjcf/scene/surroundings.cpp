// SPDX-License-Identifier: Apache-2.0
#include "mjcf/scene/surroundings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mjcf/scene/scene_parts.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/numbers.hpp"
#include "mjcf/text/unused_name.hpp"
#include "mjcf/text/xml.hpp"
#include "optimizer/design/rotation.hpp"

namespace legwright {
namespace {

using tinyxml2::XMLElement;

constexpr const char* kPayload = "payload";

/// @return the name of its body
std::string add_payload(const XmlFile& xml, XMLElement& trunk, const Payload& payload) {
  std::string own = unused_name(kPayload, [&](const std::string& name) {
    return find_named(xml.root(), "body", name) != nullptr;
  });
  XMLElement& body = add(trunk, "body");
  body.SetAttribute("name", own.c_str());
  body.SetAttribute("pos", format_numbers(payload.position).c_str());
  // Given outright, so that it weighs the same whatever geoms count by the robot's <compiler>.
  const Eigen::Vector3d squares = payload.size.cwiseAbs2();
  XMLElement& weight = add(body, "inertial");
  weight.SetAttribute("pos", "0 0 0");
  weight.SetAttribute("mass", format_number(payload.mass).c_str());
  weight.SetAttribute(
      "diaginertia",
      format_numbers(payload.mass / 12.0 * (Eigen::Vector3d::Constant(squares.sum()) - squares))
          .c_str());
  XMLElement& box = add(body, "geom");
  // All that a default class of the robot may say otherwise.
  for (const auto& [name, value] : {std::pair{"type", "box"},
                                    {"contype", "0"},
                                    {"conaffinity", "0"},
                                    {"group", "0"},
                                    {"pos", "0 0 0"},
                                    {"quat", "1 0 0 0"},
                                    {"rgba", "0.85 0.55 0.25 1"}})
    box.SetAttribute(name, value);
  box.SetAttribute("size", format_numbers(payload.size / 2).c_str());
  box.SetAttribute("mass", format_number(payload.mass).c_str());
  return own;
}

/// What a robot's <compiler> says of all masses holds for the payload too.
void check_payload(const RobotModel& robot, const std::string& text, const Payload& payload,
                   const std::string& name) {
  const ModelPointer model = compile_mjcf(text, robot.file);
  const int body = mj_name2id(model.get(), mjOBJ_BODY, name.c_str());
  if (body < 0 || std::abs(model->body_mass[body] - payload.mass) > 1e-9 * payload.mass)
    throw InputError(robot.file.string(), 0, "compiler",
                     fmt::format("changes what the payload of {} kg weighs; remove settotalmass, "
                                 "boundmass, inertiafromgeom and inertiagrouprange",
                                 payload.mass));
}

}  // namespace

std::string in_surroundings(const RobotModel& robot, const std::string& robot_xml,
                            const Task& task) {
  const bool level = task.up == Eigen::Vector3d::UnitZ();
  if (level && !task.payload) return robot_xml;
  const auto xml = load_xml(robot_xml, robot.file);
  XMLElement& root = *xml->dom.RootElement();
  std::string payload;
  if (task.payload) {
    const XmlElement* trunk = find_named(root, "body", robot.root_body);
    if (!trunk) throw InputError(robot.file.string(), 0, "", "the text is not of this robot");
    payload = add_payload(*xml, const_cast<XMLElement&>(*trunk), *task.payload);
  }
  if (!level)
    add(root, "option").SetAttribute("gravity", format_numbers(-kGravity * task.up).c_str());
  tinyxml2::XMLPrinter printer;
  xml->dom.Print(&printer);
  if (task.payload) check_payload(robot, printer.CStr(), *task.payload, payload);
  return printer.CStr();
}

RobotModel with_task_servos(RobotModel robot, const Task& task) {
  for (Servo& servo : robot.servos) {
    if (!servo.tendon.empty()) continue;
    if (task.torque_limit) servo.torque_limit = std::min(servo.torque_limit, *task.torque_limit);
    if (task.servo_kd) servo.kd = std::max(servo.kd, *task.servo_kd);
    if (!task.servo_kp) continue;
    const double kp = std::min(*task.servo_kp, servo.torque_limit / kFullTorqueError);
    if (servo.kp >= kp) continue;
    servo.kp = kp;
    // A joint that is slow by itself shall not be braked once more: what disturbs it would last.
    servo.kd = std::max(servo.kd, task.servo_kd.value_or(kDampingTime * kp - servo.joint_damping));
  }
  return robot;
}

RobotModel as_played(const RobotModel& robot, const Task& task) {
  RobotModel played = with_task_servos(robot, task);
  played.morphology = as_in_task(robot.morphology, task);
  return played;
}

Eigen::Vector3d up_of(const mjModel& model) {
  const Eigen::Map<const Eigen::Vector3d> gravity(model.opt.gravity);
  const double size = gravity.norm();
  if (size == 0.0 || (gravity.x() == 0.0 && gravity.y() == 0.0)) return Eigen::Vector3d::UnitZ();
  return -gravity / size;
}

Eigen::Matrix3d ground_rotation(const mjModel& model) {
  return smallest_rotation(Eigen::Vector3d::UnitZ(), up_of(model)).toRotationMatrix();
}

}  // namespace legwright
