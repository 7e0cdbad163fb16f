// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tests/support/paths.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/task/problem.hpp"

namespace legwright::test {

/// A task of a robot of the examples, from the text of its tables.
inline CodesignProblem problem_of(const std::string& robot, const std::string& tables) {
  const TemporaryFolder folder;
  const std::string file = test::source_dir() + "/examples/" + robot + "/robot.xml";
  const std::filesystem::path task = folder.path() / "task.toml";
  write_file(task, "robot = \"" + file + "\"\n" + tables);
  return read_problem(task);
}

inline CodesignProblem trot() {
  return problem_of("quadruped",
                    "[gait]\nname = \"trot\"\nperiod = 0.4\n[travel]\nvelocity = [0.4, 0.0]\n");
}

/// F's optimum of this one saturates servos; tightened ones do not.
inline CodesignProblem canter() {
  return problem_of("quadruped",
                    "[gait]\nname = \"canter\"\nperiod = 0.25\n[travel]\nvelocity = [0.1, 0.0]\n");
}

}  // namespace legwright::test
