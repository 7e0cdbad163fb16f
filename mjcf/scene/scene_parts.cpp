// SPDX-License-Identifier: Apache-2.0
#include "mjcf/scene/scene_parts.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mjcf/read/solver_options.hpp"
#include "mjcf/text/numbers.hpp"
#include "mjcf/text/unused_name.hpp"
#include "mjcf/text/xml.hpp"
#include "optimizer/design/rotation.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using tinyxml2::XMLElement;

constexpr double kFieldOfView = 30.0;  // [deg], vertical

/// 1, 2 or 5 times a power of ten, not above x.
double round_length(double x) {
  const double power = std::pow(10.0, std::floor(std::log10(x)));
  return power * (x >= 5 * power ? 5 : x >= 2 * power ? 2 : 1);
}

/// Four digits are plenty for a picture and keep the file readable.
std::string short_numbers(const Eigen::Ref<const Eigen::VectorXd>& values) {
  std::string text;
  for (Eigen::Index i = 0; i < values.size(); ++i)
    text += fmt::format("{}{:.4g}", i > 0 ? " " : "", std::abs(values[i]) < 1e-6 ? 0.0 : values[i]);
  return text;
}

void set(XMLElement& element, const char* name, const std::string& value) {
  element.SetAttribute(name, value.c_str());
}

void place_camera(XMLElement& camera, const char* name, const Vector3d& pos, const Vector3d& right,
                  const Vector3d& up) {
  Eigen::Matrix<double, 6, 1> axes;
  axes << right, up;
  set(camera, "name", name);
  set(camera, "pos", short_numbers(pos));
  set(camera, "xyaxes", format_numbers(axes));
  set(camera, "fovy", format_number(kFieldOfView));
}

/// Sky, unless the robot has one, and the floor's material.
void add_floor_assets(XMLElement& root, const mjModel& robot, const std::string& material_name,
                      double tile) {
  XMLElement& asset = add(root, "asset");
  bool has_sky = false;
  for (int t = 0; t < robot.ntex; ++t) has_sky = has_sky || robot.tex_type[t] == mjTEXTURE_SKYBOX;
  if (!has_sky) {
    XMLElement& sky = add(asset, "texture");
    for (const auto& [name, value] : {std::pair{"type", "skybox"},
                                      {"builtin", "gradient"},
                                      {"rgb1", "0.97 0.98 1"},
                                      {"rgb2", "0.72 0.8 0.9"},
                                      {"width", "256"},
                                      {"height", "1536"}})
      sky.SetAttribute(name, value);
  }
  XMLElement& checker = add(asset, "texture");
  const std::string texture = unused_name(robot, mjOBJ_TEXTURE, "legwright_floor");
  set(checker, "name", texture);
  for (const auto& [name, value] : {std::pair{"type", "2d"},
                                    {"builtin", "checker"},
                                    {"rgb1", "0.86 0.88 0.9"},
                                    {"rgb2", "0.8 0.82 0.85"},
                                    {"width", "256"},
                                    {"height", "256"}})
    checker.SetAttribute(name, value);
  XMLElement& material = add(asset, "material");
  set(material, "name", material_name);
  set(material, "texture", texture);
  set(material, "texuniform", "true");
  set(material, "texrepeat", fmt::format("{0:.6g} {0:.6g}", 0.5 / tile));
  set(material, "rgba", "1 1 1 1");
  set(material, "specular", "0.1");
  set(material, "reflectance", "0");
}

}  // namespace

XMLElement& add(XMLElement& parent, const char* tag) { return *parent.InsertNewChildElement(tag); }

XMLElement& section(XMLElement& root, const char* tag) {
  XMLElement* found = root.FirstChildElement(tag);
  return found ? *found : add(root, tag);
}

SceneView scene_view(const Morphology& morphology, const Eigen::VectorXd& s, const Vector3d& travel,
                     const Vector3d& up) {
  SceneView view;
  view.leg_length = std::max(morphology.leg_length, 1e-3);
  double reach = 0.0;
  for (const Link& link : morphology.links)
    if (link.parent == 0) reach = std::max(reach, link.origin.at(s).head<2>().norm());
  view.radius = reach + 0.5 * view.leg_length;
  view.centre = Vector3d(0.0, 0.0, 0.4 * view.leg_length);
  const double heading = travel.head<2>().norm() > 1e-9 ? std::atan2(travel.y(), travel.x()) : 0.0;
  const double turned = 0.35, raised = 0.3;  // [rad]
  const Matrix3d yaw = Eigen::AngleAxisd(heading + turned, Vector3d::UnitZ()).toRotationMatrix();
  const Matrix3d oblique = smallest_rotation(Vector3d::UnitZ(), up).toRotationMatrix();
  view.right = oblique * yaw.col(0);
  view.back = oblique * (std::cos(raised) * -yaw.col(1) + std::sin(raised) * Vector3d::UnitZ());
  view.up = view.back.cross(view.right);
  view.distance = 1.35 * view.radius / std::tan(kFieldOfView / 2 * std::numbers::pi / 180);
  return view;
}

bool has_light(const mjModel& robot) {
  return std::any_of(robot.light_active, robot.light_active + robot.nlight,
                     [](mjtBool active) { return active; });
}

void add_settings(XMLElement& root, const mjModel& robot, const SceneView& view, double time_step) {
  set_solver(add(root, "option"), robot.opt, time_step);
  XMLElement& visual = add(root, "visual");
  XMLElement& global = add(visual, "global");
  set(global, "offwidth", "1280");
  set(global, "offheight", "720");
  XMLElement& quality = add(visual, "quality");
  set(quality, "shadowsize", "2048");
  set(quality, "offsamples", "4");
  if (!has_light(robot)) {
    XMLElement& headlight = add(visual, "headlight");
    set(headlight, "ambient", "0.35 0.35 0.35");
    set(headlight, "diffuse", "0.35 0.35 0.35");
    set(headlight, "specular", "0.1 0.1 0.1");
  }
  XMLElement& map = add(visual, "map");
  set(map, "znear", "0.02");
  set(map, "zfar", "100");
  set(map, "shadowclip", "2");
  // MuJoCo draws a force of F newtons F·force/(mean mass of the bodies) metres long.
  const auto bodies = static_cast<double>(robot.nbody - 1);
  set(map, "force", fmt::format("{:.4g}", 2.5 * view.leg_length / (kGravity * bodies)));
  // Without it the viewer would take its scale from the floor.
  XMLElement& statistic = add(root, "statistic");
  set(statistic, "center", short_numbers(view.centre));
  set(statistic, "extent", format_number(round_length(4 * view.radius)));
}

std::string add_floor(XMLElement& root, const mjModel& robot, const SceneView& view,
                      double friction) {
  const double tile = round_length(0.5 * view.leg_length);  // side of a square; a repeat has two
  const std::string material = unused_name(robot, mjOBJ_MATERIAL, "legwright_floor");
  add_floor_assets(root, robot, material, tile);
  int bits = 0, priority = 0;
  for (int g = 0; g < robot.ngeom; ++g) {
    bits |= robot.geom_contype[g] | robot.geom_conaffinity[g];
    priority = std::max(priority, robot.geom_priority[g]);
  }
  XMLElement& world = section(root, "worldbody");
  XMLElement& floor = add(world, "geom");
  const double half = std::max(10.0, round_length(100 * view.leg_length));
  std::string name = unused_name(robot, mjOBJ_GEOM, "floor");
  set(floor, "name", name);
  set(floor, "type", "plane");
  set(floor, "pos", "0 0 0");
  set(floor, "size", fmt::format("{0} {0} {1}", half, tile));
  set(floor, "material", material);
  set(floor, "rgba", "1 1 1 1");
  set(floor, "group", "0");
  set(floor, "contype", fmt::format("{}", bits));
  set(floor, "conaffinity", fmt::format("{}", bits));
  // With the higher priority the floor alone says how contacts behave, whatever the feet say.
  set(floor, "priority", fmt::format("{}", priority + 1));
  set(floor, "condim", "3");
  set(floor, "friction", fmt::format("{} 0.005 0.0001", friction));
  set(floor, "solref", "0.005 1");
  set(floor, "solimp", "0.9 0.95 0.001 0.5 2");
  set(floor, "margin", "0");
  set(floor, "gap", "0");
  return name;
}

void add_side_camera(XMLElement& root, const SceneView& view, const std::string& name) {
  place_camera(add(section(root, "worldbody"), "camera"), name.c_str(),
               view.centre + view.distance * view.back, view.right, view.up);
}

void add_followers(XMLElement& trunk, const SceneView& view, const Matrix3d& orientation,
                   bool lit) {
  const Matrix3d to_trunk = orientation.transpose();
  XMLElement& camera = add(trunk, "camera");
  place_camera(camera, "track", to_trunk * (view.distance * view.back), to_trunk * view.right,
               to_trunk * view.up);
  set(camera, "mode", "trackcom");
  if (lit) return;
  const Vector3d from(0.35, -0.5, 1.0);
  XMLElement& light = add(trunk, "light");
  set(light, "mode", "trackcom");
  set(light, "type", "directional");
  set(light, "pos", short_numbers(to_trunk * (8 * view.radius * from)));
  set(light, "dir", short_numbers(to_trunk * -from.normalized()));
  set(light, "diffuse", "0.5 0.5 0.5");
  set(light, "specular", "0.2 0.2 0.2");
  set(light, "castshadow", "true");
}

}  // namespace legwright
