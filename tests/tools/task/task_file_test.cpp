// SPDX-License-Identifier: Apache-2.0
#include "tools/task/task_file.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "mjcf/text/input_error.hpp"
#include "tests/support/source_tree.hpp"
#include "tests/support/text.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/atomic_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::kPuppy;
// Test names are made from it during static initialisation, maybe before test::kExamples exists.
const fs::path kBroken = fs::path(test::source_dir()) / "examples" / "broken" / "tasks";

std::string error_message(const std::string& text) {
  try {
    parse_task_file(text, kPuppy / "test.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// The parts after "# expect:" in the first line of a broken file.
std::vector<std::string> expected_parts(const fs::path& file) {
  const std::string text = read_file(file);
  std::string line = text.substr(0, text.find('\n'));
  std::vector<std::string> parts;
  line = line.substr(line.find("expect: ") + 8);
  for (std::size_t end; (end = line.find('|')) != std::string::npos; line = line.substr(end + 1))
    parts.push_back(line.substr(0, end));
  parts.push_back(line);
  return parts;
}

TEST(TaskFile, ReadsTheWalkExample) {
  const TaskFile task = read_task_file(kPuppy / "sideways.toml");
  EXPECT_EQ(task.name, "sideways");
  EXPECT_EQ(task.robot, kPuppy / "robot.xml");
  EXPECT_EQ(task.gait, "walk");
  EXPECT_EQ(task.period, 1.0);
  EXPECT_EQ(task.knots, 24);
  EXPECT_EQ(task.velocity, Eigen::Vector2d(0.0, 0.1));
  EXPECT_EQ(task.com_height, 0.175);
  EXPECT_EQ(task.margins.min_normal, 0.1);
  EXPECT_EQ(task.margins.friction, 0.4);
  EXPECT_EQ(task.margins.floor_friction, 0.8);
  EXPECT_EQ(task.margins.swing_height, 0.025);
  EXPECT_FALSE(task.planted_margin);
  EXPECT_EQ(task.line("gait.period"), 13);
  EXPECT_EQ(task.line("limits.planted_margin"), task.line("limits"));
}

TEST(TaskFile, ReadsTheTrotExample) {
  const TaskFile task = read_task_file(kPuppy / "sideways_trot.toml");
  EXPECT_EQ(task.gait, "trot");
  EXPECT_EQ(task.period, 0.4);
  ASSERT_TRUE(task.planted_margin);
  EXPECT_GE(*task.planted_margin, 0.035);  // real touchdown is that early or late
}

TEST(TaskFile, CommentsInTheExampleNameRealKeys) {
  // Every line that is commented out must be accepted once it is not.
  std::string text = read_file(kPuppy / "sideways.toml");
  for (const std::string key :
       {"dynamics", "duty", "com_path", "foot_targets", "foot_heights", "joint_angles",
        "planted_margin", "joint_margin", "torque_limit", "step_over", "[ground]", "slope_along",
        "slope_across", "[payload]", "mass", "position", "size", "[weights]", "smoothness"}) {
    const std::size_t at = text.find("# " + key);
    ASSERT_NE(at, std::string::npos) << key;
    text.erase(at, 2);
  }
  EXPECT_NE(error_message(text).find("limits.step_over"), std::string::npos);  // 25 mm are too low
  text.replace(text.find("swing_height = 0.025"), 20, "swing_height = 0.06 ");
  EXPECT_EQ(error_message(text), "");
  EXPECT_EQ(parse_task_file(text, kPuppy / "test.toml").weights.at("smoothness"), 0.3);
  // A pattern of one's own needs a name of its own as well.
  text.erase(text.find("# touchdown"), 2);
  const TaskFile own = parse_task_file(text, kPuppy / "test.toml");
  EXPECT_EQ(own.touchdown.size(), 4u);
  EXPECT_EQ(own.foot_targets.at("FL").size(), 2u);
  EXPECT_EQ(own.foot_heights.at("FL").values.size(), 3u);
  EXPECT_EQ(own.joint_angles.at("FL_knee").weight, 0.5);
  EXPECT_EQ(own.margins.dynamics, Dynamics::constant_inertia);
}

TEST(TaskFile, TellsAnglesThatMayBeMeantInDegrees) {
  const std::string start = "robot = \"robot.xml\"\n[gait]\nname = \"walk\"\nperiod = 1\n";
  const auto told = [&](const std::string& more) { return error_message(start + more); };
  EXPECT_TRUE(
      in_order(told("[ground]\nslope_along = 10\n"), {"<= 1 rad; 10 degrees are 0.1745 rad"}));
  EXPECT_TRUE(in_order(told("[travel]\nvelocity = [0, 0]\nturn_rate = -45\n"),
                       {"<= 10 rad/s; -45 degrees/s are -0.7854 rad/s"}));
  EXPECT_EQ(told("[ground]\nslope_along = 100\n").find("degrees"), std::string::npos);
}

TEST(TaskFile, SaysEverythingThatIsWrongAtOnceInTheOrderOfTheFile) {
  const std::string message =
      error_message("robot = \"robot.xml\"\n[gait]\nname = \"walk\"\nperiod = -1.0\nknotz = 24\n");
  const std::size_t period =
      message.find(":4: gait.period: is -1; expected 0.05 <= period <= 20 s");
  const std::size_t knots = message.find(":5: gait.knotz: unknown key; did you mean 'gait.knots'?");
  EXPECT_NE(period, std::string::npos) << message;
  EXPECT_NE(knots, std::string::npos) << message;
  EXPECT_LT(period, knots);
  EXPECT_NE(message.find("travel.velocity: is missing; add for instance: velocity = "),
            std::string::npos)
      << message;
}

TEST(TaskFile, TellsAMisspeltKeyBeforeTheOneThatIsMissing) {
  const std::string message = error_message(
      "robot = \"robot.xml\"\n[gait]\nname = \"walk\"\nperoid = 1.0\n[travel]\nvelocity = [0, "
      "1]\n");
  const std::size_t misspelt = message.find(":4: gait.peroid: "),
                    missing = message.find("gait.period: is missing");
  ASSERT_NE(misspelt, std::string::npos) << message;
  ASSERT_NE(missing, std::string::npos) << message;
  EXPECT_LT(misspelt, missing);
  EXPECT_NE(message.find("'gait.period'"), std::string::npos) << message;
}

TEST(TaskFile, ARobotInItsPlaceIsToldAsSuch) {
  for (const char* before : {"", "\xEF\xBB\xBF", "\n  "}) {
    const std::string message = error_message(before + std::string("<mujoco model=\"a\"/>\n"));
    EXPECT_NE(message.find("legwright init "), std::string::npos) << message;
  }
  EXPECT_EQ(error_message("a < 3").find("legwright init "), std::string::npos);
}

TEST(TaskFile, AByteOfZeroInAKeyDoesNotCutTheReason) {
  const std::string message = error_message("\"a\\u0000b\" = 1\n");
  EXPECT_NE(message.find("b: unknown key"), std::string::npos) << message;
  EXPECT_NE(message.find("travel.velocity: is missing"), std::string::npos) << message;
}

TEST(TaskFile, TakesWholeNumbersWhereNumbersAreAsked) {
  const std::string text =
      "robot = \"robot.xml\"\n[gait]\nname = \"walk\"\nperiod = 1\n[travel]\nvelocity = [0, 1]\n";
  EXPECT_EQ(parse_task_file(text, kPuppy / "x.toml").velocity.y(), 1.0);
}

TEST(TaskFile, TellsAMissingFile) {
  EXPECT_THROW(read_task_file(kPuppy / "no_such.toml"), InputError);
  EXPECT_THROW(read_task_file(kPuppy), InputError);
  const test::TemporaryFolder folder;
  write_file(folder.path() / "huge.toml", std::string((1 << 20) + 1, '#'));
  EXPECT_THROW(read_task_file(folder.path() / "huge.toml"), InputError);
}

TEST(TaskFile, EveryPrefixOfTheExampleIsReadOrRefused) {
  const std::string text = read_file(kPuppy / "sideways.toml");
  int accepted = 0;
  for (std::size_t size = 0; size <= text.size(); ++size) {
    const std::string message = error_message(text.substr(0, size));
    accepted += message.empty();
    EXPECT_TRUE(message.empty() || message.find("test.toml") != std::string::npos) << message;
  }
  EXPECT_GT(accepted, 0);
  EXPECT_NE(error_message(text.substr(0, text.find("velocity"))), "");
}

TEST(TaskFile, EveryDamagedByteOfTheExampleIsReadOrRefused) {
  const std::string text = read_file(kPuppy / "sideways_trot.toml");
  int accepted = 0, refused = 0;
  for (std::size_t at = 0; at < text.size(); ++at)
    for (const char byte : {'\0', '\xFF', '"', '[', '=', ',', '9'}) {
      std::string damaged = text;
      damaged[at] = byte;
      const std::string message = error_message(damaged);  // InputError or success, nothing else
      ++(message.empty() ? accepted : refused);
      EXPECT_TRUE(message.empty() || message.find("test.toml") != std::string::npos)
          << "byte " << at << " without its file: " << message;
    }
  // Most of the file is comments and blanks, where many bytes do no harm.
  EXPECT_GT(accepted, 100);
  EXPECT_GT(refused, 100);
}

class BrokenTask : public ::testing::TestWithParam<std::string> {};

TEST_P(BrokenTask, IsRefusedWithFileLineKeyAndFix) {
  const fs::path file = kBroken / GetParam();
  std::string message;
  try {
    const TaskFile task = read_task_file(file);
    make_task(task, read_robot(task.robot));
  } catch (const InputError& error) {
    message = error.what();
  }
  EXPECT_EQ(message.find(file.string()), 0u) << message;
  for (const std::string& part : expected_parts(file))
    EXPECT_NE(message.find(part), std::string::npos) << "expected '" << part << "' in: " << message;
}

std::vector<std::string> broken_files() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(kBroken))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

INSTANTIATE_TEST_SUITE_P(Files, BrokenTask, ::testing::ValuesIn(broken_files()),
                         [](const auto& test) {
                           return test.param.substr(0, test.param.find('.'));
                         });

const char* const kTwoTasks = R"(robot = "robot.xml"
name = "both"
[limits]
friction = 0.5
planted_margin = 0.03
[[task]]
name = "pace"
weight = 0.25
[task.gait]
name = "pace"
period = 0.4
[task.travel]
velocity = [0.1, 0]
[[task]]
name = "sideways"
[task.gait]
name = "walk"
period = 1
[task.travel]
velocity = [0, 0.08]
[task.limits]
friction = 0.3
)";

TEST(TaskSet, HoldsSeveralTasksAndWhatTheyShare) {
  const TaskSet set = parse_task_set(kTwoTasks, kPuppy / "x.toml");
  ASSERT_TRUE(set.joint());
  EXPECT_EQ(set.name, "both");
  const TaskFile &pace = set.tasks[0], &sideways = set.tasks[1];
  EXPECT_EQ(pace.name, "pace");
  EXPECT_EQ(pace.weight, 0.25);
  EXPECT_EQ(sideways.weight, 0.5) << "one over the number of tasks";
  EXPECT_EQ(pace.margins.friction, 0.5);
  EXPECT_EQ(sideways.margins.friction, 0.3);
  EXPECT_EQ(*sideways.planted_margin, 0.03) << "not said otherwise";
  EXPECT_EQ(sideways.line("gait.period"), 18);
}

TEST(TaskSet, OneTaskIsASetOfOne) {
  const TaskSet set = read_task_set(kPuppy / "sideways.toml");
  EXPECT_FALSE(set.joint());
  EXPECT_EQ(set.tasks[0].name, "sideways");
  EXPECT_EQ(set.tasks[0].weight, 1.0);
}

TEST(TaskSet, ErrorsNameTheirLine) {
  const auto message = [](std::string text, const std::string& what, const std::string& instead) {
    text.replace(text.find(what), what.size(), instead);
    try {
      (void)parse_task_set(text, kPuppy / "x.toml");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  const std::string twin = message(kTwoTasks, "name = \"sideways\"", "name = \"pace\"");
  EXPECT_TRUE(has(twin, ":15:") && has(twin, "another task")) << twin;
  const std::string nameless = message(kTwoTasks, "name = \"sideways\"", "");
  EXPECT_TRUE(has(nameless, "name") && has(nameless, "missing")) << nameless;
  for (const char* taken : {"initial", "random-1", "from-x", "x-alone", "a/b", ".."}) {
    const std::string name =
        message(kTwoTasks, "name = \"sideways\"", "name = \"" + std::string(taken) + "\"");
    EXPECT_TRUE(has(name, ":15:") && has(name, "names a folder")) << name;
  }
  const std::string outer = message(kTwoTasks, "[limits]", "[outer]\nweight = 2\n[limits]");
  EXPECT_TRUE(has(outer, "outer.objective") && has(outer, "missing")) << outer;
  const std::string weight = message(kTwoTasks, "weight = 0.25", "weight = 0");
  EXPECT_TRUE(has(weight, ":8:") && has(weight, "weight")) << weight;
  const std::string outside = message(kTwoTasks, "[limits]", "[gait]\nname = \"walk\"\n[limits]");
  EXPECT_TRUE(has(outside, "gait") && has(outside, "unknown key")) << outside;
  EXPECT_THROW((void)parse_task_file(kTwoTasks, kPuppy / "x.toml"), InputError);
}

}  // namespace
}  // namespace legwright
