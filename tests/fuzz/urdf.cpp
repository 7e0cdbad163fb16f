// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/read_robot.hpp"
#include "mjcf/urdf/read_urdf.hpp"
#include "tests/fuzz/promises.hpp"
#include "tests/fuzz/targets.hpp"

namespace legwright::test {

bool fuzz_urdf(std::string_view text) {
  const std::filesystem::path file = "/nowhere/robot.urdf";  // in a folder that is not there
  const FileReach reach = FileReach::own_folder("outside of the robot's folder; copy it there");
  const std::string urdf(text);
  is_urdf(text);
  return accepted(file, [&] {
    const MjcfOfUrdf made = mjcf_of_urdf(urdf, file);
    const RobotModel robot = parse_robot(RobotFiles::from_text(made.text, file, reach));
    promise(!mjcf_of_urdf(urdf, file, mending_of(robot, made.without_moments)).text.empty(),
            "a URDF without a robot");
  });
}

}  // namespace legwright::test
