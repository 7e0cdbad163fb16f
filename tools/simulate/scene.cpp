// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "plugin/number_text.hpp"
#include "tools/files/atomic_file.hpp"

namespace legwright {
namespace {

constexpr const char* kStartKey = "gait";

int gait_instance(const mjModel& model) {
  int slot = -1;
  mjp_getPlugin(kGaitPlugin, &slot);
  for (int i = 0; i < model.nplugin; ++i) {
    if (model.plugin[i] == slot) return i;
  }
  return -1;
}

std::string_view attribute(const mjModel& model, int instance, const char* key) {
  const char* value = mj_getPluginConfig(&model, instance, key);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

// The plugin has accepted the numbers when the model compiled, so that none is missing here.
std::vector<double> numbers(const mjModel& model, int instance, const char* key) {
  std::vector<double> out;
  for (const auto token : split_blanks(attribute(model, instance, key)))
    out.push_back(read_number(token).value_or(0.0));
  return out;
}

Trajectory read_plan(const mjModel& model, int instance) {
  CycleSettings cycle;
  if (const auto period = numbers(model, instance, "period"); period.size() == 1)
    cycle.period = period[0];
  if (const auto travel = numbers(model, instance, "travel"); travel.size() == 3) {
    cycle.travel = {travel[0], travel[1], travel[2]};
  }
  if (const auto turn = numbers(model, instance, "turn"); turn.size() == 1) cycle.turn = turn[0];
  return parse_trajectory(attribute(model, instance, "trajectory"), cycle);
}

/// Start and speed of the plugin's clock become part of the plan, which then runs in the
/// simulation's own seconds: played at `speed`, a cycle takes period/speed.
void set_clock(const mjModel& model, int instance, Scene& scene) {
  const auto number = [&](const char* key, double absent) {
    const auto value = numbers(model, instance, key);
    return value.size() == 1 ? value[0] : absent;
  };
  Trajectory& plan = scene.trajectory;
  scene.t0 = number("t0", number("phase", 0.0) * plan.period);
  const double speed = number("speed", 1.0);
  if (speed == 1.0) return;
  if (!(speed > 0.0)) {
    throw MujocoError(scene.name + ": the gait is played at speed " + std::to_string(speed) +
                      ", which has no cycles to be measured; expected more than 0");
  }
  scene.t0 /= speed;
  plan.period /= speed;
  for (int knot = 0; knot < plan.knot_count; ++knot) plan.at(knot, 0) /= speed;
}

double torque_limit(const mjModel& model, int joint) {
  double limit = std::numeric_limits<double>::infinity();
  const auto lower = [&](const mjtNum* range) {
    limit = std::min({limit, std::abs(range[0]), std::abs(range[1])});
  };
  if (model.jnt_actfrclimited[joint]) lower(&model.jnt_actfrcrange[2L * joint]);
  for (int a = 0; a < model.nactuator; ++a) {
    const bool ours =
        model.actuator_trntype[a] == mjTRN_JOINT && model.actuator_trnid[2L * a] == joint;
    if (ours && model.actuator_forcelimited[a]) lower(&model.actuator_forcerange[2L * a]);
  }
  return limit;
}

/// Of the joints of a scene, from the plugin's lists by actuator.
/// @param tendons of each joint: the linear actuator that moves it, or −1
std::vector<MotorLine> motor_lines(const mjModel& model, int instance, const JointMap& joints,
                                   const std::vector<int>& tendons) {
  std::vector<double> torque = numbers(model, instance, "stall_torque"),
                      speed = numbers(model, instance, "no_load_speed");
  std::vector<MotorLine> out(joints.joint.size());
  if (torque.empty() || speed.empty()) return out;
  std::size_t place = 0;  // among the actuators of the instance
  for (int a = 0; a < model.nactuator; ++a) {
    if (model.actuator_plugin[a] != instance) continue;
    const MotorLine line{torque[std::min(place, torque.size() - 1)],
                         speed[std::min(place, speed.size() - 1)]};
    ++place;
    const bool at_joint = model.actuator_trntype[a] == mjTRN_JOINT;
    for (std::size_t j = 0; j < out.size(); ++j)
      if (at_joint ? joints.joint[j] == model.actuator_trnid[2L * a] : tendons[j] == a)
        out[j] = line;
  }
  return out;
}

/// The actuator on a tendon whose two sites lie on either side of a hinge, or −1.
int tendon_actuator(const mjModel& model, int joint) {
  const int below = model.jnt_bodyid[joint];
  const auto rides_on = [&](int site) {  // the body that a hinge or the root moves
    int body = model.site_bodyid[site];
    while (body > 0 && model.body_dofnum[body] == 0) body = model.body_parentid[body];
    return body;
  };
  for (int a = 0; a < model.nactuator; ++a) {
    if (model.actuator_trntype[a] != mjTRN_TENDON) continue;
    const int start = model.tendon_adr[model.actuator_trnid[2L * a]];
    if (model.wrap_type[start] != mjWRAP_SITE || model.wrap_type[start + 1] != mjWRAP_SITE)
      continue;
    const int one = rides_on(model.wrap_objid[start]), two = rides_on(model.wrap_objid[start + 1]);
    if (one == below || two == below) {
      const int other = one == below ? two : one;
      int parent = model.body_parentid[below];
      while (parent > 0 && model.body_dofnum[parent] == 0) parent = model.body_parentid[parent];
      if (other == parent) return a;
    }
  }
  return -1;
}

}  // namespace

Scene parse_scene(const std::string& xml, const std::string& name, double gain_scale,
                  const std::filesystem::path& folder, MeshDetail detail) {
  load_gait_plugin();
  Scene scene;
  scene.name = name;
  scene.gain_scale = gain_scale;
  scene.model = compile_model(scale_gains(xml, gain_scale, name), name, folder, detail);
  mjModel& model = *scene.model;
  require_gait_plugin(model, name);
  const int instance = gait_instance(model);
  try {
    scene.trajectory = read_plan(model, instance);
  } catch (const TrajectoryError& error) {
    throw MujocoError(name + ": " + error.what());
  }
  set_clock(model, instance, scene);
  scene.joints = map_joints(model, scene.trajectory.joint_names);
  for (const int joint : scene.joints.joint) {
    scene.torque_limit.push_back(torque_limit(model, joint));
    scene.tendon_actuator.push_back(tendon_actuator(model, joint));
  }
  scene.motor_line = motor_lines(model, instance, scene.joints, scene.tendon_actuator);
  for (const auto& foot : scene.trajectory.foot_names) {
    const int geom = mj_name2id(&model, mjOBJ_GEOM, foot.c_str());
    if (geom < 0)
      throw MujocoError(
          fmt::format("{}: no geom is named '{}', which is a foot of the trajectory", name, foot));
    scene.foot_geom.push_back(geom);
  }
  scene.start_key = mj_name2id(&model, mjOBJ_KEY, kStartKey);
  if (scene.start_key < 0) {
    throw MujocoError(name + ": no keyframe is named '" + kStartKey +
                      "': where does the gait start?");
  }
  // A reset in mid-simulation would make a robot that flew apart look as if it stood.
  model.opt.disableflags |= mjDSBL_AUTORESET;
  // Everything is measured from the state itself; the sensors are there for people in a viewer.
  model.opt.disableflags |= mjDSBL_SENSOR;
  return scene;
}

Scene load_scene(const std::filesystem::path& file, double gain_scale, MeshDetail detail) {
  return parse_scene(read_file(file), file.string(), gain_scale, file.parent_path(), detail);
}

}  // namespace legwright
