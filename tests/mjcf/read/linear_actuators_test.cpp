// SPDX-License-Identifier: Apache-2.0
// Linear actuators: read from tendons, against MuJoCo's lengths and moment arms, and refused.
#include "mjcf/read/linear_actuators.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "optimizer/design/actuator_length.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

TEST(LinearActuators, AreReadWithStrokeForceAndGains) {
  const RobotModel robot = parse_robot(test::named_robot("piston_puppy"), "p");
  ASSERT_EQ(robot.morphology.linear_actuators.size(), 4u);
  const LinearActuator& piston = robot.morphology.linear_actuators[1];
  EXPECT_EQ(piston.name, "FR_piston");
  EXPECT_EQ(robot.morphology.links[piston.joint + 1].joint.name, "FR_knee");
  EXPECT_EQ(piston.shortest, 0.045);
  EXPECT_EQ(piston.longest, 0.082);
  EXPECT_EQ(piston.force_limit, 120.0);
  EXPECT_TRUE(std::isinf(robot.morphology.links[piston.joint + 1].joint.torque_limit));
  EXPECT_EQ(robot.servos[piston.joint].tendon, "FR_piston");
  EXPECT_EQ(robot.servos[piston.joint].kp, 90000.0);
  EXPECT_EQ(robot.servos[0].tendon, "");
  EXPECT_EQ(robot.space.parameters[5].kind, ParameterKind::position);
  EXPECT_NEAR(robot.space.scale()[5], 0.5 * (0.035 - 0.008), 1e-15);
}

TEST(LinearActuators, GainsOfAMotorFollowFromItsForceAndArm) {
  const RobotModel robot = parse_robot(test::named_robot("crooked_piston"), "p");
  const LinearActuator& other = robot.morphology.linear_actuators[1];
  const double arm =
      robot.morphology.leg_length *
      std::abs(
          moment_arm(actuator_shape(robot.morphology, other, robot.space.initial()).value, 0.0));
  const Servo& servo = robot.servos[other.joint];
  EXPECT_EQ(servo.torque_limit, 60.0);
  EXPECT_NEAR(servo.kp * 0.0375 * arm, 60.0, 1e-9);  // all its force at an error of 0.0375 rad
  EXPECT_TRUE(std::isinf(other.longest));
  EXPECT_NEAR(robot.servos[robot.morphology.linear_actuators[0].joint].kp, 180000.0, 1e-6);
}

class Shapes : public testing::TestWithParam<const char*> {};

/// L and ∂L/∂q of the closed form against MuJoCo at random angles and designs.
TEST_P(Shapes, AreMujocosLengthsAndArms) {
  const RobotModel robot = parse_robot(test::named_robot(GetParam()), GetParam());
  const Morphology& m = robot.morphology;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-2.0, 2.0);
  for (int trial = 0; trial < 20; ++trial) {
    const VectorXd s = test::random_design(robot.space, random);
    const ModelPointer model = compile_mjcf(rewrite_robot(robot, s), "rewritten");
    const DataPointer data(mj_makeData(model.get()));
    for (int q = 7; q < model->nq; ++q) data->qpos[q] = angle(random);
    mj_fwdPosition(model.get(), data.get());
    for (const LinearActuator& actuator : m.linear_actuators) {
      const int t = mj_name2id(model.get(), mjOBJ_TENDON, actuator.name.c_str());
      const double q = data->qpos[7 + actuator.joint];
      const Eigen::Vector3d shape = actuator_shape(m, actuator, s).value;
      EXPECT_NEAR(m.leg_length * actuator_length(shape, q), data->ten_length[t], 1e-9);
      ASSERT_GE(model->ten_J_rownnz[t], 1);
      double arm = 0.0;
      for (int k = 0; k < model->ten_J_rownnz[t]; ++k)
        if (model->ten_J_colind[model->ten_J_rowadr[t] + k] == 6 + actuator.joint)
          arm = data->ten_J[model->ten_J_rowadr[t] + k];
      EXPECT_NEAR(m.leg_length * moment_arm(shape, q), arm, 1e-9);
      EXPECT_GT(std::abs(m.leg_length * actuator_length(shape, q + 0.1) - data->ten_length[t]),
                1e-6);  // negative control
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Robots, Shapes, testing::Values("piston_puppy", "crooked_piston"));

TEST(LinearActuators, ShapeHasExactDerivatives) {
  const RobotModel robot = parse_robot(test::named_robot("crooked_piston"), "p");
  std::mt19937 random(4);
  const VectorXd s = test::random_design(robot.space, random);
  for (const LinearActuator& actuator : robot.morphology.linear_actuators) {
    const ActuatorShape at = actuator_shape(robot.morphology, actuator, s);
    ASSERT_GE(at.parameters.size(), 3u);
    EXPECT_GT(at.jacobian.norm(), 0.1);
    for (std::size_t k = 0; k < at.parameters.size(); ++k) {
      VectorXd up = s, down = s;
      up[at.parameters[k]] += 1e-5;
      down[at.parameters[k]] -= 1e-5;
      const ActuatorShape a = actuator_shape(robot.morphology, actuator, up),
                          b = actuator_shape(robot.morphology, actuator, down);
      const int column = static_cast<int>(k);
      EXPECT_LT(((a.value - b.value) / 2e-5 - at.jacobian.col(column)).norm(), 1e-8);
      for (int i = 0; i < 3; ++i)
        EXPECT_LT(
            ((a.jacobian.row(i) - b.jacobian.row(i)).transpose() / 2e-5 - at.hessian[i].col(column))
                .norm(),
            1e-7);
    }
  }
}

TEST(LinearActuators, TiesScaleAndMirror) {
  const RobotModel robot = parse_robot(test::named_robot("crooked_piston"), "p");
  VectorXd s = robot.space.initial();
  const int z = robot.space.find("end_z"), y = robot.space.find("end_y");
  ASSERT_GE(z, 0);
  s[z] = -0.06;
  s[y] = 0.012;
  const std::string text = rewrite_robot(robot, s);
  EXPECT_NE(text.find("<site name=\"knee_foot\" pos=\"0.03 -0.012 -0.06\"/>"), std::string::npos);
  EXPECT_NE(text.find("<site name=\"other_foot\" pos=\"0.01 0.02 -0.12\"/>"), std::string::npos);
}

/// A scaled tie: the second body has 0.8 times the number, and keeps that share.
TEST(LinearActuators, ScaledLengthKeepsItsShare) {
  std::string xml = test::named_robot("puppy");
  xml = test::with(xml, "m | stretch link: FL_thigh FR_thigh |",
                   "m | stretch link: FL_thigh FR_thigh 0.75*FL_shank |");
  EXPECT_THROW(parse_robot(xml, "p"), InputError);  // already stretched by another number
  xml = test::with(xml, "m | stretch link: FL_shank FR_shank |", "m | stretch link: FR_shank |");
  EXPECT_NO_THROW(
      parse_robot(test::with(xml, "0.75*FL_shank", "1.3333333333333333*FL_shank"), "p"));
  try {
    parse_robot(xml, "p");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("divided by 0.75"), std::string::npos) << error.what();
  }
  const RobotModel robot =
      parse_robot(test::with(xml, "0.75*FL_shank", "1.3333333333333333*FL_shank"), "p");
  VectorXd s = robot.space.initial();
  s[0] = 0.09;
  const RobotModel grown = parse_robot(rewrite_robot(robot, s), "grown");
  const Eigen::Vector3d ankle = grown.morphology.links[3].origin.at(grown.space.initial());
  EXPECT_NEAR(ankle.z(), -0.12, 1e-12);
}

/// Equal bounds freeze a parameter: it stays in s and in the file.
TEST(LinearActuators, EqualBoundsFreeze) {
  const std::string xml = test::with(test::named_robot("puppy"), "data=\"0.14 0.112 0.182\"",
                                     "data=\"0.14 0.14 0.14\"");
  const RobotModel robot = parse_robot(xml, "p");
  EXPECT_TRUE(robot.space.parameters[18].frozen());
  EXPECT_FALSE(robot.space.parameters[19].frozen());
  EXPECT_EQ(robot.space.size(), 20);
}

struct Fault {
  const char *old_part, *new_part, *message;
};

TEST(LinearActuators, OneWithoutMomentArmIsRefused) {
  std::string xml = test::named_robot("crooked_piston");
  xml = test::with(xml, "name=\"knee_top\" pos=\"0.06 0.01 -0.08\"",
                   "name=\"knee_top\" pos=\"0.05 0.03 -0.198\"");  // on the hinge
  try {
    parse_robot(xml, "p");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no moment arm"), std::string::npos) << error.what();
  }
}

TEST(LinearActuators, FaultsAreRefused) {
  const std::string good = test::named_robot("piston_puppy");
  const std::vector<Fault> faults = {
      {"<site site=\"FL_piston_foot\"/>", "<site site=\"FR_piston_foot\"/>", "exactly one hinge"},
      {"<site name=\"FL_piston_foot\" pos=\"0.015 0 -0.035\"/>",
       "<site name=\"FL_piston_foot\" pos=\"0.015 0 -0.135\"/>", "declares"},
      {"<site name=\"FL_piston_top\" pos=\"0.02 0 -0.01\"/>",
       "<site name=\"FL_piston_top\" pos=\"0 0 -0.06\"/>", "declares"},
      {"<position class=\"piston\" name=\"FL_piston\" tendon=\"FL_piston\"/>",
       "<position name=\"FL_knee_servo\" joint=\"FL_knee\"/>", "has no actuator"},
      {"place x: FL_piston_top", "place x: FL_piston_tip", "not in the model"},
      {"place x: FL_piston_top ~FR", "place w: FL_piston_top ~FR", "direction 'w' is unknown"},
      {"place x: FL_piston_top", "place x: 0*FL_piston_top", "expected a factor"},
      {"place x: FL_piston_top", "place x: FL_piston_top FL_piston_top", "twice"},
      {"place y: FL_piston_top", "place x: FL_piston_top", "declares"},
  };
  EXPECT_NO_THROW(parse_robot(good, "good"));
  for (const Fault& fault : faults) {
    try {
      parse_robot(test::with(good, fault.old_part, fault.new_part), "bad.xml");
      ADD_FAILURE() << fault.new_part << " was accepted";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(fault.message), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace legwright
