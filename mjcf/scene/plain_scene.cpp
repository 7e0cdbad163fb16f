// SPDX-License-Identifier: Apache-2.0
#include "mjcf/scene/plain_scene.hpp"

#include "mjcf/read/time_step.hpp"
#include "mjcf/read/world_parts.hpp"
#include "mjcf/scene/scene_parts.hpp"
#include "mjcf/scene/surroundings.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/unused_name.hpp"

namespace legwright {
namespace {

void add_light(tinyxml2::XMLElement& world) {
  tinyxml2::XMLElement& light = add(world, "light");
  light.SetAttribute("type", "directional");
  light.SetAttribute("pos", "0 0 3");
  light.SetAttribute("dir", "-0.3 0.4 -0.9");
  light.SetAttribute("diffuse", "0.5 0.5 0.5");
  light.SetAttribute("specular", "0.2 0.2 0.2");
  light.SetAttribute("castshadow", "true");
}

}  // namespace

std::string plain_scene(const RobotModel& robot, const std::string& robot_xml,
                        const std::string& robot_file, double friction) {
  const ModelPointer model = compile_mjcf(robot_xml, robot.file);
  const SceneView view =
      scene_view(robot.morphology, robot.space.initial(), Eigen::Vector3d::Zero(), up_of(*model));
  tinyxml2::XMLDocument dom;
  dom.Parse("<mujoco/>");
  tinyxml2::XMLElement& root = *dom.RootElement();
  root.SetAttribute("model", (robot_file.substr(0, robot_file.rfind('.')) + " scene").c_str());
  add(root, "include").SetAttribute("file", robot_file.c_str());
  add_settings(root, *model, view, step_of_scenes(robot.servos));
  if (!has_ground(*model)) add_floor(root, *model, view, friction);
  add_side_camera(root, view, unused_name(*model, mjOBJ_CAMERA, "side"));
  if (!has_light(*model)) add_light(*root.FirstChildElement("worldbody"));
  tinyxml2::XMLPrinter printer;
  dom.Print(&printer);
  return printer.CStr();
}

}  // namespace legwright
