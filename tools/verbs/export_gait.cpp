// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/export_gait.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mjcf/scene/stock_scene.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/run/task_folders.hpp"
#include "tools/simulate/servo_gait.hpp"
#include "tools/verbs/play_script.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

void write_new(const fs::path& file, const std::string& text) {
  if (fs::exists(fs::symlink_status(file)))
    throw IoError(
        fmt::format("{}: the robot has a file of that name, which the exported gait "
                    "needs; rename the robot's file",
                    file.filename().string()));
  write_file(file, text);
}

Json servos_of(const Scene& scene) {
  const mjModel& model = *scene.model;
  const Trajectory& plan = scene.trajectory;
  const std::vector<std::string> columns = plan.header();
  Json out = Json::array();
  for (std::size_t joint = 0; joint < plan.joint_names.size(); ++joint) {
    const SceneServo found = servo_of(scene, joint);
    const auto k = static_cast<int>(joint);
    Json servo = {{"joint", plan.joint_names[joint]},
                  {"actuator", mj_id2name(&model, mjOBJ_ACTUATOR, found.actuator)},
                  {"target", columns.at(static_cast<std::size_t>(plan.target_column(k)))},
                  {"torque", columns.at(static_cast<std::size_t>(plan.torque_column(k)))},
                  {"kp", found.kp},
                  {"kd", found.kd}};
    if (std::isfinite(found.limit)) servo["limit"] = found.limit;
    servo["unit"] = found.linear || plan.slides(k) ? "N" : "N m";
    out.push_back(std::move(servo));
  }
  return out;
}

std::string csv_of(const Trajectory& plan) {
  std::string out = fmt::format("{}\n", fmt::join(plan.header(), ","));
  for (int knot = 0; knot < plan.knot_count; ++knot)
    for (int column = 0; column < plan.column_count(); ++column)
      out +=
          fmt::format("{}{}", plan.at(knot, column), column + 1 < plan.column_count() ? "," : "\n");
  return out;
}

void write_gait(const fs::path& scene_file, const std::string& prefix, const fs::path& folder) {
  const Scene scene = load_scene(scene_file);
  const Trajectory& plan = scene.trajectory;
  write_new(folder / (prefix + "walk.xml"),
            stock_scene(read_file(scene_file), scene_file.string()));
  write_new(folder / (prefix + "plugin_walk.xml"), read_file(scene_file));
  write_new(folder / (prefix + "gait.csv"), csv_of(plan));
  write_new(folder / (prefix + "gains.json"), to_text({{"schema", "legwright/gains"},
                                                       {"version", 1},
                                                       {"period_s", plan.period},
                                                       {"start_s", scene.t0},
                                                       {"travel_m", plan.travel},
                                                       {"turn_rad", plan.turn},
                                                       {"servos", servos_of(scene)}}));
}

}  // namespace

std::vector<std::string> write_gaits(const fs::path& run, const fs::path& folder) {
  const std::vector<TaskFolder> tasks = task_folders_of(run);
  std::vector<std::string> names;
  if (tasks.empty()) {
    write_gait(run / "result/scene.xml", "", folder);
    names.emplace_back();
  }
  for (const TaskFolder& task : tasks) {
    write_gait(run / task.relative / "result/scene.xml", task.name + "_", folder);
    names.push_back(task.name);
  }
  write_new(folder / "play.py", kPlayScript);
  return names;
}

}  // namespace legwright
