// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/export_urdf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <utility>

#include "mjcf/text/compile.hpp"
#include "mjcf/urdf/write_urdf.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/run/install.hpp"
#include "tools/run/task_folders.hpp"
#include "tools/simulate/scene.hpp"
#include "tools/verbs/play_script.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// A folder that nothing of the robot stands in.
fs::path new_folder(const fs::path& folder) {
  if (fs::exists(fs::symlink_status(folder)))
    throw IoError(
        fmt::format("{}: the robot has files there, where the export needs a folder of "
                    "its own; rename the robot's folder",
                    folder.filename().string()));
  fs::create_directories(folder);
  return folder;
}

/// @param text_file of the URDF. @param meshes folder for its meshes
UrdfRobot write_robot_urdf(const RobotModel& robot, const fs::path& text_file,
                           const fs::path& meshes, const std::string& mesh_prefix) {
  const ModelPointer model = compile_mjcf(robot.xml, robot.file, MeshDetail::triangles);
  UrdfRobot urdf = urdf_of(robot, *model, mesh_prefix);
  fs::create_directories(text_file.parent_path());
  write_file(text_file, urdf.text);
  if (!urdf.meshes.empty()) fs::create_directories(meshes);
  for (const UrdfMesh& mesh : urdf.meshes) write_file(meshes / mesh.file, mesh.obj);
  return urdf;
}

/// Lower-case letters, digits and underscores, a letter first: what ROS takes for a name.
std::string package_name(const std::string& name) {
  std::string out;
  for (const char c : name) {
    const auto sign = static_cast<unsigned char>(c);
    const bool good = sign < 128 && std::isalnum(sign) != 0;
    if (good || (!out.empty() && out.back() != '_'))
      out += good ? static_cast<char>(std::tolower(sign)) : '_';
  }
  while (!out.empty() && out.back() == '_') out.pop_back();
  const bool letter = !out.empty() && std::isalpha(static_cast<unsigned char>(out.front())) != 0;
  return letter ? out : "robot_" + out;
}

/// One cycle as the plugin plays it, in the fields of trajectory_msgs/JointTrajectory: JSON, which
/// is YAML, too. The last point is the first, one period later.
std::string trajectory_text(const Trajectory& plan) {
  const int knots = plan.knot_count;
  const double step = plan.period / knots;
  const auto at = [&](int knot, int column) { return plan.at((knot + knots) % knots, column); };
  std::string out =
      fmt::format("{{\"joint_names\": {},\n\"points\": [\n", Json(plan.joint_names).dump());
  for (int knot = 0; knot <= knots; ++knot) {
    std::vector<double> positions, velocities, effort;
    for (int joint = 0; joint < plan.joint_count(); ++joint) {
      const int column = plan.target_column(joint);
      const double before = at(knot - 1, column), after = at(knot + 1, column);
      positions.push_back((before + 4.0 * at(knot, column) + after) / 6.0);
      velocities.push_back((after - before) / (2.0 * step));
      effort.push_back(at(knot, plan.torque_column(joint)));
    }
    const auto nanoseconds = static_cast<std::int64_t>(std::llround(1e9 * step * knot));
    const Json point = {
        {"positions", positions},
        {"velocities", velocities},
        {"effort", effort},
        {"time_from_start",
         {{"sec", nanoseconds / 1000000000}, {"nanosec", nanoseconds % 1000000000}}}};
    out += point.dump() + (knot < knots ? ",\n" : "\n");
  }
  return out + "]}\n";
}

/// Each gait of a run: the name of its file, and its plan.
std::vector<std::pair<std::string, Trajectory>> gaits_of(const fs::path& run) {
  std::vector<std::pair<std::string, Trajectory>> out;
  const std::vector<TaskFolder> tasks = task_folders_of(run);
  if (tasks.empty()) out.emplace_back("gait", load_scene(run / "result/scene.xml").trajectory);
  for (const TaskFolder& task : tasks)
    out.emplace_back(task.name + "_gait",
                     load_scene(run / task.relative / "result/scene.xml").trajectory);
  return out;
}

/// Whose robot it is and under which licence nobody has told: both are left to fill in, in the
/// words that `ros2 pkg create` writes.
constexpr const char* kPackageXml = R"(<?xml version="1.0"?>
<package format="3">
  <name>{}</name>
  <version>{}</version>
  <description>A legged robot and its gait, co-designed by Legwright</description>
  <maintainer email="todo@todo.todo">TODO: Maintainer</maintainer>
  <license>TODO: License declaration</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <exec_depend>launch</exec_depend>
  <exec_depend>launch_ros</exec_depend>
  <exec_depend>rclpy</exec_depend>
  <exec_depend>robot_state_publisher</exec_depend>
  <exec_depend>sensor_msgs</exec_depend>
  <exec_depend>trajectory_msgs</exec_depend>
  <export>
    <build_type>ament_cmake</build_type>
  </export>
</package>
)";

constexpr const char* kCmakeLists = R"(cmake_minimum_required(VERSION 3.8)
project({} NONE)
find_package(ament_cmake REQUIRED)
install(DIRECTORY config launch{} urdf DESTINATION share/${{PROJECT_NAME}})
install(PROGRAMS scripts/play_gait.py DESTINATION lib/${{PROJECT_NAME}})
ament_package()
)";

}  // namespace

std::vector<std::string> write_urdf(const RobotModel& robot, const fs::path& folder,
                                    const std::string& name) {
  const fs::path urdf = new_folder(folder / "urdf");
  return write_robot_urdf(robot, urdf / (name + ".urdf"), urdf / "meshes", "meshes/").lost;
}

std::string write_ros(const RobotModel& robot, const fs::path& run, const fs::path& folder,
                      const std::string& name) {
  std::string package = package_name(name);
  const fs::path root = new_folder(folder / "ros") / package;
  const UrdfRobot urdf = write_robot_urdf(robot, root / "urdf/robot.urdf", root / "meshes",
                                          fmt::format("package://{}/meshes/", package));
  for (const char* const part : {"config", "launch", "scripts"})
    fs::create_directories(root / part);
  for (const auto& [gait, plan] : gaits_of(run))
    write_file(root / "config" / (gait + ".yaml"), trajectory_text(plan));
  write_file(root / "package.xml",
             fmt::format(fmt::runtime(kPackageXml), package, program_version()));
  write_file(root / "CMakeLists.txt",
             fmt::format(fmt::runtime(kCmakeLists), package, urdf.meshes.empty() ? "" : " meshes"));
  write_file(root / "launch/walk.launch.py", kRosLaunch);
  write_file(root / "scripts/play_gait.py", kRosNode);
  fs::permissions(root / "scripts/play_gait.py",
                  fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                  fs::perm_options::add);
  return package;
}

}  // namespace legwright
