// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <filesystem>
#include <string>

#include "mjcf/scene/emit_scene.hpp"
#include "mjcf/scene/played_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "tests/support/paths.hpp"

namespace legwright::test {

/// Stands still in the home pose for ever.
inline std::string standing(const RobotModel& robot) {
  const Morphology& m = robot.morphology;
  std::string text = "time_s";
  for (const Servo& servo : robot.servos) text += fmt::format(" q:{}_rad", servo.joint);
  for (const Servo& servo : robot.servos) text += fmt::format(" tau:{}_Nm", servo.joint);
  text += " root_x_m root_y_m root_z_m root_rx_rad root_ry_rad root_rz_rad com_x_m com_y_m com_z_m";
  for (const Foot& foot : m.feet) {
    for (const char* c : {"x_m", "y_m", "z_m", "fx_N", "fy_N", "fz_N"})
      text += fmt::format(" foot:{}_{}", foot.name, c);
    text += " contact:" + foot.name;
  }
  for (int knot = 0; knot < 4; ++knot) {
    text += fmt::format(";{}", 0.25 * knot);
    for (const double q : m.nominal_joints()) text += fmt::format(" {}", q);
    for (int i = 0; i < m.joint_count() + 9; ++i) text += " 0";
    for (int f = 0; f < m.foot_count(); ++f) text += " 0 0 0 0 0 1 1";
  }
  return text;
}

inline SceneSettings settings_for(const RobotModel& robot) {
  const ModelPointer model = compile_mjcf(played_robot(robot, robot.xml), robot.file);
  SceneSettings settings;
  settings.trajectory = standing(robot);
  settings.period = 1.0;
  settings.travel = Eigen::Vector3d(0, 0.1, 0);
  const int home = mj_name2id(model.get(), mjOBJ_KEY, "home");
  settings.start_qpos =
      Eigen::VectorXd::Map(home < 0 ? model->qpos0 : model->key_qpos + home * model->nq, model->nq);
  settings.start_qvel = Eigen::VectorXd::Zero(model->nv);
  return settings;
}

/// Compiles with the plugin, which is loaded once for the process.
inline ModelPointer compile_scene(const std::string& scene) {
  static const bool loaded = [] {
    const std::string library = binary_dir() + "/bin/mujoco_plugin/liblegwright.so";
    if (std::filesystem::exists(library)) mj_loadPluginLibrary(library.c_str());
    return std::filesystem::exists(library);
  }();
  EXPECT_TRUE(loaded);
  return compile_mjcf(scene, "scene.xml");
}

}  // namespace legwright::test
