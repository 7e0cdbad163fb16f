// SPDX-License-Identifier: Apache-2.0
#include "tests/golden/golden.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>

#include "tests/support/paths.hpp"
#include "tools/files/json_file.hpp"
#include "tools/image/png.hpp"
#include "tools/image/side_by_side.hpp"
#include "tools/render/poses.hpp"
#include "tools/run/motion_csv.hpp"

namespace legwright::golden {
namespace {

namespace fs = std::filesystem;

constexpr int kPhases = 3;
constexpr double kAzimuth = 215.0, kElevation = -24.0;  // no horizon in the picture
constexpr double kFloor = 4.0;                          // [m] half its side

struct SpecDeleter {
  void operator()(mjSpec* spec) const { mj_deleteSpec(spec); }
};

/// The robot of the file on a plain floor, no plugin, no texture, as MJCF.
void write_plain_scene(const fs::path& robot, const fs::path& scene) {
  std::array<char, 1000> message{};
  const auto check = [&](bool good) {
    if (!good) throw std::runtime_error(robot.string() + ": " + message.data());
  };
  const std::unique_ptr<mjSpec, SpecDeleter> spec(
      mj_parseXML(robot.c_str(), nullptr, message.data(), static_cast<int>(message.size())));
  check(spec != nullptr);
  mjsGeom* floor = mjs_addGeom(mjs_findBody(spec.get(), "world"), nullptr);
  mjs_setName(floor->element, "floor");
  floor->type = mjGEOM_PLANE;
  for (int axis : {0, 1}) floor->size[axis] = kFloor;
  floor->size[2] = 0.1;
  for (int c : {0, 1, 2}) floor->rgba[c] = 0.8F;
  const ModelPointer model(mj_compile(spec.get(), nullptr));
  if (!model) throw std::runtime_error(robot.string() + ": " + mjs_getError(spec.get()));
  check(mj_saveXML(spec.get(), scene.c_str(), message.data(), static_cast<int>(message.size())) ==
        0);
}

std::string advice(const fs::path& picture) {
  return fmt::format(
      "before | after | difference: {}\nIf the change is wanted: build/bin/golden_tool --write, "
      "and "
      "look at what git then shows.",
      picture.string());
}

}  // namespace

fs::path folder() { return fs::path(test::source_dir()) / "tests" / "golden"; }

fs::path Robot::id_file(const Pose& pose) const {
  return folder() / name / (pose.name + "_id.png");
}
fs::path Robot::colour_file(const Pose& pose) const {
  return folder() / name / (pose.name + "_colour.png");
}

std::vector<double> Robot::twin(const Pose& pose, double angle) const {
  const int joint = mj_name2id(model.get(), mjOBJ_JOINT, twin_joint.c_str());
  if (joint < 0) throw std::runtime_error(name + ": no joint '" + twin_joint + "'");
  std::vector<double> moved = pose.qpos;
  moved[static_cast<std::size_t>(model->jnt_qposadr[joint])] += angle;
  return moved;
}

Robot read_robot(const std::string& name) {
  Robot robot;
  robot.name = name;
  robot.model = load_drawn_scene(folder() / name / "scene.xml");
  const Json json = read_json(folder() / name / "poses.json");
  const Json& view = json.at("view");
  robot.view = {view.at("lookat_m").get<std::array<double, 3>>(), view.at("distance_m"),
                view.at("azimuth_deg"), view.at("elevation_deg")};
  robot.twin_joint = json.at("twin_joint");
  for (const Json& pose : json.at("poses")) {
    robot.poses.push_back({pose.at("name"), pose.at("qpos")});
    if (robot.poses.back().qpos.size() != static_cast<std::size_t>(robot.model->nq))
      throw std::runtime_error(name + "/poses.json: a pose that does not fit scene.xml");
  }
  return robot;
}

void adopt(const fs::path& run, const std::string& name) {
  const fs::path target = folder() / name, scene = target / "scene.xml";
  fs::create_directories(target);
  write_plain_scene(run / "result" / "robot.xml", scene);
  const ModelPointer model = load_drawn_scene(scene);
  const Trajectory plan = read_motion_csv(run / "result" / "motion.csv");
  Poses poses = planned_poses(*model, plan, kPhases, scene);
  for (std::size_t k = 0; k < poses.size(); ++k)  // the camera stands still, so does the robot
    for (std::size_t axis : {0U, 1U})
      poses[k][axis] -= plan.travel[axis] * static_cast<double>(k) / kPhases;
  const View view =
      frame_robot(*model, poses, kAzimuth, kElevation, static_cast<double>(kWidth) / kHeight, 0.06);
  Json json{{"schema", "legwright/golden_poses"}, {"version", 1}, {"robot", name}};
  json["view"] = {{"lookat_m", view.lookat},
                  {"distance_m", view.distance},
                  {"azimuth_deg", view.azimuth},
                  {"elevation_deg", view.elevation}};
  json["twin_joint"] = plan.joint_names.front();
  for (std::size_t k = 0; k < poses.size(); ++k)
    json["poses"].push_back({{"name", fmt::format("phase_{}_{}", k, kPhases)}, {"qpos", poses[k]}});
  write_json(target / "poses.json", json);
}

bool Versions::cover(const Versions& here) const {
  return gl_renderer == here.gl_renderer && gl_version == here.gl_version &&
         std::ranges::find(mujoco, here.mujoco.at(0)) != mujoco.end();
}

std::string Versions::text() const {
  return fmt::format("{}, {}, MuJoCo {}", gl_renderer, gl_version, fmt::join(mujoco, " or "));
}

Versions versions_here(const GlContext& context) {
  return {context.renderer(), context.version(), {mj_versionString()}};
}

Versions read_versions() {
  const Json json = read_json(folder() / "versions.json");
  return {json.at("gl_renderer"), json.at("gl_version"), json.at("mujoco")};
}

void write_versions(const Versions& here, bool same_pictures) {
  Versions stored = here;
  if (const Versions before = read_versions(); same_pictures) {
    if (before.cover(here)) return;
    if (before.gl_renderer == here.gl_renderer && before.gl_version == here.gl_version)
      stored.mujoco.insert(stored.mujoco.begin(), before.mujoco.begin(), before.mujoco.end());
  }
  write_json(folder() / "versions.json", {{"schema", "legwright/golden_versions"},
                                          {"version", 2},
                                          {"gl_renderer", stored.gl_renderer},
                                          {"gl_version", stored.gl_version},
                                          {"mujoco", stored.mujoco}});
}

std::string compare(const IdImage& stored, const IdImage& drawn, int allowed,
                    const fs::path& picture) {
  const int count = different_pixels(stored, drawn);
  if (count <= allowed) return "";
  fs::create_directories(picture.parent_path());
  write_png(picture, side_by_side(in_colours(stored), in_colours(drawn)));
  return fmt::format("{} of {} pixels show another geom than stored, at most {} may; {}", count,
                     stored.id.size(), allowed, advice(picture));
}

std::string compare(const Image& stored, const Image& drawn, const fs::path& picture) {
  const int count = different_pixels(stored, drawn);
  if (count == 0) return "";
  fs::create_directories(picture.parent_path());
  write_png(picture, side_by_side(stored, drawn));
  return fmt::format("{} of {} pixels have another colour than stored, none may; {}", count,
                     stored.width * stored.height, advice(picture));
}

}  // namespace legwright::golden
