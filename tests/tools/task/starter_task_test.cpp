// SPDX-License-Identifier: Apache-2.0
// The first task that `legwright init --task` writes: few numbers, by the robot's size, and every
// one of them is accepted.
#include "tools/task/starter_task.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mjcf/text/input_error.hpp"
#include "optimizer/motion/initial_guess.hpp"
#include "tests/support/source_tree.hpp"
#include "tools/task/task_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::kSource;

RobotModel robot(const std::string& name) {
  return read_robot(kSource / "tests/robots" / name / "robot.xml");
}

TEST(StarterTask, IsATaskForEachOfTheRobots) {
  for (const char* name : {"courser", "goat", "mule", "ox", "servo_dog", "strider", "octopod"}) {
    const RobotModel model = robot(name);
    const StarterTask starter = starter_task(model, std::nullopt);
    const std::string text = starter_text(starter, "robot.xml");
    const TaskFile file = parse_task_file(text, kSource / "tests/robots" / name / "task.toml");
    const int feet = model.morphology.foot_count();
    EXPECT_EQ(file.gait, feet == 8 ? "tetrapod" : feet == 6 ? "tripod" : "trot");
    EXPECT_TRUE(file.weights.empty()) << name;
    EXPECT_FALSE(file.margins.swing_height) << name;
    EXPECT_NEAR(file.period, starter.period, 0.06 * starter.period) << "two digits";
    const Task task = make_task(file, model);
    const std::vector<std::string> warnings = task_warnings(task, model);
    ASSERT_EQ(warnings.size(), 1u) << name;
    EXPECT_NE(warnings[0].find("declares no design parameters"), std::string::npos)
        << "before init --write";
    EXPECT_GT(task.velocity.x(), 0.0);
  }
}

TEST(StarterTask, FollowsTheRobotsHeight) {
  const StarterTask small = starter_task(robot("servo_dog"), std::nullopt);
  const StarterTask large = starter_task(robot("ox"), std::nullopt);
  EXPECT_EQ(small.duty, 0.6);
  EXPECT_EQ(large.duty, 0.6);
  EXPECT_GT(large.period, 1.8 * small.period);
  EXPECT_NEAR(large.period / small.period, large.speed / small.speed,
              1e-9);  // both go with the root of the height
}

/// Motors of 2 N m that joints damp with 4 N m s/rad turn them at 0.5 rad/s.
TEST(StarterTask, JointsThatDampMuchAreGivenTime) {
  RobotModel model = robot("servo_dog");
  const StarterTask usual = starter_task(model, std::nullopt);
  EXPECT_FALSE(usual.slowed);
  for (Link& link : model.morphology.links) link.joint.damping = 4.0;
  const StarterTask slow = starter_task(model, std::nullopt);
  EXPECT_TRUE(slow.slowed);
  EXPECT_GT(slow.period, 3.0 * usual.period);
  EXPECT_LT(slow.speed, 0.2 * usual.speed);
  const auto told = [&](const StarterTask& task) {
    const TaskFile file = parse_task_file(starter_text(task, "robot.xml"),
                                          kSource / "tests/robots/servo_dog/task.toml");
    int found = 0;
    for (const std::string& warning : task_warnings(make_task(file, model), model))
      found += warning.starts_with("damping leaves joints slower");
    return found;
  };
  EXPECT_EQ(told(slow), 0);
  EXPECT_EQ(told(usual), 1);
}

TEST(StarterTask, ATallTrunkDoesNotHurryShortLegs) {
  RobotModel model = robot("servo_dog");
  const double usual = starter_task(model, std::nullopt).speed;
  model.morphology.leg_length *= 0.3;
  const StarterTask task = starter_task(model, std::nullopt);
  EXPECT_LT(task.speed, usual);
  EXPECT_NEAR(task.speed * 0.6 * task.period, 0.8 * model.morphology.leg_length, 1e-9);
}

TEST(StarterTask, PlaysServosThatGiveInStiffer) {
  RobotModel model = robot("servo_dog");
  const ServoSag firm = starter_task(model, std::nullopt).sag;
  EXPECT_FALSE(firm.soft());
  EXPECT_EQ(starter_text(starter_task(model, std::nullopt), "robot.xml").find("[servos]"),
            std::string::npos);
  for (Servo& servo : model.servos) servo.kp /= 20.0;
  const StarterTask starter = starter_task(model, std::nullopt);
  ASSERT_TRUE(starter.sag.soft());
  EXPECT_NEAR(starter.sag.angle, 20.0 * firm.angle, 1e-12);
  EXPECT_EQ(starter.sag.joint, firm.joint);
  const fs::path place = kSource / "tests/robots/servo_dog/task.toml";
  const std::string text = starter_text(starter, "robot.xml");
  const Task task = make_task(parse_task_file(text, place), model);
  ASSERT_TRUE(task.servo_kp) << text;
  EXPECT_EQ(task.servo_kp, starter.sag.stiff_kp());
  EXPECT_EQ(task_warnings(task, model).size(), 1u) << "only that it declares no parameters";
  // A task of one's own that says nothing of servos is warned of instead.
  const std::string bare = text.substr(0, text.find("[servos]"));
  const std::vector<std::string> warnings =
      task_warnings(make_task(parse_task_file(bare, place), model), model);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_NE(warnings[0].find("soft servos: standing alone bends joint '" + firm.joint),
            std::string::npos)
      << warnings[0];
}

TEST(StarterTask, WeakMotorsAreReportedInsteadOfPlayedStiffer) {
  RobotModel model = robot("servo_dog");
  const double load = starter_task(model, std::nullopt).sag.load;
  for (Servo& servo : model.servos) {
    servo.torque_limit = 1.2 * load;
    servo.kp = servo.torque_limit / kFullTorqueError;  // as a motor without gains has it
  }
  const StarterTask starter = starter_task(model, std::nullopt);
  EXPECT_TRUE(starter.sag.soft());
  const std::string text = starter_text(starter, "robot.xml");
  EXPECT_EQ(text.find("[servos]"), std::string::npos) << text;
  const Task task =
      make_task(parse_task_file(text, kSource / "tests/robots/servo_dog/t.toml"), model);
  const std::vector<std::string> warnings = task_warnings(task, model);
  ASSERT_FALSE(warnings.empty());
  EXPECT_NE(warnings[0].find("weak motors: standing alone takes"), std::string::npos)
      << warnings[0];
}

TEST(StarterTask, MotorsThatCannotHoldTheRobotAreTold) {
  RobotModel model = robot("servo_dog");
  const StandingLoad strong = servo_sag(model).hardest;
  EXPECT_TRUE(strong.holds());
  EXPECT_EQ(weak_motors_text(strong), "");
  for (Servo& servo : model.servos) servo.torque_limit = 0.5 * strong.load;
  const StandingLoad weak = servo_sag(model).hardest;
  EXPECT_FALSE(weak.holds());
  EXPECT_EQ(weak.joint, strong.joint);
  const Task task =
      make_task(parse_task_file(starter_text(starter_task(model, std::nullopt), "robot.xml"),
                                kSource / "tests/robots/servo_dog/t.toml"),
                model);
  const std::vector<std::string> warnings = task_warnings(task, model);
  ASSERT_FALSE(warnings.empty());
  EXPECT_EQ(warnings[0], weak_motors_text(weak)) << "nothing of how far servos bend";
  EXPECT_NE(warnings[0].find("too weak to stand"), std::string::npos) << warnings[0];
}

TEST(StarterTask, ShortSwingsHaveKnotsEnough) {
  const RobotModel strider = robot("strider");
  EXPECT_FALSE(starter_task(strider, "tripod").knots);
  const StarterTask wave = starter_task(strider, "wave");
  ASSERT_TRUE(wave.knots);
  const TaskFile file =
      parse_task_file(starter_text(wave, "robot.xml"), kSource / "tests/robots/strider/t.toml");
  EXPECT_EQ(file.knots, *wave.knots);
  for (const std::string& warning : task_warnings(make_task(file, strider), strider))
    EXPECT_EQ(warning.find("fewer than three knots"), std::string::npos) << warning;
}

TEST(StarterTask, AStiffServoSagsByLessThanWhatIsSoft) {
  ServoSag sag{"knee", 0.05, 90.0, 4.5, 23.0, 4.5};
  EXPECT_TRUE(sag.can_be_stiffer());
  sag.limit = 0.0375 * 90.0;
  EXPECT_FALSE(sag.can_be_stiffer()) << "as stiff as its torque limit bears";
  EXPECT_EQ(sag.stiff_kp(), 450.0);
  sag.torque = 4.51;
  EXPECT_EQ(sag.stiff_kp(), 460.0) << "two digits, rounded up";
  sag.torque = 123.0;
  EXPECT_EQ(sag.stiff_kp(), 13000.0);
  sag.torque = 0.0115;
  EXPECT_EQ(sag.stiff_kp(), 1.2) << "no digits of dust";
}

TEST(StarterTask, TakesAnotherGaitAndRefusesOneThatThereIsNot) {
  const RobotModel model = robot("servo_dog");
  const StarterTask walk = starter_task(model, "walk");
  EXPECT_EQ(walk.gait, "walk");
  EXPECT_FALSE(walk.duty);
  EXPECT_GT(walk.period, 1.8 * starter_task(model, "trot").period);
  EXPECT_LT(starter_task(model, "pronk").duty.value_or(0.5), 0.55) << "a flight stays a flight";
  try {
    starter_task(model, "tripod");
    FAIL() << "four feet have no tripod";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("'tripod' is not in the library for 4 feet"),
              std::string::npos)
        << error.what();
  }
}

TEST(StarterTask, ListsTheGaitsOfEightFeet) {
  const RobotModel model = robot("octopod");
  EXPECT_EQ(starter_task(model, "wave").gait, "wave");
  try {
    starter_task(model, "tripod");
    FAIL() << "eight feet have no tripod";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("for 8 feet"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("there are tetrapod, ripple, wave"), std::string::npos)
        << error.what();
  }
}

TEST(StarterTask, IsLivelierWhereThreeOrFourFeetStandAtATime) {
  const auto froude = [](const RobotModel& model, const StarterTask& task) {
    const double height = home_stance(model.morphology, model.space.initial()).com_height;
    return task.speed / std::sqrt(kGravity * height);
  };
  for (const char* name : {"strider", "octopod"}) {
    const RobotModel model = robot(name);
    EXPECT_NEAR(froude(model, starter_task(model, std::nullopt)), 0.25, 1e-12) << name;
    EXPECT_NEAR(froude(model, starter_task(model, "wave")), 0.15, 1e-12) << name;
  }
  const RobotModel dog = robot("servo_dog");
  EXPECT_NEAR(froude(dog, starter_task(dog, std::nullopt)), 0.15, 1e-12);
}

TEST(StarterTask, TellsHowToDeclareAGaitThatTheLibraryLacks) {
  const std::string three = no_gait_text(3);
  EXPECT_NE(three.find("no gait for a robot of 3 feet"), std::string::npos) << three;
  EXPECT_NE(three.find("touchdown = [0, 0.33, 0.67]"), std::string::npos) << three;
  EXPECT_NE(three.find("duty = 0.83"), std::string::npos) << three;
  for (const int feet : gait_library_feet()) EXPECT_EQ(no_gait_text(feet), "") << feet;
}

TEST(StarterTask, QuotesTheRobotsName) {
  const std::string text =
      starter_text({"trot", 0.5, {}, 0.3, {1.0, 0.0}, {}, {}, {}, {}}, "a \"b\\c.xml");
  EXPECT_NE(text.find(R"(robot = "a \"b\\c.xml")"), std::string::npos) << text;
  EXPECT_EQ(text.find("duty"), std::string::npos);
}

}  // namespace
}  // namespace legwright
