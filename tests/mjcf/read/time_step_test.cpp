// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/time_step.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "mjcf/read/moving_parts.hpp"
#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

/// The puppy with rotors that weigh nothing; `kv` [N m s/rad] of each servo.
RobotModel light_puppy(double kv) {
  std::string xml = test::with(test::named_robot("puppy"), "armature=\"0.0005\"", "armature=\"0\"");
  return parse_robot(test::with(xml, "kv=\"0.8\"", fmt::format("kv=\"{}\"", kv)), "puppy.xml");
}

/// What each joint of a robot's servos gains by a torque of 1 N m, by MuJoCo's whole step [rad/s²].
std::vector<double> accelerations(const RobotModel& robot) {
  const ModelPointer model = compile_mjcf(robot.xml, robot.file);
  model->opt.disableflags |= mjDSBL_CONSTRAINT | mjDSBL_ACTUATION;
  const DataPointer data = kinematics_at(*model, home_qpos(*model), robot.file);
  std::vector<double> out;
  for (const Servo& servo : robot.servos) {
    const int dof = model->jnt_dofadr[mj_name2id(model.get(), mjOBJ_JOINT, servo.joint.c_str())];
    std::vector<double> reached;
    for (const double torque : {0.0, 1.0}) {
      data->qfrc_applied[dof] = torque;
      mj_forward(model.get(), data.get());
      reached.push_back(data->qacc[dof]);
    }
    data->qfrc_applied[dof] = 0.0;
    out.push_back(reached[1] - reached[0]);
  }
  return out;
}

TEST(TimeStep, MobilityIsWhatATorqueAcceleratesAJointBy) {
  for (const char* name : {"puppy", "piston_puppy", "crooked_piston"}) {
    const RobotModel robot = parse_robot(test::named_robot(name), "robot.xml");
    const std::vector<double> wanted = accelerations(robot);
    for (std::size_t a = 0; a < wanted.size(); ++a)
      EXPECT_NEAR(robot.servos[a].mobility, wanted[a], 1e-9 * wanted[a]) << name << ' ' << a;
  }
}

TEST(TimeStep, IsShorterWhereServosDampLightLinks) {
  EXPECT_EQ(step_of_scenes(light_puppy(0.1).servos), 0.001);
  double before = 0.001;
  for (const double kv : {0.3, 0.5, 8.0}) {
    const double step = step_of_scenes(light_puppy(kv).servos);
    EXPECT_LE(step, before) << kv;
    before = step;
  }
  EXPECT_EQ(before, 0.00025) << "no shorter, whatever the servos are";
  const std::string told = describe_step(light_puppy(8.0).servos);
  for (const char* part : {"steps of 0.25 ms, not 1 ms", "4 times as long", "armature="})
    EXPECT_NE(told.find(part), std::string::npos) << told;
  EXPECT_EQ(describe_step(light_puppy(0.1).servos), "");
}

TEST(TimeStep, CountsWhatTheJointsDampAndTheArmsOfLinearActuators) {
  std::vector<Servo> servos(2);
  for (Servo& servo : servos) servo.mobility = 1000.0;
  servos[1].kd = 2.0;
  EXPECT_EQ(step_of_scenes(servos), 0.001);  // twice in a step
  servos[1].joint_damping = 1.0;
  EXPECT_EQ(step_of_scenes(servos), 0.0005);
  servos[1].arm = 0.1;
  EXPECT_EQ(step_of_scenes(servos), 0.001);
}

/// The ankles of the humanoid alone are light.
TEST(TimeStep, OfTheRobotsHereIsTheUsualOne) {
  std::vector<std::filesystem::path> files;
  for (const char* name : {"courser", "goat", "octopod", "ox", "porter", "servo_dog", "strider"})
    files.push_back(test::source_path(std::string("tests/robots/") + name + "/robot.xml"));
  for (const char* name : {"biped", "hexapod", "hexapod_long_legs", "piston_puppy",
                           "printed_quadruped", "puppy", "quadruped"})
    files.push_back(test::source_path(std::string("examples/") + name + "/robot.xml"));
  for (const auto& file : files) EXPECT_EQ(step_of_scenes(read_robot(file).servos), 0.001) << file;
}

}  // namespace
}  // namespace legwright
