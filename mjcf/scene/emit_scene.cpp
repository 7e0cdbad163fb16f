// SPDX-License-Identifier: Apache-2.0
#include "mjcf/scene/emit_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <vector>

#include "mjcf/read/moving_parts.hpp"
#include "mjcf/read/time_step.hpp"
#include "mjcf/scene/gait_plugin.hpp"
#include "mjcf/scene/played_robot.hpp"
#include "mjcf/scene/scene_parts.hpp"
#include "mjcf/scene/surroundings.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/text/numbers.hpp"
#include "mjcf/text/unused_name.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {
namespace {

using tinyxml2::XMLElement;

constexpr const char* kSensorPlugin = "legwright.sensor";
constexpr const char* kInstance = "gait";
constexpr const char* kHowToLoad =
    " An engine plugin plays the gait; MuJoCo must know it before it reads this file. In Python: "
    "import legwright. For simulate and other programs: liblegwright.so, built for the same "
    "MuJoCo, "
    "in the folder mujoco_plugin beside the program. `legwright play RUN` sees to that. Without "
    "it: "
    "`legwright export RUN` writes walk.xml with play.py for stock MuJoCo. ";
// What the plugin measures of the gait, as sensors "gait:KIND" (plugin/README.md).
constexpr const char* kSensorKinds[] = {"phase", "planned_contact", "measured_contact",
                                        "base_error", "torque_share"};

/// Gains as they are written; the class and the plugin must hold the very same text.
struct Gains {
  std::string kp, kd;
};

Gains scaled_gains(const Servo& servo, double scale) {
  return {format_number(servo.kp * scale), format_number(servo.kd * std::sqrt(scale))};
}

void check_settings(const SceneSettings& settings, const mjModel& model) {
  const auto require = [](bool good, const char* what) {
    if (!good) throw std::invalid_argument(std::string("scene: ") + what);
  };
  require(settings.start_qpos.size() == model.nq && settings.start_qpos.allFinite(),
          "start_qpos does not fit the robot");
  require(settings.start_qvel.size() == model.nv && settings.start_qvel.allFinite(),
          "start_qvel does not fit the robot");
  require(std::isfinite(settings.period) && settings.period > 0.0, "the period is not positive");
  require(settings.travel.allFinite() && std::isfinite(settings.turn) && std::isfinite(settings.t0),
          "travel, turn or t0 is not finite");
  require(settings.floor_friction > 0.0 && std::isfinite(settings.floor_friction),
          "the friction is not positive");
  require(settings.gain_scale > 0.0 && std::isfinite(settings.gain_scale),
          "the gain scale is not positive");
}

bool has_class(const XMLElement& root, const std::string& name) {
  bool found = false;
  for_each_element(root, [&](const XMLElement& element) {
    found = found || (is_tag(element, "default") && attribute(element, "class") == name);
  });
  return found;
}

/// Puts the plugin's actuators in place of the robot's. The class teaches MuJoCo's implicit
/// integrators the derivative of the servo (plugin/README.md); the plugin itself computes the
/// torque.
void replace_servos(XMLElement& root, const RobotModel& robot, double gain_scale) {
  while (XMLElement* old = root.FirstChildElement("actuator")) root.DeleteChild(old);
  XMLElement& defaults = section(root, "default");
  XMLElement& actuators = add(root, "actuator");
  std::map<std::string, std::string> class_of;  // by biasprm
  for (const Servo& servo : robot.servos) {
    const Gains gains = scaled_gains(servo, gain_scale);
    const std::string bias = fmt::format("0 -{} -{}", gains.kp, gains.kd);
    const auto [at, is_new] = class_of.try_emplace(bias);
    if (is_new) {
      at->second = unused_name(fmt::format("legwright_pd_{}", class_of.size() - 1),
                               [&root](const std::string& name) { return has_class(root, name); });
      XMLElement& pd = add(defaults, "default");
      pd.SetAttribute("class", at->second.c_str());
      XMLElement& general = add(pd, "general");
      general.SetAttribute("dyntype", "none");
      general.SetAttribute("actlimited", "false");
      general.SetAttribute("gaintype", "fixed");
      general.SetAttribute("gainprm", "1");
      general.SetAttribute("biastype", "affine");
      general.SetAttribute("biasprm", bias.c_str());
      general.SetAttribute("gear", "1");
      general.SetAttribute("ctrllimited", "false");
    }
    XMLElement& actuator = add(actuators, "plugin");
    actuator.SetAttribute("name", servo.actuator.c_str());
    actuator.SetAttribute("class", at->second.c_str());
    actuator.SetAttribute("plugin", kGaitPlugin);
    actuator.SetAttribute("instance", kInstance);
    if (servo.tendon.empty())
      actuator.SetAttribute("joint", servo.joint.c_str());
    else
      actuator.SetAttribute("tendon", servo.tendon.c_str());
    const bool limited = std::isfinite(servo.torque_limit);
    actuator.SetAttribute("forcelimited", limited ? "true" : "false");
    if (limited)
      actuator.SetAttribute("forcerange",
                            fmt::format("-{0} {0}", format_number(servo.torque_limit)).c_str());
  }
}

bool has_key(XMLElement& root, const char* name) {
  for (XMLElement* keys = root.FirstChildElement("keyframe"); keys;
       keys = keys->NextSiblingElement("keyframe"))
    for (XMLElement* key = keys->FirstChildElement("key"); key;
         key = key->NextSiblingElement("key"))
      if (key->Attribute("name", name) != nullptr) return true;
  return false;
}

void add_plugin(XMLElement& root, const RobotModel& robot, const SceneSettings& settings) {
  XMLElement& extension = add(root, "extension");
  extension.InsertEndChild(root.GetDocument()->NewComment(kHowToLoad));
  XMLElement& plugin = add(extension, "plugin");
  plugin.SetAttribute("plugin", kGaitPlugin);
  add(extension, "plugin").SetAttribute("plugin", kSensorPlugin);
  XMLElement& instance = add(plugin, "instance");
  instance.SetAttribute("name", kInstance);
  const auto of_servos = [&](const auto& text_of) {
    std::string out;
    for (const Servo& servo : robot.servos) out += (out.empty() ? "" : " ") + text_of(servo);
    return out;
  };
  const auto config = [&](const char* key, const std::string& value) {
    XMLElement& element = add(instance, "config");
    element.SetAttribute("key", key);
    element.SetAttribute("value", value.c_str());
  };
  const auto gains = [&](const Servo& servo) { return scaled_gains(servo, settings.gain_scale); };
  config("kp", of_servos([&](const Servo& servo) { return gains(servo).kp; }));
  config("kd", of_servos([&](const Servo& servo) { return gains(servo).kd; }));
  const bool any_line = std::any_of(robot.servos.begin(), robot.servos.end(),
                                    [](const Servo& servo) { return servo.line.has_value(); });
  if (any_line) {
    const auto line = [](const Servo& servo) { return servo.line.value_or(MotorLine{}); };  // zeros
    config("stall_torque",
           of_servos([&](const Servo& servo) { return format_number(line(servo).stall_torque); }));
    config("no_load_speed",
           of_servos([&](const Servo& servo) { return format_number(line(servo).no_load_speed); }));
  }
  config("period", format_number(settings.period));
  config("travel", format_numbers(settings.travel));
  config("turn", format_number(settings.turn));
  config("t0", format_number(settings.t0));
  config("trajectory", settings.trajectory);
  if (has_key(root, kStandingKey)) config("rest", kStandingKey);
}

void add_sensors(XMLElement& root, const Morphology& morphology, const std::string& floor) {
  XMLElement& sensors = section(root, "sensor");
  XMLElement& tracking = add(sensors, "plugin");
  tracking.SetAttribute("name", "tracking");
  tracking.SetAttribute("plugin", kGaitPlugin);
  tracking.SetAttribute("instance", kInstance);
  for (const char* const kind : kSensorKinds) {
    XMLElement& sensor = add(sensors, "plugin");
    sensor.SetAttribute("name", (std::string("gait:") + kind).c_str());
    sensor.SetAttribute("plugin", kSensorPlugin);
    XMLElement& config = add(sensor, "config");
    config.SetAttribute("key", "kind");
    config.SetAttribute("value", kind);
  }
  for (const Foot& foot :
       morphology.feet) {  // found (0 or count), then the force on the foot, world axes [N]
    XMLElement& contact = add(sensors, "contact");
    contact.SetAttribute("name", ("contact:" + foot.name).c_str());
    contact.SetAttribute("geom1", floor.c_str());
    contact.SetAttribute("geom2", foot.name.c_str());
    contact.SetAttribute("data", "found force");
    contact.SetAttribute("reduce", "netforce");
  }
}

/// Keys of the robot stay without their controls: those of its servos mean something else to the
/// plugin.
void write_keyframes(XMLElement& root, const SceneSettings& settings) {
  for (XMLElement* keys = root.FirstChildElement("keyframe"); keys;
       keys = keys->NextSiblingElement("keyframe"))
    for (XMLElement* key = keys->FirstChildElement("key"); key;
         key = key->NextSiblingElement("key")) {
      key->DeleteAttribute("ctrl");
      key->DeleteAttribute("act");
    }
  XMLElement& gait = add(section(root, "keyframe"), "key");
  gait.SetAttribute("name", "gait");
  gait.SetAttribute("time", "0");
  gait.SetAttribute("qpos", format_numbers(settings.start_qpos).c_str());
  gait.SetAttribute("qvel", format_numbers(settings.start_qvel).c_str());
}

}  // namespace

std::string emit_scene(const RobotModel& robot, const std::string& design_xml,
                       const SceneSettings& settings) {
  const std::string robot_xml = played_robot(robot, design_xml);
  const auto xml = load_xml(robot_xml, robot.file);
  const ModelPointer model = compile_mjcf(robot_xml, robot.file);
  check_settings(settings, *model);
  XMLElement& root = *xml->dom.RootElement();
  const int trunk = mj_name2id(model.get(), mjOBJ_BODY, robot.root_body.c_str());
  const XmlElement* trunk_element = find_named(root, "body", robot.root_body);
  if (trunk < 0 || !trunk_element)
    throw std::invalid_argument("scene: the text is not of this robot");

  const SceneView view =
      scene_view(robot.morphology, robot.space.initial(), settings.travel, up_of(*model));
  add_followers(const_cast<XmlElement&>(*trunk_element), view, rotation_at(model->body_quat, trunk),
                has_light(*model));
  replace_servos(root, robot, settings.gain_scale);
  add_settings(root, *model, view, step_of_scenes(robot.servos));
  const std::string floor = add_floor(root, *model, view, settings.floor_friction);
  add_side_camera(root, view);
  add_sensors(root, robot.morphology, floor);
  write_keyframes(root, settings);
  add_plugin(root, robot, settings);

  tinyxml2::XMLPrinter printer;
  xml->dom.Print(&printer);
  return printer.CStr();
}

}  // namespace legwright
