// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "mjcf/text/input_error.hpp"
#include "mjcf/text/robot_files.hpp"
#include "mjcf/text/safe_path.hpp"
#include "tests/mjcf/robots/split_robot.hpp"
#include "tests/tools/files/temporary_folder.hpp"

namespace legwright::test {

/// A folder for a robot's file, with one to include below it and one outside.
class RobotHome : public testing::Test {
 protected:
  RobotHome() {
    put(home_ / "parts/leg.xml", "<mujoco><worldbody/></mujoco>");
    put(folder_.path() / "outside.xml", "<mujoco><worldbody/></mujoco>");
  }
  /// What is wrong with a path that stands in home/robot.xml.
  std::string fault(const std::string& reference, const FileReach& reach = {}) const {
    return find_file(home_, reference, 1000, reach).fault;
  }
  std::string refusal(const std::string& text, const FileReach& reach = {}) const {
    try {
      RobotFiles::from_text(text, home_ / "robot.xml", reach);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }
  static bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }

  test::TemporaryFolder folder_;
  std::filesystem::path home_ = folder_.path() / "home";
  const FileReach confined_ = FileReach::own_folder("out of reach: a rule");
};

}  // namespace legwright::test
