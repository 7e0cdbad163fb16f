// SPDX-License-Identifier: Apache-2.0
#include "tools/task/task_text.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include "mjcf/text/input_error.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/task/task_file.hpp"

namespace legwright {
namespace {

TEST(TaskText, BesideItsRobotNamesItAndNothingElseChanges) {
  const auto copy = [](const std::string& text) { return text_beside_robot(text); };
  const std::string rest = " # the dog: \"../robots/dog.xml\"\r\n[gait]\nrobot = \"x\"\n";
  for (const char* name : {"\"../robots/dog.xml\"", "'../röbots/dög.xml'", "\"\"\"dog.xml\"\"\"",
                           "\"\"\"\ndog.xml\"\"\"", "\"do\\u0067.xml\""})
    for (const char* before : {"", "\xEF\xBB\xBF", "# größer\n", "# ä\r\n\t"}) {
      const std::string head = before;
      EXPECT_EQ(copy(head + "robot = " + name + rest), head + "robot = \"robot.xml\"" + rest);
    }
  for (const char* same : {"robot = 'robot.xml' # as it is\n", "robot = \"robot.xml\""})
    EXPECT_EQ(copy(same), same);
  EXPECT_EQ(copy("robot=\"a\""), "robot=\"robot.xml\"");
}

TEST(TaskText, TakesOtherWeightsAndNothingElseChanges) {
  const std::string file = test::source_dir() + "/examples/quadruped/both.toml";
  const std::string text = read_file(file);
  const auto weights_in = [&](const std::string& changed) {
    std::vector<double> out;
    for (const TaskFile& task : parse_task_tables(changed, file).tasks) out.push_back(task.weight);
    return out;
  };
  EXPECT_EQ(with_weights(text, weights_in(text)), text);
  const std::vector<double> wanted{0.1 + 0.2, 1.0};
  const std::string changed = with_weights(text, wanted);
  EXPECT_EQ(weights_in(changed), wanted);
  EXPECT_EQ(with_weights(changed, weights_in(text)), text);  // and back
  const std::string without = "[[task]]\nname = \"pace\"  # quick\n[[task]]\nname = \"walk\"\n";
  EXPECT_EQ(with_weights(without, {0.25, 0.75}),
            "[[task]]\nname = \"pace\"\nweight = 0.25  # quick\n"
            "[[task]]\nname = \"walk\"\nweight = 0.75\n");
}

TEST(TaskText, OfAKeyOfTooManyPartsIsRefusedBeforeItIsParsed) {
  std::string deep = "a";
  for (int k = 0; k < 40000; ++k) deep += ".a";
  deep += " = 1\n";
  EXPECT_THROW(text_beside_robot(deep), InputError);
  EXPECT_THROW(with_weights(deep, {1.0}), InputError);
}

}  // namespace
}  // namespace legwright
