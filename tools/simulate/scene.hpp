// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mjcf/text/compile.hpp"
#include "optimizer/design/morphology.hpp"
#include "plugin/trajectory.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/simulate/played_state.hpp"

namespace legwright {

/// A scene ready to be played: the compiled model with the plugin in it, the plan that the plugin
/// plays, and where the things that are measured are in the model. Immutable: any number of
/// roll-outs may share it.
struct Scene {
  std::string name;  // for messages
  ModelPointer model;
  Trajectory trajectory;  // as the plugin has it; travel and turn where the scene states them
  double t0 = 0.0;        // the plugin plays time + t0 [s]; its `speed` is in the plan already
  double gain_scale = 1.0;
  JointMap joints;
  std::vector<double>
      torque_limit;  // per joint, of actuator and joint together; infinite if none [N m]
  std::vector<MotorLine> motor_line;  // per joint or its linear actuator, as played; zeros: none
  std::vector<int> tendon_actuator;   // per joint: the linear actuator that moves it, or −1
  std::vector<int> foot_geom;         // per foot of the trajectory
  int start_key = -1;                 // keyframe "gait"
};

/// The scene's text with its servo gains scaled, kp × scale and kd × √scale: in the configuration
/// of each instance of legwright.gait and in the biasprm (0 −kp −kd) of the default classes of its
/// actuators, which must agree. Scale 1 gives the text back byte for byte. Throws MujocoError where
/// the scene is not of the shape that plugin/README.md describes.
std::string scale_gains(const std::string& scene_xml, double scale, const std::string& name);
/// The same with a factor for each.
std::string scale_gains(const std::string& scene_xml, double stiffness, double damping,
                        const std::string& name);

/// Compiles a scene with its gains scaled. Loads the plugin.
/// @param folder against which asset paths are meant. Throws MujocoError which says what is
/// missing.
/// @param detail triangles where somebody looks at its meshes, or means geoms by the numbers that
/// they have in the file: without what is only to be seen they have others
Scene parse_scene(const std::string& xml, const std::string& name, double gain_scale = 1.0,
                  const std::filesystem::path& folder = {}, MeshDetail detail = MeshDetail::hulls);
/// The same from a file; std::system_error where it cannot be read.
Scene load_scene(const std::filesystem::path& file, double gain_scale = 1.0,
                 MeshDetail detail = MeshDetail::hulls);

}  // namespace legwright
