// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "mjcf/text/input_error.hpp"
#include "tests/support/paths.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/task/task_file.hpp"
#include "tools/task/task_text.hpp"

namespace legwright {
namespace {

constexpr const char* kText =
    "# A walk.\n"
    "robot = \"r.xml\"  # beside\n"
    "\n"
    "[gait]\n"
    "name = \"walk\"\n"
    "period = 1.0    # s\n"
    "                # one cycle\n"
    "\n"
    "[payload]\n"
    "mass = 1.0\n"
    "\n"
    "[travel]\n"
    "velocity = [0.1, 0.0]\n";

std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(KeyEditTest, AValueIsReplacedAndEveryOtherByteStays) {
  EXPECT_EQ(with_key(kText, {"gait", "period"}, "0.8"), with(kText, "1.0    #", "0.8    #"));
}

TEST(KeyEditTest, ANewKeyGoesIntoItsTableAndANewTableToTheEnd) {
  EXPECT_EQ(with_key(kText, {"gait", "knots"}, "20"),
            with(kText, "name = \"walk\"", "knots = 20\nname = \"walk\""));
  EXPECT_EQ(with_key(kText, {"limits", "friction"}, "0.5"),
            std::string(kText) + "\n[limits]\nfriction = 0.5\n");
  EXPECT_EQ(with_key(kText, {"name"}, "\"mine\""),
            with(kText, "robot =", "name = \"mine\"\nrobot ="));
}

TEST(KeyEditTest, AKeyGoesWithItsCommentAndATableWhole) {
  EXPECT_EQ(with_key(kText, {"gait", "period"}, std::nullopt),
            with(kText, "period = 1.0    # s\n                # one cycle\n", ""));
  EXPECT_EQ(with_key(kText, {"payload"}, std::nullopt),
            with(kText, "[payload]\nmass = 1.0\n\n", ""));
  EXPECT_EQ(with_key(kText, {"ground", "slope_along"}, std::nullopt), kText) << "is not there";
}

TEST(KeyEditTest, EachTaskOfSeveralIsChangedByItself) {
  const std::string text = read_file(test::source_dir() + "/examples/quadruped/both.toml");
  for (const char* task : {"0", "1"}) {
    const std::string changed = with_key(text, {"task", task, "payload", "mass"}, "0.5");
    const TaskSet set = parse_task_tables(changed, "both.toml");
    for (int k = 0; k < 2; ++k)
      EXPECT_EQ(set.tasks[static_cast<std::size_t>(k)].margins.payload.has_value(),
                std::to_string(k) == task);
    EXPECT_EQ(parse_task_tables(with_key(text, {"task", task, "gait", "period"}, "0.5"), "b")
                  .tasks[task[0] - '0']
                  .period,
              0.5);
    EXPECT_NE(changed.find("# One body, two tasks"), std::string::npos);
  }
}

TEST(KeyEditTest, TextsThatAreTooIntricateAreWrittenAnewAndSayTheSame) {
  const std::string text = "robot = \"r.xml\"\ngait = { name = \"walk\", period = 1.0 }\n";
  const TaskSet set = parse_task_tables(
      with_key(with_key(text, {"gait", "knots"}, "20"), {"travel", "velocity"}, "[0.1, 0.0]"), "t");
  EXPECT_EQ(set.tasks[0].knots, 20);
  EXPECT_EQ(set.tasks[0].period, 1.0);
  const std::string dotted =
      "robot = \"r.xml\"\ngait.name = \"walk\"\ngait.period = 1.0\n"
      "travel.velocity = [0.1, 0.0]\n";
  EXPECT_EQ(parse_task_tables(with_key(dotted, {"gait", "knots"}, "20"), "t").tasks[0].knots, 20);
  EXPECT_THROW(with_key("robot = ", {"name"}, "1"), InputError);
  EXPECT_THROW(with_key(text, {"name"}, "1 2"), InputError);
}

}  // namespace
}  // namespace legwright
