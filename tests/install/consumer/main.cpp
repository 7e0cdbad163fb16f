// SPDX-License-Identifier: Apache-2.0
// Reads a robot with mjcf and asks the optimizer for the trot of its feet.
#include <cstdio>
#include <exception>
#include <string>

#include "mjcf/read/read_robot.hpp"
#include "optimizer/motion/gait.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    const legwright::RobotModel robot = legwright::read_robot(argv[1]);
    const int feet = robot.morphology.foot_count();
    for (const legwright::GaitPattern& gait : legwright::gait_library(feet)) {
      if (gait.name != "trot") continue;
      const auto order = legwright::touchdown_order(gait);
      std::printf("%s: %d design parameters, %d feet, trot lifts %d at a time\n",
                  robot.morphology.name.c_str(), robot.space.size(), feet,
                  static_cast<int>(order.front().size()));
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
