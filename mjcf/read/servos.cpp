// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/servos.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "mjcf/read/checks.hpp"
#include "mjcf/read/couplings.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/elements.hpp"
#include "mjcf/text/listed.hpp"
#include "mjcf/text/refusals.hpp"
#include "optimizer/design/actuator_length.hpp"

namespace legwright {
namespace {

/// The part of a range that serves both directions; infinite if nothing limits.
double symmetric(bool limited, const mjtNum* range) {
  return limited ? std::min(-range[0], range[1]) : std::numeric_limits<double>::infinity();
}

/// Whether what drives is the control behind a filter of first order.
bool lags(const mjModel& model, int actuator) {
  return model.actuator_dyntype[actuator] == mjDYN_FILTER ||
         model.actuator_dyntype[actuator] == mjDYN_FILTEREXACT;
}

/// What the plugin's servo would not do must not get lost in silence.
void refuse_dropped_settings(const XmlFile& xml, const mjModel& model, int actuator,
                             const XmlElement& element) {
  const auto refuse = [&](bool present, const char* what) {
    if (present)
      throw xml.error(element,
                      fmt::format("{}, which the gait's servos do not have; remove it", what));
  };
  const mjtNum* poly = model.actuator_dampingpoly + std::ptrdiff_t{mjNPOLY} * actuator;
  const bool damps = model.actuator_damping[actuator] != 0.0 ||
                     std::any_of(poly, poly + mjNPOLY, [](mjtNum x) { return x != 0.0; });
  if (model.actuator_armature[actuator] != 0.0)
    throw xml.error(element,
                    "attribute armature: the scene brings actuators of its own; write armature "
                    "(times the square of gear) at the joint");
  if (damps)
    throw xml.error(element,
                    "attribute damping: the scene brings actuators of its own; write damping "
                    "(times the square of gear) at the joint");
  refuse(model.actuator_delay[actuator] != 0.0, "attribute delay: delays its control");
  const int dynamics = model.actuator_dyntype[actuator];
  const bool is_known = lags(model, actuator) || dynamics == mjDYN_INTEGRATOR;
  const bool is_plain = dynamics == mjDYN_NONE && model.actuator_actnum[actuator] == 0;
  const bool has_one_state =
      model.actuator_actnum[actuator] == 1 && model.actuator_gaintype[actuator] == mjGAIN_FIXED;
  refuse(!is_plain && !(is_known && has_one_state),
         "has dynamics of its own (dyntype, an integral or a slew limit)");
}

bool is_muscle(const mjModel& model, int actuator) {
  return model.actuator_dyntype[actuator] == mjDYN_MUSCLE ||
         model.actuator_gaintype[actuator] == mjGAIN_MUSCLE;
}

/// Robots of muscles have dozens: one reason for all of them.
void refuse_muscles(const std::vector<int>& muscles, const XmlFile& xml,
                    const SectionElements& elements, Refusals& reasons) {
  if (muscles.empty()) return;
  const std::size_t more = muscles.size() - 1;
  reasons.add(xml.error(
      elements[muscles.front()],
      fmt::format("is a muscle{}: it only pulls, as hard as its length, speed and activation let "
                  "it, and the gait's servos are none of that; drive each hinge by <position> or "
                  "<motor> in the place of muscles",
                  more == 0 ? "" : fmt::format(", and so are {} more", more))));
}

/// The joint that an actuator drives through a fixed tendon over nothing else; −1 for others.
int joint_through_tendon(const mjModel& model, int actuator) {
  return model.actuator_trntype[actuator] == mjTRN_TENDON
             ? lone_joint(model, model.actuator_trnid[std::ptrdiff_t{2} * actuator])
             : -1;
}

/// How far such a tendon moves as its joint turns; one for others.
double tendon_gear(const mjModel& model, int actuator) {
  return joint_through_tendon(model, actuator) < 0
             ? 1.0
             : model.wrap_prm[model.tendon_adr[model.actuator_trnid[std::ptrdiff_t{2} * actuator]]];
}

/// What limits the actuator's force besides its own forcerange, at its joint or tendon.
double outer_limit(const mjModel& model, int actuator) {
  const int t = model.actuator_trnid[std::ptrdiff_t{2} * actuator],
            joint = joint_through_tendon(model, actuator);
  const auto of_joint = [&](int j) {
    return symmetric(model.jnt_actfrclimited[j], model.jnt_actfrcrange + std::ptrdiff_t{2} * j);
  };
  if (model.actuator_trntype[actuator] != mjTRN_TENDON) return of_joint(t);
  const double of_tendon =
      symmetric(model.tendon_actfrclimited[t], model.tendon_actfrcrange + std::ptrdiff_t{2} * t);
  return joint < 0 ? of_tendon
                   : std::min(std::abs(tendon_gear(model, actuator)) * of_tendon, of_joint(joint));
}

/// @param full_force_error error of angle or length at which a servo without gains gives all it
/// has.
Servo read_servo(const XmlFile& xml, const mjModel& model, int actuator, const XmlElement& element,
                 const std::string& joint, double full_force_error) {
  const mjtNum* gain = model.actuator_gainprm + std::ptrdiff_t{mjNGAIN} * actuator;
  const mjtNum* bias = model.actuator_biasprm + std::ptrdiff_t{mjNBIAS} * actuator;
  const double gear = model.actuator_gear[std::ptrdiff_t{6} * model.actuator_outadr[actuator]] *
                      tendon_gear(model, actuator);
  if (!(std::abs(gear) > 1e-9))
    throw xml.error(
        element, "attribute gear (or the tendon's coef): is zero, so the actuator drives nothing");
  refuse_dropped_settings(xml, model, actuator, element);
  Servo servo{name_of(model, mjOBJ_ACTUATOR, actuator), joint, 0.0, 0.0, 0.0, ""};
  if (servo.actuator.empty()) servo.actuator = joint;
  servo.torque_limit =
      std::abs(gear) * symmetric(model.actuator_forcelimited[actuator],
                                 model.actuator_forcerange + std::ptrdiff_t{2} * actuator);
  servo.torque_limit = std::min(servo.torque_limit, outer_limit(model, actuator));
  const bool is_fixed_gain = model.actuator_gaintype[actuator] == mjGAIN_FIXED;
  const bool is_pid = model.actuator_gaintype[actuator] == mjGAIN_PID && bias[1] < 0.0;
  const bool is_position =
      model.actuator_biastype[actuator] == mjBIAS_AFFINE &&
      (is_pid || (is_fixed_gain && gain[0] > 0.0 && std::abs(bias[1] + gain[0]) <= 1e-9 * gain[0]));
  if (lags(model, actuator)) servo.lag = model.actuator_dynprm[std::ptrdiff_t{mjNDYN} * actuator];
  servo.integrates = model.actuator_dyntype[actuator] == mjDYN_INTEGRATOR;
  if (servo.integrates && !is_position)
    throw xml.error(
        element,
        "is told how fast its force shall change, not the force, which the gait's servos "
        "are not; write dyntype=\"none\", or use <position> or <intvelocity>");
  const int control = model.actuator_ctrladr[actuator];
  if (is_fixed_gain && model.actuator_biastype[actuator] == mjBIAS_AFFINE && gain[0] < 0.0)
    throw xml.error(element, fmt::format("has a gain of {}, which drives its joint away from where "
                                         "it shall be; a servo needs a positive kp",
                                         gain[0]));
  if (is_position) {
    servo.kp = gear * gear * -bias[1];
    servo.kd = gear * gear * std::max(0.0, -bias[2]);
  } else if (is_fixed_gain && model.actuator_biastype[actuator] == mjBIAS_NONE &&
             model.actuator_ctrllimited[control]) {
    servo.torque_limit =
        std::min(servo.torque_limit,
                 std::abs(gear * gain[0]) *
                     symmetric(true, model.actuator_ctrlrange + std::ptrdiff_t{2} * control));
  }
  if (!(servo.torque_limit > 0.0))
    throw xml.error(
        element, "its torque limit does not hold zero inside; write forcerange=\"-LIMIT LIMIT\"");
  if (!is_position) {
    if (!std::isfinite(servo.torque_limit))
      throw xml.error(
          element,
          fmt::format(
              "has no torque limit to take gains of joint '{}' from; add forcerange=\"-LIMIT "
              "LIMIT\" (N m, along a tendon N{}), or use <position kp= kv=>",
              joint,
              gear == 1.0 ? ""
                          : fmt::format(", before its gear of {:.4g}: the joint's limit "
                                        "divided by that",
                                        gear)));
    servo.kp = servo.torque_limit / full_force_error;
    servo.kd = kDampingTime * servo.kp;
  }
  return servo;
}

/// Whether an actuator pulls at what the plan holds in its home pose: a joint, or a tendon that is
/// no linear actuator of a leg.
bool drives_held(const mjModel& model, const Structure& structure, int actuator) {
  const auto target = static_cast<std::size_t>(model.actuator_trnid[std::ptrdiff_t{2} * actuator]);
  switch (model.actuator_trntype[actuator]) {
    case mjTRN_JOINT:
    case mjTRN_JOINTINPARENT:
      return !structure.moves[target] && model.jnt_type[target] != mjJNT_FREE;
    case mjTRN_TENDON: {
      const int joint = lone_joint(model, static_cast<int>(target));
      return joint >= 0 ? !structure.moves[static_cast<std::size_t>(joint)]
                        : !structure.reads_tendon[target];
    }
    default:
      return false;
  }
}

const LinearActuator& linear_actuator(const mjModel& model, const Morphology& morphology,
                                      int tendon) {
  const std::string name = name_of(model, mjOBJ_TENDON, tendon);
  return *std::find_if(morphology.linear_actuators.begin(), morphology.linear_actuators.end(),
                       [&](const LinearActuator& actuator) { return actuator.name == name; });
}

/// Name of the hinge that an actuator drives, itself or through its tendon; empty if there is none.
std::string driven_joint(const mjModel& model, const Morphology& morphology, int actuator) {
  const int target = model.actuator_trnid[std::ptrdiff_t{2} * actuator];
  switch (model.actuator_trntype[actuator]) {
    case mjTRN_JOINT:
    case mjTRN_JOINTINPARENT:
      return model.jnt_type[target] == mjJNT_HINGE ? name_of(model, mjOBJ_JOINT, target) : "";
    case mjTRN_TENDON:
      if (const int joint = lone_joint(model, target); joint >= 0)
        return name_of(model, mjOBJ_JOINT, joint);
      return morphology.links[linear_actuator(model, morphology, target).joint + 1].joint.name;
    default:
      return "";
  }
}

/// Moment arm of an actuator in the home pose [m]; one for a servo at its joint [-].
double home_arm(const mjModel& model, const Morphology& morphology, const Eigen::VectorXd& s,
                int actuator) {
  if (model.actuator_trntype[actuator] != mjTRN_TENDON ||
      joint_through_tendon(model, actuator) >= 0)
    return 1.0;
  const LinearActuator& linear =
      linear_actuator(model, morphology, model.actuator_trnid[std::ptrdiff_t{2} * actuator]);
  return morphology.leg_length *
         std::abs(moment_arm(actuator_shape(morphology, linear, s).value,
                             morphology.links[linear.joint + 1].joint.nominal));
}

/// A tendon without actuator would be a cable that the planner does not know.
InputError tendon_without_actuator(const XmlFile& xml, const mjModel& model,
                                   const LinearActuator& actuator) {
  const int tendon = mj_name2id(&model, mjOBJ_TENDON, actuator.name.c_str());
  return xml.error(SectionElements(xml, "tendon")[tendon],
                   fmt::format("has no actuator; add <position tendon=\"{}\" kp= kv= "
                               "forcerange=/>, or remove it",
                               actuator.name));
}

/// Tendons over joints that something else drives.
void check_each_tendon_drives(const XmlFile& xml, const mjModel& model,
                              const Morphology& morphology,
                              const std::map<std::string, int>& actuator_of, Refusals& reasons) {
  for (const LinearActuator& actuator : morphology.linear_actuators) {
    const auto found = actuator_of.find(morphology.links[actuator.joint + 1].joint.name);
    if (found == actuator_of.end() || found->second < 0) continue;
    const int target = model.actuator_trnid[std::ptrdiff_t{2} * found->second];
    const bool drives = model.actuator_trntype[found->second] == mjTRN_TENDON &&
                        name_of(model, mjOBJ_TENDON, target) == actuator.name;
    if (!drives) reasons.add(tendon_without_actuator(xml, model, actuator));
  }
}

/// Of a joint that nothing drives, or of the tendon that should.
InputError without_actuator(const XmlFile& xml, const mjModel& model, const Morphology& morphology,
                            int joint) {
  for (const LinearActuator& actuator : morphology.linear_actuators)
    if (actuator.joint == joint) return tendon_without_actuator(xml, model, actuator);
  const std::string& name = morphology.links[joint + 1].joint.name;
  const int id = mj_name2id(&model, mjOBJ_JOINT, name.c_str());
  const char* const what = model.jnt_stiffness[id] != 0.0 ? "is a spring without" : "has no";
  return error_at(xml, model, mjOBJ_JOINT, id,
                  fmt::format("{} actuator; passive joints in legs are not supported. If a motor "
                              "moves it, add <position joint=\"{}\" kp= kv= forcerange=/>; else "
                              "remove the joint, which fixes its body to the one above",
                              what, name));
}

constexpr int kRefused = -1;  // an actuator of which the reason is told

/// The actuator of each joint by its name, of those that move limbs.
std::map<std::string, int> actuators_of_joints(const XmlFile& xml, const mjModel& model,
                                               const Structure& structure,
                                               const Morphology& morphology,
                                               const SectionElements& elements, Refusals& reasons) {
  std::map<std::string, int> out;
  std::vector<int> muscles;
  const auto take = [&](int actuator) {
    const XmlElement& element = elements[actuator];
    const std::string name = driven_joint(model, morphology, actuator);
    if (name.empty())
      throw xml.error(element,
                      "drives no hinge of a limb; the gait plays on servos at hinges and on "
                      "tendons between two links only, remove it");
    if (!out.emplace(name, actuator).second)
      throw xml.error(element, fmt::format("is a second actuator of joint '{}'; leave one", name));
  };
  for (int a = 0; a < model.nactuator; ++a) {
    if (drives_held(model, structure, a)) continue;
    if (is_muscle(model, a)) {
      muscles.push_back(a);
      out.emplace(driven_joint(model, morphology, a), kRefused);
      continue;
    }
    reasons.collect([&] { take(a); });
  }
  check_each_tendon_drives(xml, model, morphology, out, reasons);
  refuse_muscles(muscles, xml, elements, reasons);
  return out;
}

}  // namespace

std::vector<Servo> read_servos(const XmlFile& xml, const mjModel& model, const Structure& structure,
                               const Morphology& morphology, const Eigen::VectorXd& s,
                               Refusals& reasons) {
  const SectionElements elements(xml, "actuator");
  const std::map<std::string, int> actuator_of =
      actuators_of_joints(xml, model, structure, morphology, elements, reasons);
  std::vector<Servo> servos;
  const auto add = [&](const std::string& joint, int actuator) {
    const double arm = home_arm(model, morphology, s, actuator);
    Servo servo =
        read_servo(xml, model, actuator, elements[actuator], joint, kFullTorqueError * arm);
    if (model.actuator_trntype[actuator] == mjTRN_TENDON &&
        joint_through_tendon(model, actuator) < 0)
      servo.tendon =
          name_of(model, mjOBJ_TENDON, model.actuator_trnid[std::ptrdiff_t{2} * actuator]);
    servo.arm = arm;
    const int id = mj_name2id(&model, mjOBJ_JOINT, joint.c_str());
    servo.joint_damping = model.dof_damping[model.jnt_dofadr[id]];
    servos.push_back(std::move(servo));
  };
  for (int a = 0; a < morphology.joint_count(); ++a) {
    const std::string& joint = morphology.links[a + 1].joint.name;
    const auto found = actuator_of.find(joint);
    if (found == actuator_of.end())
      reasons.add(without_actuator(xml, model, morphology, a));
    else if (found->second != kRefused)
      reasons.collect([&] { add(joint, found->second); });
  }
  return servos;
}

std::string describe_dynamics(const std::vector<Servo>& servos) {
  std::vector<std::string> lagging, integrating;
  for (const Servo& servo : servos) {
    if (servo.lag > 0.0) lagging.push_back(fmt::format("{} ({:.3g} s)", servo.actuator, servo.lag));
    if (servo.integrates) integrating.push_back(servo.actuator);
  }
  constexpr std::size_t kNamed = 6;
  std::string out;
  if (!lagging.empty())
    out = fmt::format("actuators that filter their controls: {}; ", listed(lagging, kNamed));
  if (!integrating.empty())
    out += fmt::format("actuators whose controls are rates: {}; ", listed(integrating, kNamed));
  return out.empty() ? out
                     : out +
                           "gaits are planned and played on servos of the same gains and torque "
                           "limits without that";
}

void set_gains(const std::vector<Servo>& servos, const Eigen::VectorXd& s, Morphology& morphology) {
  for (int a = 0; a < morphology.joint_count(); ++a) {
    Joint& joint = morphology.links[a + 1].joint;
    joint.servo_kp = servos[a].kp;
    joint.servo_kd = servos[a].kd;
  }
  for (const LinearActuator& actuator : morphology.linear_actuators) {
    Joint& joint = morphology.links[actuator.joint + 1].joint;
    const double arm = morphology.leg_length *
                       moment_arm(actuator_shape(morphology, actuator, s).value, joint.nominal);
    joint.servo_kp *= arm * arm;
    joint.servo_kd *= arm * arm;
  }
}

}  // namespace legwright
