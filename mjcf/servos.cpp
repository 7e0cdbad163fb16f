// SPDX-License-Identifier: Apache-2.0
#include "mjcf/servos.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "mjcf/checks.hpp"
#include "mjcf/compile.hpp"

namespace legwright {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFullTorqueError = 0.0375;  // [rad]: angle error at which a servo gives all it has
constexpr double kDampingTime = 0.01;        // [s]: kd over kp of a servo that says nothing of kd

/// The part of a range that serves both directions; infinite if nothing limits.
double symmetric(bool limited, const mjtNum* range) {
  return limited ? std::min(-range[0], range[1]) : kInfinity;
}

/// Element of an actuator: its place in the section counts where it has no name.
const XmlElement& actuator_element(const XmlFile& xml, int actuator) {
  int next = 0;
  for (const XmlElement* section = xml.root().FirstChildElement("actuator"); section;
       section = section->NextSiblingElement("actuator"))
    for (const XmlElement* element = section->FirstChildElement(); element;
         element = element->NextSiblingElement())
      if (next++ == actuator) return *element;
  return xml.root();
}

Servo read_servo(const XmlFile& xml, const mjModel& model, int actuator, const std::string& joint) {
  const XmlElement& element = actuator_element(xml, actuator);
  const mjtNum* gain = model.actuator_gainprm + mjNGAIN * actuator;
  const mjtNum* bias = model.actuator_biasprm + mjNBIAS * actuator;
  const double gear = model.actuator_gear[6 * actuator];
  if (!(std::abs(gear) > 1e-9))
    throw xml.error(element, "attribute gear: is zero, so the actuator drives nothing");
  Servo servo{name_of(model, mjOBJ_ACTUATOR, actuator), joint, 0.0, 0.0, 0.0};
  if (servo.actuator.empty()) servo.actuator = joint;
  servo.torque_limit = std::abs(gear) * symmetric(model.actuator_forcelimited[actuator],
                                                  model.actuator_forcerange + 2 * actuator);
  const int j = model.actuator_trnid[2 * actuator];
  servo.torque_limit = std::min(
      servo.torque_limit, symmetric(model.jnt_actfrclimited[j], model.jnt_actfrcrange + 2 * j));
  const bool is_fixed_gain = model.actuator_gaintype[actuator] == mjGAIN_FIXED;
  const bool is_position = is_fixed_gain && model.actuator_biastype[actuator] == mjBIAS_AFFINE &&
                           gain[0] > 0.0 && std::abs(bias[1] + gain[0]) <= 1e-9 * gain[0];
  if (is_position) {
    servo.kp = gear * gear * gain[0];
    servo.kd = gear * gear * -bias[2];
  } else if (is_fixed_gain && model.actuator_biastype[actuator] == mjBIAS_NONE &&
             model.actuator_ctrllimited[actuator]) {
    servo.torque_limit =
        std::min(servo.torque_limit, std::abs(gear * gain[0]) *
                                         symmetric(true, model.actuator_ctrlrange + 2 * actuator));
  }
  if (!(servo.torque_limit > 0.0))
    throw xml.error(
        element, "its torque limit does not hold zero inside; write forcerange=\"-LIMIT LIMIT\"");
  if (!is_position) {
    if (!std::isfinite(servo.torque_limit))
      throw xml.error(
          element,
          "has no torque limit to take gains from; add forcerange=\"-LIMIT LIMIT\" [N m], or use "
          "<position kp= kv=>");
    servo.kp = servo.torque_limit / kFullTorqueError;
  }
  if (!(servo.kd > 0.0)) servo.kd = kDampingTime * servo.kp;
  return servo;
}

}  // namespace

std::vector<Servo> read_servos(const XmlFile& xml, const mjModel& model,
                               const Morphology& morphology) {
  std::map<std::string, int> actuator_of;
  for (int a = 0; a < model.nactuator; ++a) {
    const XmlElement& element = actuator_element(xml, a);
    const bool on_joint = model.actuator_trntype[a] == mjTRN_JOINT ||
                          model.actuator_trntype[a] == mjTRN_JOINTINPARENT;
    const int joint = on_joint ? model.actuator_trnid[2 * a] : -1;
    if (joint < 0 || model.jnt_type[joint] != mjJNT_HINGE)
      throw xml.error(element,
                      "drives no hinge of a limb; the gait plays on joint servos only, remove it");
    const std::string name = name_of(model, mjOBJ_JOINT, joint);
    if (!actuator_of.emplace(name, a).second)
      throw xml.error(element, fmt::format("is a second actuator of joint '{}'; leave one", name));
  }
  std::vector<Servo> servos;
  for (int a = 0; a < morphology.joint_count(); ++a) {
    const std::string& joint = morphology.links[a + 1].joint.name;
    const auto found = actuator_of.find(joint);
    if (found == actuator_of.end())
      throw error_at(
          xml, model, mjOBJ_JOINT, mj_name2id(&model, mjOBJ_JOINT, joint.c_str()),
          fmt::format("has no actuator; add <position joint=\"{}\" kp= kv= forcerange=/>", joint));
    servos.push_back(read_servo(xml, model, found->second, joint));
  }
  return servos;
}

}  // namespace legwright
