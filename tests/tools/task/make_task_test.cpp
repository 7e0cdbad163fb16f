// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "mjcf/text/input_error.hpp"
#include "tests/support/source_tree.hpp"
#include "tools/task/task_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::kPuppy;

const RobotModel& puppy() {
  static const RobotModel robot = read_robot(kPuppy / "robot.xml");
  return robot;
}

Task task_from(const std::string& gait, const std::string& rest = "") {
  return make_task(parse_task_file("robot = \"robot.xml\"\n[gait]\n" + gait +
                                       "\n[travel]\nvelocity = [0.0, 0.1]\n" + rest,
                                   kPuppy / "test.toml"),
                   puppy());
}

TEST(PlantedMargin, IsSecondsInKnotsButAtLeastOneKnot) {
  EXPECT_EQ(planted_margin_knots(std::nullopt, 0.5, 0.4, 0.4 / 24, 0.21), 2);  // 35 ms of 16.7 ms
  EXPECT_EQ(planted_margin_knots(std::nullopt, 0.6, 0.4, 0.4 / 24, 0.21), 2);
  EXPECT_EQ(planted_margin_knots(std::nullopt, 0.75, 1.0, 1.0 / 24, 0.21), 1);  // a walk: one knot
  EXPECT_EQ(planted_margin_knots(std::nullopt, 0.5, 1.0, 0.1, 0.21), 1);
  EXPECT_EQ(planted_margin_knots(0.0, 0.5, 1.0, 0.01, 0.21), 1);
  EXPECT_EQ(planted_margin_knots(0.05, 0.75, 1.0, 0.01, 0.21), 5);
}

TEST(PlantedMargin, GrowsWithTheRootOfTheLegAndAGivenOneDoesNot) {
  EXPECT_EQ(planted_margin_knots(std::nullopt, 0.5, 1.0, 0.01, 0.21), 4);      // 35 ms
  EXPECT_EQ(planted_margin_knots(std::nullopt, 0.5, 1.0, 0.01, 4 * 0.21), 7);  // 70 ms
  EXPECT_EQ(planted_margin_knots(std::nullopt, 0.4, 0.24, 0.01, 0.21), 2);     // a sixth of 144 ms
  EXPECT_EQ(planted_margin_knots(0.03, 0.5, 1.0, 0.01, 4 * 0.21), 3);
}

TEST(PlantedMargin, GoesByThePatternsDutyNotByItsRoundedStance) {
  const Task pace = task_from("name = \"pace\"\nperiod = 0.4\nknots = 24");
  int stance = 0;
  for (int knot = 0; knot < 24; ++knot) stance += pace.gait.in_contact(knot, 0);
  EXPECT_EQ(stance, 15);  // 0.6 of 24 knots, rounded up to more than 0.6
  EXPECT_EQ(pace.planted_margin, 2);
  const Task slower = task_from("name = \"pace\"\nperiod = 0.4\nknots = 24\nduty = 0.625");
  EXPECT_EQ(slower.planted_margin, 1);
}

TEST(MakeTask, TurnsTheExamplesIntoTasks) {
  const Task walk = make_task(read_task_file(kPuppy / "sideways.toml"), puppy());
  EXPECT_EQ(walk.planted_margin, 1);
  EXPECT_EQ(walk.gait.knot_count(), 24);
  EXPECT_EQ(walk.velocity, Eigen::Vector2d(0.0, 0.1));
  EXPECT_EQ(walk.name, "sideways");
  const TaskFile file = read_task_file(kPuppy / "sideways_trot.toml");
  const Task trot = make_task(file, puppy());
  EXPECT_EQ(trot.planted_margin,
            planted_margin_knots(file.planted_margin, 0.5, 0.4, 0.4 / 24, 0.21));
  EXPECT_GE(trot.planted_margin, 2);
}

TEST(MakeTask, LimbPairsAndMarginsReachTheTask) {
  const std::string walk = "name = \"walk\"\nperiod = 1.0";
  const Task plain = task_from(walk);
  EXPECT_FALSE(plain.limb_pairs);
  EXPECT_NEAR(plain.clearance.value(), 0.02, 1e-4);  // by the leg of 21 cm
  EXPECT_NEAR(plain.swing_height.value(), 0.025, 3e-4);
  EXPECT_EQ(plain.torque_margin, 0.1);
  const Task task = task_from(walk,
                              "[limits]\nclearance = 0.03\ntorque_margin = 0.25\n"
                              "limb_pairs = [[\"FL\", \"HL_thigh\"]]\n");
  EXPECT_EQ(task.clearance, 0.03);
  EXPECT_EQ(task.torque_margin, 0.25);
  ASSERT_TRUE(task.limb_pairs);
  EXPECT_EQ(task.limb_pairs->front(), std::pair(std::string("FL"), std::string("HL_thigh")));
  EXPECT_TRUE(task_from(walk, "[limits]\nlimb_pairs = []\n").limb_pairs->empty());
}

TEST(MakeTask, RefusesLimbsThatTheRobotHasNot) {
  try {
    task_from("name = \"walk\"\nperiod = 1.0", "[limits]\nlimb_pairs = [[\"FL\", \"HL_tigh\"]]\n");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("limits.limb_pairs"), std::string::npos) << what;
    EXPECT_NE(what.find("did you mean 'HL_thigh'?"), std::string::npos) << what;
  }
  for (const char* shape : {"[\"FL\", \"HL\"]", "[[\"FL\"]]", "[[1, 2]]", "\"FL\""})
    EXPECT_THROW(task_from("name = \"walk\"\nperiod = 1.0",
                           std::string("[limits]\nlimb_pairs = ") + shape + "\n"),
                 InputError)
        << shape;
  EXPECT_THROW(task_from("name = \"walk\"\nperiod = 1.0", "[limits]\ntorque_margin = 1.0\n"),
               InputError);
}

TEST(MakeTask, PutsFeetInTheRobotsOrder) {
  const Task task = make_task(read_task_file(kPuppy / "sideways.toml"), puppy());
  const std::vector<Eigen::Vector3d> feet = home_feet(puppy().morphology, puppy().space.initial());
  ASSERT_EQ(feet.size(), 4u);
  ASSERT_TRUE(task.footprint);
  for (std::size_t j = 0; j < 4; ++j) {  // each footprint lies on its foot's side of the trunk
    const Eigen::Vector2d print = (*task.footprint)[j];
    EXPECT_EQ(print.cwiseAbs(), Eigen::Vector2d(0.12, 0.09));
    EXPECT_GT(print.y() * feet[j].y(), 0.0);
  }
  // The walk touches down front left first.
  const std::vector<int> order = footfall_order(feet);
  EXPECT_TRUE(task.gait.in_contact(0, order[0]));
  EXPECT_FALSE(task.gait.in_contact(-1, order[0]));
}

TEST(MakeTask, TouchdownByNameEqualsTouchdownByPlace) {
  const std::vector<std::string> names = foot_names(puppy().morphology);
  const std::vector<int> order =
      footfall_order(home_feet(puppy().morphology, puppy().space.initial()));
  const std::vector<double> phases{0.0, 0.5, 0.75, 0.25};
  std::string table;
  for (std::size_t place = 0; place < 4; ++place)
    table +=
        (place ? ", \"" : "\"") + names[order[place]] + "\" = " + std::to_string(phases[place]);
  const Task by_name = task_from("period = 1.0\nduty = 0.75\ntouchdown = {" + table + "}");
  const Task by_place = task_from("period = 1.0\nduty = 0.75\ntouchdown = [0.0, 0.5, 0.75, 0.25]");
  const Task library = task_from("name = \"walk\"\nperiod = 1.0");
  for (int knot = 0; knot < 24; ++knot)
    for (int foot = 0; foot < 4; ++foot) {
      EXPECT_EQ(by_name.gait.in_contact(knot, foot), library.gait.in_contact(knot, foot));
      EXPECT_EQ(by_place.gait.in_contact(knot, foot), library.gait.in_contact(knot, foot));
    }
}

TEST(MakeTask, DutyOverridesTheLibrary) {
  const Task task = task_from("name = \"trot\"\nperiod = 0.4\nduty = 0.75");
  int stance = 0;
  for (int knot = 0; knot < 24; ++knot) stance += task.gait.in_contact(knot, 0);
  EXPECT_EQ(stance, 18);
  EXPECT_EQ(task.planted_margin, 1);
}

int stance_knots(const Gait& gait, int foot) {
  int stance = 0;
  for (int knot = 0; knot < gait.knot_count(); ++knot) stance += gait.in_contact(knot, foot);
  return stance;
}

TEST(MakeTask, TakesADutyForEachFootByPlaceAndByName) {
  const std::vector<std::string> names = foot_names(puppy().morphology);
  const std::vector<int> order =
      footfall_order(home_feet(puppy().morphology, puppy().space.initial()));
  const std::string own =
      "name = \"my_trot\"\nperiod = 0.4\ntouchdown = [0.0, 0.5, 0.5, 0.0]\nduty = ";
  const Task by_place = task_from(own + "[0.5, 0.625, 0.75, 0.5]");
  const int expected[] = {12, 15, 18, 12};
  std::string table;
  for (std::size_t place = 0; place < 4; ++place) {
    EXPECT_EQ(stance_knots(by_place.gait, order[place]), expected[place]);
    table += (place ? ", " : "") + names[order[place]] + " = " +
             std::to_string(expected[place] / 24.0 - 1e-3);
  }
  const Task by_name = task_from(own + "{" + table + "}");
  for (int foot = 0; foot < 4; ++foot)
    EXPECT_EQ(stance_knots(by_name.gait, foot), stance_knots(by_place.gait, foot));
  EXPECT_EQ(by_place.gait.name(), "my_trot");
  EXPECT_EQ(task_from("name = \"trot\"\nperiod = 0.4\nduty = [0.5, 0.5, 0.75, 0.75]").gait.name(),
            "trot");
}

TEST(MakeTask, ReadsStyleOverTheCycle) {
  const Task task = task_from("name = \"walk\"\nperiod = 1.0",
                              "[style]\ncom_height = [0.17, 0.18]\n"
                              "com_path = [[0.0, 0.01], [0, -0.01], [0.005, 0.0]]\n"
                              "footprint = [0.12, 0.09]\n"
                              "foot_targets.HR = [[-0.1, -0.09], [-0.14, -0.09]]\n");
  EXPECT_FALSE(task.com_height);
  EXPECT_EQ(task.com_heights, (std::vector<double>{0.17, 0.18}));
  ASSERT_EQ(task.com_path.size(), 3u);
  EXPECT_EQ(task.com_path[2], Eigen::Vector2d(0.005, 0.0));
  const std::vector<std::string> names = foot_names(puppy().morphology);
  ASSERT_EQ(task.foot_targets.size(), names.size());
  for (std::size_t j = 0; j < names.size(); ++j)
    EXPECT_EQ(task.foot_targets[j].size(), names[j] == "HR" ? 2u : 0u);
  EXPECT_TRUE(task.footprint);
  const Task plain = task_from("name = \"walk\"\nperiod = 1.0", "[style]\ncom_height = 0.17\n");
  EXPECT_EQ(plain.com_height, 0.17);
  EXPECT_TRUE(plain.com_heights.empty() && plain.com_path.empty() && plain.foot_targets.empty());
}

TEST(MakeTask, PutsTargetsOfFeetAndJointsInTheRobotsOrder) {
  const Task task = task_from("name = \"walk\"\nperiod = 1.0",
                              "[style.foot_heights]\nHR = [[0.25, 0.01], [0.5, 0.04]]\n"
                              "FL = { over_cycle = [0.02, 0.03], weight = 2.5 }\n"
                              "[style.joint_angles]\nHL_knee = [-0.9]\n"
                              "HR_knee = { over_cycle = [[0.0, -0.9]], weight = 0.0 }\n");
  const std::vector<std::string> names = foot_names(puppy().morphology);
  ASSERT_EQ(task.foot_heights.size(), names.size());
  for (std::size_t j = 0; j < names.size(); ++j) {
    const CycleTarget& target = task.foot_heights[j];
    EXPECT_EQ(target.is_given(), names[j] == "HR" || names[j] == "FL");
    if (names[j] == "HR") {
      EXPECT_EQ(target.phases, (std::vector<double>{0.25, 0.5}));
      EXPECT_EQ(target.values, (std::vector<double>{0.01, 0.04}));
      EXPECT_EQ(target.weight, 1.0);
    } else if (names[j] == "FL") {
      EXPECT_TRUE(target.phases.empty());
      EXPECT_EQ(target.values, (std::vector<double>{0.02, 0.03}));
      EXPECT_EQ(target.weight, 2.5);
    }
  }
  ASSERT_EQ(static_cast<int>(task.joint_angles.size()), puppy().morphology.joint_count());
  for (int a = 0; a < puppy().morphology.joint_count(); ++a) {
    const CycleTarget* target = target_of(task.joint_angles, a);
    ASSERT_EQ(target != nullptr, puppy().morphology.links[a + 1].joint.name == "HL_knee");
    if (target == nullptr) continue;
    EXPECT_EQ(target->values, std::vector<double>{-0.9});
  }
  const Task plain = task_from("name = \"walk\"\nperiod = 1.0");
  EXPECT_TRUE(plain.foot_heights.empty() && plain.joint_angles.empty());
}

TEST(TaskWarnings, NameFeetThatAreHighInTheirStanceOnly) {
  const std::string walk = "name = \"walk\"\nperiod = 1.0";  // FL stands up to phase 0.75
  const std::string begin = "[style.foot_heights]\nFL = ";
  const auto warnings = [&](const std::string& heights) {
    return task_warnings(task_from(walk, begin + heights + "\n"), puppy());
  };
  EXPECT_TRUE(warnings("[[0.76, 0.0], [0.875, 0.05], [0.99, 0.0]]").empty());
  const std::vector<std::string> low = warnings("[[0.26, 0.0], [0.375, 0.05], [0.49, 0.0]]");
  ASSERT_EQ(low.size(), 1u);
  EXPECT_NE(low[0].find("style.foot_heights.FL lifts the foot by 0 mm"), std::string::npos)
      << low[0];
}

TEST(MakeTask, RefusesTargetsThatAreNoLists) {
  const std::string walk = "name = \"walk\"\nperiod = 1.0";
  for (const char* wrong :
       {"FL = 0.05", "FL = []", "FL = [[0.2, 0.05], 0.01]", "FL = [[0.2]]", "FL = [[1.0, 0.05]]",
        "FL = [-0.01]", "FL = \"high\"", "FL = { over_cycle = [0.05], weigth = 2.0 }",
        "FL = { over_cycle = [0.05], weight = -1.0 }"}) {
    const std::string text = std::string("[style.foot_heights]\n") + wrong + "\n";
    try {
      task_from(walk, text);
      ADD_FAILURE() << "accepted " << wrong;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(":8: style.foot_heights.FL"), std::string::npos)
          << error.what();
    }
  }
}

TEST(MakeTask, DynamicsAreFullUnlessTheFileAsksForThePapers) {
  EXPECT_EQ(task_from("name = \"walk\"\nperiod = 1.0").dynamics, Dynamics::full);
  const auto with = [](const std::string& name) {
    return make_task(parse_task_file("robot = \"robot.xml\"\ndynamics = \"" + name +
                                         "\"\n[gait]\nname = \"walk\"\nperiod = 1.0\n[travel]\n"
                                         "velocity = [0.0, 0.1]\n",
                                     kPuppy / "test.toml"),
                     puppy())
        .dynamics;
  };
  EXPECT_EQ(with("full"), Dynamics::full);
  EXPECT_EQ(with("constant_inertia"), Dynamics::constant_inertia);
}

std::string refusal(const std::string& gait, const std::string& rest = "") {
  try {
    task_from(gait, rest);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(MakeTask, RefusesAFootThatStandsForLessThanTwoKnots) {
  const std::string trot = "name = \"trot\"\nperiod = 0.4\nknots = 24\nduty = ";
  for (const char* duty : {"0.01", "0.0416"}) {
    const std::string message = refusal(trot + duty);
    for (const char* part : {"test.toml:6: gait.duty", "2 are needed", "raise the duty to 0.084"})
      EXPECT_NE(message.find(part), std::string::npos) << duty << ": " << message;
  }
  EXPECT_EQ(refusal(trot + "0.084").find("gait.duty"), std::string::npos);
}

TEST(MakeTask, TellsTheHeightThatItAccepts) {
  const std::string walk = "name = \"walk\"\nperiod = 1.0";
  const std::string message = refusal(walk, "[style]\ncom_height = 3.0\n");
  const std::string before = "at most ";
  const auto at = message.find(before);
  ASSERT_NE(at, std::string::npos) << message;
  const double most = std::stod(message.substr(at + before.size()));
  const auto height = [](double value) {
    return "[style]\ncom_height = " + std::to_string(value) + "\n";
  };
  EXPECT_EQ(refusal(walk, height(0.99 * most)), "");
  EXPECT_NE(refusal(walk, height(1.01 * most)), "");
}

TEST(MakeTask, ChecksTheHighestOfAListOfHeights) {
  const std::string walk = "name = \"walk\"\nperiod = 1.0";
  EXPECT_EQ(refusal(walk, "[style]\ncom_height = [0.17, 0.18]\n"), "");
  EXPECT_NE(refusal(walk, "[style]\ncom_height = [0.17, 3.0, 0.17]\n").find("style.com_height"),
            std::string::npos);
}

TEST(MakeTask, RefusalsOfAPatternTeach) {
  const std::string period = "\nperiod = 0.4\n";
  const std::string touchdown = "touchdown = [0.0, 0.5, 0.5, 0.0]\n";
  const std::vector<std::pair<std::string, std::vector<const char*>>> cases{
      {"name = \"walk\"" + period + touchdown + "duty = 0.5",
       {"test.toml:3: gait.name", "is a gait of the library", "\"my_walk\""}},
      {"name = \"mine\"" + period + touchdown + "duty = [0.5, 0.5]",
       {"test.toml:6: gait.duty", "has 2 entries", "4 feet", "front to hind"}},
      {"name = \"mine\"" + period + touchdown + "duty = {FL = 0.5, FR = 0.5, HL = 0.5}",
       {"gait.duty", "no entry for the foot 'HR'"}},
      {"name = \"mine\"" + period + touchdown + "duty = {FL = 0.5, FR = 0.5, HL = 0.5, HRR = 0.5}",
       {"gait.duty.HRR", "did you mean 'HR'?"}},
      {"name = \"mine\"" + period + touchdown + "duty = [0.5, 0.5, 0.5, 0.01]",
       {"gait.duty", "the foot 'HR' no stance"}},
      {"name = \"gallop\"" + period, {"gait.name", "not in the library", "transverse_gallop"}},
  };
  for (const auto& [gait, parts] : cases)
    for (const char* part : parts)
      EXPECT_NE(refusal(gait).find(part), std::string::npos) << part << " in: " << refusal(gait);
  // Under the library's own touchdowns its name is right.
  EXPECT_EQ(refusal("name = \"trot\"" + period + touchdown + "duty = 0.625"), "");
}

TEST(MakeTask, KeepsWeightsByTermName) {
  EXPECT_EQ(task_from("name = \"trot\"\nperiod = 0.4", "[weights]\nsmoothness = 7.5\n")
                .weights.at("smoothness"),
            7.5);
}

TEST(MakeTask, SpeedLadderFlipsOnceAndStays) {
  bool refused = false;
  for (double speed = 0.1; speed < 5.0; speed *= 1.2) {
    bool now = false;
    try {
      make_task(parse_task_file("robot = \"robot.xml\"\n[gait]\nname = \"walk\"\nperiod = "
                                "1.0\n[travel]\nvelocity = [" +
                                    std::to_string(speed) + ", 0.0]\n",
                                kPuppy / "test.toml"),
                puppy());
    } catch (const InputError&) {
      now = true;
    }
    EXPECT_TRUE(now || !refused) << speed;
    refused = now;
  }
  EXPECT_TRUE(refused);
}

TEST(TaskWarnings, AreNoneForTheExamplesAndNameDoubts) {
  for (const char* name : {"sideways.toml", "sideways_trot.toml"})
    EXPECT_TRUE(task_warnings(make_task(read_task_file(kPuppy / name), puppy()), puppy()).empty())
        << name;
  Task task = make_task(read_task_file(kPuppy / "sideways.toml"), puppy());
  task.velocity.setZero();
  task.friction = 0.8;
  EXPECT_EQ(task_warnings(task, puppy()).size(), 2u);
}

TEST(MakeTask, WarnsOfTwoFeetThatDoNotBalance) {
  const fs::path biped = test::kExamples / "biped";
  RobotModel robot = read_robot(biped / "robot.xml");
  const Task task = make_task(read_task_file(biped / "walk.toml"), robot);
  EXPECT_TRUE(task_warnings(task, robot).empty()) << "round soles of 35 cm right it";
  for (Foot& foot : robot.morphology.feet) foot.radius = 0.02;
  const std::vector<std::string> warnings = task_warnings(task, robot);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("two small feet"), std::string::npos) << warnings[0];
}

}  // namespace
}  // namespace legwright
