// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/read_robot.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/fuzz/promises.hpp"
#include "tests/fuzz/targets.hpp"

namespace legwright::test {

bool fuzz_robot(std::string_view text) {
  // In a folder that is not there: what the text names is none of its.
  const std::filesystem::path file = "/nowhere/robot.xml";
  const FileReach reach = FileReach::own_folder("outside of the robot's folder; copy it there");
  RobotModel robot;
  const bool read = accepted(
      file, [&] { robot = parse_robot(RobotFiles::from_text(std::string(text), file, reach)); });
  if (!read) return false;
  promise(rewrite_robot(robot, robot.space.initial()) == robot.xml,
          "the initial design is not given back byte for byte");
  const Eigen::VectorXd middle = 0.5 * (robot.space.lower() + robot.space.upper());
  const std::string design = rewrite_robot(robot, middle);
  const RobotModel again = parse_robot(robot.files.with_text(design), &robot.structure);
  promise(rewrite_robot(again, middle) == design,
          "the design that was written is not given back byte for byte");
  return true;
}

}  // namespace legwright::test
