// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/read_robot.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <new>
#include <numbers>
#include <thread>

#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/robots/point_mass_robot.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

TEST(ReadRobot, ReadsThePuppy) {
  const RobotModel robot = read_robot(test::puppy_file());
  const Morphology& m = robot.morphology;
  EXPECT_EQ(m.name, "puppy");
  EXPECT_EQ(robot.root_body, "trunk");
  ASSERT_EQ(m.links.size(), 13u);
  EXPECT_EQ(m.joint_count(), 12);
  ASSERT_EQ(m.foot_count(), 4);
  EXPECT_NEAR(m.total_mass(), 2.376, 1e-12);
  EXPECT_NEAR(m.leg_length, 0.21, 1e-12);
  const char* const names[] = {"FL", "FR", "HL", "HR"};
  for (int j = 0; j < 4; ++j) {
    EXPECT_EQ(m.feet[j].name, names[j]);
    EXPECT_EQ(m.feet[j].radius, 0.012);
    EXPECT_EQ(m.feet[j].link, 3 * j + 3);
    EXPECT_EQ(m.chain_to(m.feet[j].link), (std::vector<int>{3 * j + 1, 3 * j + 2, 3 * j + 3}));
    EXPECT_EQ(m.links[3 * j + 1].joint.name, std::string(names[j]) + "_hip");
  }
  EXPECT_EQ(m.nominal_joints().head<3>(), Vector3d(0.5, -1.0, 0.6));
  EXPECT_EQ(m.links[5].joint.lower, -2.6);
  EXPECT_EQ(m.links[5].joint.armature, 0.0005);
  EXPECT_EQ(m.links[5].joint.torque_limit, 3.0);
  ASSERT_EQ(robot.servos.size(), 12u);
  EXPECT_EQ(robot.servos[4].actuator, "FR_knee_servo");
  EXPECT_EQ(robot.servos[4].joint, m.links[5].joint.name);
  EXPECT_EQ(robot.servos[4].kp, 80.0);
  EXPECT_EQ(robot.servos[4].kd, 0.8);
}

TEST(ReadRobot, ReadsTheParametersOfThePuppy) {
  const RobotModel robot = read_robot(test::puppy_file());
  ASSERT_EQ(robot.space.size(), 20);
  ASSERT_EQ(robot.bindings.size(), 20u);
  const DesignParameter& thigh = robot.space.parameters[0];
  EXPECT_EQ(thigh.name, "front_thigh_length");
  EXPECT_EQ(thigh.unit, "m");
  EXPECT_EQ(thigh.kind, ParameterKind::length);
  EXPECT_EQ(thigh.initial, 0.06);
  EXPECT_EQ(thigh.lower, 0.036);
  EXPECT_EQ(thigh.upper, 0.096);
  EXPECT_EQ(thigh.tied_count, 2);
  EXPECT_EQ(thigh.sentence, "Length of the front legs from hip to knee.");
  EXPECT_EQ(robot.bindings[0].direction, Vector3d(0, 0, -1));
  const DesignParameter& yaw = robot.space.parameters[6];
  EXPECT_EQ(yaw.name, "front_hip_axis_yaw");
  EXPECT_EQ(yaw.kind, ParameterKind::axis_angle);
  EXPECT_FALSE(robot.bindings[6].targets[0].mirror);
  EXPECT_TRUE(robot.bindings[6].targets[1].mirror);
  EXPECT_EQ(robot.bindings[6].targets[1].name, "FR_hip");
  EXPECT_EQ(robot.bindings[6].targets[1].direction, Vector3d(0, 0, -1));
}

TEST(ReadRobot, ReadsASentenceThatMujocoWroteAsCdata) {
  const std::string sentence = "Length of the front legs from hip to knee.";
  const std::string xml = test::example_robot("puppy");
  const std::size_t said = xml.find(sentence), from = xml.rfind("data=\"", said) + 6,
                    to = xml.find("\"/>", said);
  const std::string data = xml.substr(from, said - from) + "The thigh's length & <more>.";
  const auto with_content = [&](const std::string& content) {
    return xml.substr(0, from - 6) + content + xml.substr(to + 3);
  };
  const RobotModel robot =
      parse_robot(with_content(">\n<!-- - --><![CDATA[" + data + "]]></text>"), "r.xml");
  EXPECT_EQ(robot.space.parameters[0].sentence, "The thigh's length & <more>.");
  EXPECT_EQ(robot.space.parameters[0].tied_count, 2);
  // As in MuJoCo, plain content says nothing.
  EXPECT_THROW((void)parse_robot(with_content(">m | stretch link: x | y</text>"), "r.xml"),
               InputError);
}

TEST(ReadRobot, MirroredAxesStayMirrorImages) {
  const RobotModel robot = read_robot(test::puppy_file());
  std::mt19937 random(1);
  const VectorXd s = test::random_design(robot.space, random);
  for (int l = 1; l <= 3; ++l) {
    const Vector3d left = robot.morphology.links[l].joint.axis.at(s),
                   right = robot.morphology.links[l + 3].joint.axis.at(s);
    EXPECT_NEAR((left - Vector3d(-right.x(), right.y(), -right.z())).norm(), 0.0, 1e-12);
    EXPECT_GT(std::abs(left.x()) + std::abs(left.z()), 0.01);
  }
}

class MatchesMujoco : public testing::TestWithParam<const char*> {};

TEST_P(MatchesMujoco, AtRandomPosesAndVelocities) {
  const std::string xml = test::named_robot(GetParam());
  const RobotModel robot = parse_robot(xml, GetParam());
  const test::MujocoRobot engine(xml);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-2, 2);
  for (int trial = 0; trial < 50; ++trial) {
    VectorXd qpos(engine.nq()), qvel(engine.nv());
    for (double& x : qpos) x = uniform(random);
    for (double& x : qvel) x = uniform(random);
    qpos.segment<4>(3).normalize();
    const VectorXd s = robot.space.initial();
    const test::RobotState reference = engine.state(robot.morphology, qpos, qvel);
    EXPECT_LT(test::difference(reference, test::state_of(robot.morphology, s, qpos, qvel)), 1e-9);
    if (s.size() == 0) continue;
    VectorXd off = s;  // negative control
    off[0] *= 1.001;
    EXPECT_GT(test::difference(reference, test::state_of(robot.morphology, off, qpos, qvel)), 1e-7);
  }
}
INSTANTIATE_TEST_SUITE_P(Robots, MatchesMujoco,
                         testing::Values("puppy", "crooked", "piston_puppy", "crooked_piston",
                                         "crooked_printed", "crooked_weighed"));

TEST(ReadRobot, ReadsGeneralTrees) {
  const RobotModel robot = parse_robot(test::crooked_robot(), "crooked");
  const Morphology& m = robot.morphology;
  ASSERT_EQ(m.links.size(), 5u);
  EXPECT_EQ(m.links[1].name, "swing");  // first hinge of a body with two
  EXPECT_EQ(m.links[2].name, "upper");
  EXPECT_EQ(m.links[2].parent, 1);
  EXPECT_EQ(m.links[4].parent, 0);
  EXPECT_TRUE(m.links[1].masses.empty());
  EXPECT_EQ(m.links[0].masses.size(), 12u);  // trunk and bracket
  EXPECT_NEAR(m.links[2].joint.upper, 2 * std::numbers::pi / 3, 1e-12);
  EXPECT_TRUE(std::isinf(m.links[3].joint.upper));
  // motor: limit by ctrlrange × gain × gear; gains follow from the limit.
  EXPECT_EQ(robot.servos[0].actuator, "swing");
  EXPECT_NEAR(robot.servos[0].torque_limit, 3.0, 1e-12);
  EXPECT_NEAR(robot.servos[0].kp, 80.0, 1e-9);
  EXPECT_NEAR(robot.servos[0].kd, 0.015 * robot.servos[0].kp, 1e-9);
  EXPECT_EQ(robot.servos[1].torque_limit, 4.0);  // the smaller side
  EXPECT_NEAR(robot.servos[2].kp, 180.0, 1e-9);  // gear² × 20
  EXPECT_TRUE(std::isinf(robot.servos[2].torque_limit));
}

/// Controls are counted apart from actuators: a <pid> has three here.
TEST(ReadRobot, ReadsTheLimitOfAMotorBehindAServoOfSeveralControls) {
  const std::string text =
      test::read_file(test::source_path("examples/broken/robots/motor_without_limit.xml"));
  const std::string mended =
      test::with(test::with(text, "<position name=\"hip_servo\"",
                            "<pid input=\"pos vel ff\" gear=\"1\" name=\"hip_servo\""),
                 "<motor ", "<motor gear=\"2\" ctrlrange=\"-1.5 1.5\" ");
  const RobotModel robot = parse_robot(mended, "pid.xml");
  ASSERT_EQ(robot.servos.size(), 2u);
  EXPECT_EQ(robot.servos[0].kp, 80.0);
  EXPECT_EQ(robot.servos[0].kd, 0.8);
  EXPECT_EQ(robot.servos[0].torque_limit, 3.0);
  EXPECT_EQ(robot.servos[1].torque_limit, 3.0);
  EXPECT_NEAR(robot.servos[1].kp, 80.0, 1e-9);
}

TEST(ReadRobot, AsksForTheLimitOfAMotorBeforeItsGear) {
  const std::string text =
      test::read_file(test::source_path("examples/broken/robots/motor_without_limit.xml"));
  try {
    (void)parse_robot(test::with(text, "<motor ", "<motor gear=\"9\" "), "geared.xml");
    FAIL() << "no limit was asked for";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("before its gear of 9: the joint's limit divided"),
              std::string::npos)
        << error.what();
  }
}

TEST(ReadRobot, KeepsAServoWithoutDamping) {
  const std::string puppy = test::read_file(test::puppy_file());
  EXPECT_EQ(parse_robot(test::with(puppy, "kv=\"0.8\"", "kv=\"0\""), "p").servos[0].kd, 0.0);
  EXPECT_EQ(parse_robot(test::with(puppy, " kv=\"0.8\"", ""), "p").servos[0].kd, 0.0);
}

TEST(ReadRobot, TakesOrdinaryGravityAndOtherFlags) {
  const std::string puppy = test::read_file(test::puppy_file());
  EXPECT_NO_THROW(parse_robot(
      test::with(puppy, "<default>",
                 "<option gravity=\"0 0 -9.81\"><flag frictionloss=\"enable\"/></option><default>"),
      "p"));
}

/// The eyes are for pictures: they ride on the round front edge and weigh nothing.
TEST(ReadRobot, EyesOfThePuppyStayInFrontAtAllLengths) {
  const RobotModel robot = read_robot(test::puppy_file());
  for (const bool longest : {false, true}) {
    VectorXd s = robot.space.initial();
    s[19] = longest ? robot.space.parameters[19].upper : robot.space.parameters[19].lower;
    ASSERT_EQ(robot.space.parameters[19].name, "body_length");
    const ModelPointer model = compile_mjcf(rewrite_robot(robot, s), "p");
    const int eyes = mj_name2id(model.get(), mjOBJ_BODY, "eyes");
    ASSERT_GT(eyes, 0);
    EXPECT_EQ(model->body_mass[eyes], 0.0);
    const int ball = model->body_geomadr[eyes];
    // The front edge: a capsule of radius 0.025 m whose axis is 0.095 / 0.24 of the length ahead.
    const double rim = 0.095 / 0.24 * s[19];
    const double x = model->body_pos[3 * eyes] + model->geom_pos[3 * ball] - rim;
    EXPECT_NEAR(model->body_pos[3 * eyes], rim, 1e-12);
    EXPECT_GT(std::hypot(x, model->geom_pos[3 * ball + 2]) + model->geom_size[3 * ball],
              0.025 + 0.003);
  }
}

/// Engine errors of this thread are faults of the file; messages of others are not our business.
std::atomic<int> g_heard{0};
void hear(const mjLogMessage*) { ++g_heard; }

TEST(CallEngine, TurnsErrorsIntoInputErrorsAndLeavesOtherThreadsAlone) {
  const mjfLogHandler before = mju_setLogHandler(hear);
  call_engine("robot.xml", [] {
    mju_warning("mine");
    std::thread([] { mju_warning("of another thread"); }).join();
  });
  EXPECT_EQ(g_heard, 1);
  try {
    call_engine("robot.xml", [] { mju_error("on line 7 it broke"); });
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("robot.xml:7: MuJoCo: ", 0), 0u) << error.what();
  }
  mju_warning("after");
  EXPECT_EQ(g_heard, 2);
  EXPECT_EQ(mju_setLogHandler(before), hear);
}

/// While it lives, MuJoCo's own allocations fail.
class NoMemoryForMujoco {
 public:
  NoMemoryForMujoco() : before_(mju_user_malloc) {
    mju_user_malloc = [](std::size_t) -> void* { return nullptr; };
  }
  ~NoMemoryForMujoco() { mju_user_malloc = before_; }
  NoMemoryForMujoco(const NoMemoryForMujoco&) = delete;
  NoMemoryForMujoco& operator=(const NoMemoryForMujoco&) = delete;

 private:
  void* (*before_)(std::size_t);
};

TEST(CallEngine, DoesNotBlameTheFileForWantOfMemory) {
  const std::string xml = "<mujoco><worldbody><geom size='1'/></worldbody></mujoco>";
  const ModelPointer model = compile_mjcf(xml, "first.xml");
  {
    const NoMemoryForMujoco none;
    EXPECT_THROW(compile_mjcf(xml, "other.xml"), std::bad_alloc);
    EXPECT_THROW(compile_mjcf(xml, "first.xml"), std::bad_alloc) << "a copy of what is known";
    EXPECT_THROW(kinematics_at(*model, nullptr, "first.xml"), std::bad_alloc);
  }
  EXPECT_NE(compile_mjcf(xml, "other.xml"), nullptr);
}

TEST(CallEngine, DoesNotTakeANameOfTheFileForWantOfMemory) {
  const std::string xml =
      "<mujoco><worldbody><geom size='1' class='could not allocate'/></worldbody></mujoco>";
  EXPECT_THROW(compile_mjcf(xml, "robot.xml"), InputError);
}

TEST(ReadRobot, TextAndFileGiveTheSame) {
  const RobotModel a = read_robot(test::puppy_file());
  const RobotModel b = parse_robot(a.xml, "elsewhere.xml");
  EXPECT_EQ(a.xml, test::read_file(test::puppy_file()));
  EXPECT_EQ(b.file, "elsewhere.xml");
  EXPECT_EQ(a.morphology.total_mass(), b.morphology.total_mass());
  EXPECT_EQ(a.space.initial(), b.space.initial());
}

TEST(ReadRobot, NeedsNoParameters) {
  std::string xml = test::read_file(test::puppy_file());
  xml = xml.substr(0, xml.find("  <custom>")) + "</mujoco>\n";
  EXPECT_EQ(parse_robot(xml, "plain.xml").space.size(), 0);
}

TEST(ReadRobot, ScalingAnAxisChangesNothing) {
  const RobotModel a = read_robot(test::puppy_file());
  const RobotModel b = parse_robot(
      test::with(a.xml, "\"FL_knee\" axis=\"0 1 0\"", "\"FL_knee\" axis=\"0 7.5 0\""), "b");
  EXPECT_LT(
      (a.morphology.links[2].joint.axis.reference - b.morphology.links[2].joint.axis.reference)
          .norm(),
      1e-12);
}

TEST(ReadRobot, RefusesWhatIsNoFile) {
  try {
    read_robot("no/such/robot.xml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "no/such/robot.xml: no such file; check the path of the robot");
  }
  EXPECT_THROW(read_robot("/"), InputError);
  EXPECT_THROW(read_robot("/dev/zero"), InputError);
}

TEST(ReadRobot, WritesNoLogAndStaysQuiet) {
  const std::filesystem::path before = std::filesystem::current_path();
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / "legwright_mjcf_quiet";
  std::filesystem::create_directories(folder);
  std::filesystem::current_path(folder);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EXPECT_THROW(
      parse_robot(test::with(test::crooked_robot(), "<freejoint/>", "<freejoint/><wheel/>"), "x"),
      InputError);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  std::filesystem::current_path(before);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace legwright
