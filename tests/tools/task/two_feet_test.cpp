// SPDX-License-Identifier: Apache-2.0
// What keeps robots on two feet upright, in numbers; their first tasks, and what tasks are warned
// of.
#include "tools/task/two_feet.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "optimizer/motion/initial_guess.hpp"
#include "tests/mjcf/robots/flat_biped.hpp"
#include "tests/mjcf/robots/turned_biped.hpp"
#include "tests/support/source_tree.hpp"
#include "tools/task/starter_task.hpp"
#include "tools/task/task_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using Kind = TwoFeet::Kind;
using test::kSource;
constexpr double kMass = 18.4;  // of flat_biped() [kg]

RobotModel biped(const test::FlatBiped& how) { return parse_robot(test::flat_biped(how), "r.xml"); }

/// Servos that hold it, and motors that bear them.
test::FlatBiped firm() {
  test::FlatBiped how;
  how.kp = 1000.0;
  how.kd = 40.0;
  return how;
}

Task task_of(const std::string& text, const RobotModel& robot) {
  return make_task(parse_task_file(text, kSource / "tests/robots/servo_dog/task.toml"), robot);
}

std::string walking(const std::string& more = "") {
  return "robot = \"robot.xml\"\n[gait]\nname = \"walk\"\nperiod = 1.0\n[travel]\nvelocity = [0.1, "
         "0.0]\n" +
         more;
}

/// Whether one of the warnings begins so.
bool warns(const std::vector<std::string>& warnings, const std::string& beginning) {
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const std::string& warning) { return warning.rfind(beginning, 0) == 0; });
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(TwoFeet, AreFlatOrRoundOrNeither) {
  EXPECT_EQ(two_feet(biped({})).kind, Kind::flat);
  EXPECT_EQ(two_feet(read_robot(kSource / "examples/biped/robot.xml")).kind, Kind::round);
  EXPECT_EQ(two_feet(parse_robot(test::turned_biped({}), "r.xml")).kind, Kind::neither);
  EXPECT_EQ(two_feet(read_robot(kSource / "tests/robots/servo_dog/robot.xml")).kind, Kind::no);
  test::FlatBiped how;
  for (const char* foot : {"ball", "bar", "two_balls"}) {
    how.foot = test::foot_geoms(foot);
    EXPECT_EQ(two_feet(biped(how)).kind, Kind::neither) << foot;
  }
  how = {};
  how.ankle_roll = false;
  EXPECT_EQ(two_feet(biped(how)).kind, Kind::neither) << "nothing lays the sole down";
}

TEST(TwoFeet, ToppleOverTheirAnkles) {
  const RobotModel robot = biped({});
  const TwoFeet feet = two_feet(robot);
  EXPECT_NEAR(feet.height, home_stance(robot.morphology, robot.space.initial()).com_height, 1e-12);
  EXPECT_GT(feet.height, 0.4);
  EXPECT_LT(feet.height, 0.6);
  EXPECT_NEAR(feet.toppling, kMass * 9.81 * feet.height, 1e-9);
  const double kp = feet.upright_kp() / (8.0 * feet.toppling);
  EXPECT_GE(kp, 1.0 - 1e-9);
  EXPECT_LT(kp, 1.1) << "two digits";
  const double swing = std::sqrt(feet.height / 9.81),
               kd = feet.upright_kd() / (4.0 / 3.0 * feet.toppling * swing);
  EXPECT_GE(kd, 1.0 - 1e-9);
  EXPECT_LT(kd, 1.1);
  Task heavier;
  heavier.payload = Payload{4.0, {0.0, 0.0, 0.1}, {0.1, 0.1, 0.1}};
  EXPECT_GT(two_feet(robot, heavier).toppling, feet.toppling + 4.0 * 9.81 * feet.height);
}

TEST(TwoFeet, HaveAnklesThatTheServosHold) {
  const TwoFeet firm_ones = two_feet(biped(firm()));
  EXPECT_FALSE(firm_ones.soft());
  EXPECT_FALSE(firm_ones.is_underdamped());
  EXPECT_EQ(firm_ones.why_it_falls(), "");
  test::FlatBiped how = firm();
  how.kp = 2.1 * firm_ones.toppling;
  EXPECT_TRUE(two_feet(biped(how)).soft());
  EXPECT_EQ(two_feet(biped(how)).why_it_falls(), "") << "a task can play it stiffer";
  how.kp = 2.2 * firm_ones.toppling;
  EXPECT_FALSE(two_feet(biped(how)).soft());
  const double critical = firm_ones.toppling * std::sqrt(firm_ones.height / 9.81);
  how.kd = 0.85 * critical;
  EXPECT_TRUE(two_feet(biped(how)).is_underdamped());
  how.kd = 0.95 * critical;
  EXPECT_FALSE(two_feet(biped(how)).is_underdamped());
}

/// The softest servo of the ankles counts, wherever the weakest motor is, also where motors have no
/// limits.
TEST(TwoFeet, AreAsSoftAsTheSoftestAnkle) {
  RobotModel robot = biped(firm());
  const auto servo = [&](const std::string& joint) -> Servo& {
    return *std::find_if(robot.servos.begin(), robot.servos.end(),
                         [&](const Servo& s) { return s.joint == joint; });
  };
  servo("left_knee").kp = 1.0;  // no ankle
  EXPECT_FALSE(two_feet(robot).soft());
  servo("right_ankle_roll").kp = 50.0;
  servo("left_ankle_pitch").torque_limit = 40.0;
  const TwoFeet feet = two_feet(robot);
  EXPECT_EQ(feet.kp, 50.0);
  EXPECT_TRUE(feet.soft());
  EXPECT_EQ(feet.ankle, "left_ankle_pitch");
  EXPECT_EQ(feet.limit, 40.0);
  for (Servo& one : robot.servos) {
    one.kp = 50.0;
    one.torque_limit = std::numeric_limits<double>::infinity();
  }
  EXPECT_TRUE(two_feet(robot).soft());
  EXPECT_TRUE(two_feet(robot).can_be_stiffer());
  EXPECT_TRUE(warns(task_warnings(task_of(walking(), robot), robot), "soft ankles"));
}

TEST(TwoFeet, TellHowMuchTheAnklesLack) {
  test::FlatBiped how;
  how.limit = 5.0;
  const TwoFeet weak = two_feet(biped(how));
  EXPECT_FALSE(weak.can_be_stiffer());
  how.kp = 120.0;  // what 5 N m bear is 133
  const TwoFeet feet = two_feet(biped(how));
  const std::string why = feet.why_it_falls();
  EXPECT_TRUE(holds(why, "weak ankles")) << why;
  const double wanted = 2.15 * kMass * 9.81 * feet.height;
  for (const std::string& part : {fmt::format("M g h = {:.3g} N m/rad", feet.toppling),
                                  std::string("joint 'left_ankle_pitch' has 5;"),
                                  fmt::format("takes motors of {:.3g} N m there", 0.0375 * wanted)})
    EXPECT_TRUE(holds(why, part)) << part << " in: " << why;
  how.limit = 1.001 * 0.0375 * wanted;  // what it was told to have
  EXPECT_EQ(two_feet(biped(how)).why_it_falls(), "");
  how.limit = 0.999 * 0.0375 * wanted;
  EXPECT_NE(two_feet(biped(how)).why_it_falls(), "");
  how.foot = test::foot_geoms("ball");
  EXPECT_TRUE(holds(two_feet(biped(how)).why_it_falls(), "two small feet"));
}

TEST(TwoFeet, TasksWithoutServosAreWarned) {
  test::FlatBiped how;
  how.kp = 100.0;
  how.kd = 5.0;
  const auto warnings = [&](const std::string& more) {
    const RobotModel robot = biped(how);
    return task_warnings(task_of(walking(more), robot), robot);
  };
  EXPECT_TRUE(warns(warnings(""), "soft ankles"));
  const TwoFeet feet = two_feet(biped(how));
  const std::string kp = fmt::format("[servos]\nkp = {}\n", feet.upright_kp());
  EXPECT_FALSE(warns(warnings(kp), "soft ankles"));
  EXPECT_TRUE(warns(warnings(kp + "kd = 1.0\n"), "little damping"));
  EXPECT_FALSE(warns(warnings(kp + fmt::format("kd = {}\n", feet.upright_kd())), "little damping"));
  how.limit = 5.0;
  EXPECT_TRUE(warns(warnings(kp), "weak ankles")) << "a motor bears no more";
}

// First tasks.

TEST(StarterTaskOnFlatFeet, IsSlowAndLowAndHoldsTheAnkles) {
  const RobotModel robot = biped({});
  const StarterTask starter = starter_task(robot, std::nullopt);
  const TwoFeet& feet = starter.two_feet;
  const std::string text = starter_text(starter, "robot.xml");
  const Task task = task_of(text, robot);
  EXPECT_EQ(task.gait.name(), "walk");
  EXPECT_EQ(task.gait.knot_count(), 28);
  EXPECT_NEAR(task.gait.period(), 4.65 * std::sqrt(feet.height / 9.81), 0.06);
  EXPECT_NEAR(task.velocity.x(), 0.06 * std::sqrt(9.81 * feet.height), 0.006);
  EXPECT_TRUE(holds(text, "[limits]\nswing_height = ")) << text;
  EXPECT_NEAR(task.swing_height.value_or(0.0), 0.045 * feet.height, 0.001);
  EXPECT_EQ(task.servo_kp, feet.upright_kp()) << text;
  EXPECT_EQ(task.servo_kd, feet.upright_kd()) << text;
  EXPECT_TRUE(holds(text, fmt::format("{:.3g} N m/rad", feet.toppling))) << text;
  const std::vector<std::string> warnings = task_warnings(task, robot);
  EXPECT_EQ(warnings.size(), 1u) << "only that it declares no parameters";
  EXPECT_EQ(no_task_text(robot), "");
}

TEST(StarterTaskOnFlatFeet, LeavesServosThatHold) {
  const RobotModel robot = biped(firm());
  const std::string text = starter_text(starter_task(robot, std::nullopt), "robot.xml");
  EXPECT_FALSE(holds(text, "[servos]")) << text;
  EXPECT_TRUE(holds(text, "swing_height")) << text;
}

TEST(StarterTaskOnFlatFeet, DoesNotSlowRoundOrPointedOnes) {
  const RobotModel round = read_robot(kSource / "examples/biped/robot.xml");
  const StarterTask starter = starter_task(round, std::nullopt);
  EXPECT_FALSE(starter.swing_height);
  EXPECT_FALSE(holds(starter_text(starter, "robot.xml"), "kd = "));
  EXPECT_EQ(no_task_text(round), "");
  test::FlatBiped how;
  how.foot = test::foot_geoms("ball");
  const std::string why = no_task_text(biped(how));
  EXPECT_TRUE(holds(why, "two small feet")) << why;
  EXPECT_TRUE(holds(why, "--gait walk")) << why;
  EXPECT_FALSE(starter_task(biped(how), "walk").swing_height);
  how = {};
  how.limit = 5.0;
  how.kp = 120.0;
  EXPECT_TRUE(holds(no_task_text(biped(how)), "weak ankles"));
}

TEST(MakeTaskOnFlatFeet, LetsTheComSwayUnlessTheTaskSaysHow) {
  const RobotModel robot = biped({});
  const Task own = task_of(walking(), robot);
  ASSERT_EQ(own.com_path.size(), static_cast<std::size_t>(own.gait.knot_count()));
  const double widest =
      std::max_element(own.com_path.begin(), own.com_path.end(), [](const auto& a, const auto& b) {
        return a.y() < b.y();
      })->y();
  EXPECT_GT(widest, 0.01);
  EXPECT_LT(widest, 0.09);
  const Task given = task_of(walking("[style]\ncom_path = [[0.0, 0.0]]\n"), robot);
  ASSERT_EQ(given.com_path.size(), 1u);
  EXPECT_EQ(given.com_path[0].norm(), 0.0);
  test::FlatBiped how;
  how.foot = test::foot_geoms("ball");
  const RobotModel pointed = biped(how);
  EXPECT_TRUE(task_of(walking(), pointed).com_path.empty());
}

}  // namespace
}  // namespace legwright
