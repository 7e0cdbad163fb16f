// SPDX-License-Identifier: Apache-2.0
// Every broken robot of the examples, given to each verb that takes one.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "tests/tools/verbs/program.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::call_in;
using test::contains;
using test::kExamples;
using test::Outcome;
using test::TemporaryFolder;

std::map<std::string, std::string> bytes_below(const fs::path& folder) {
  std::map<std::string, std::string> out;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = fs::relative(entry.path(), folder).string();
    if (name == "out" || name == "err") continue;  // of the program's own streams
    out[name] = entry.is_regular_file() ? read_file(entry.path()) : "folder";
  }
  return out;
}

/// Everything of a broken robot: files beside it too.
std::vector<fs::path> broken_robots() {
  std::vector<fs::path> out;
  for (const auto& entry : fs::directory_iterator(kExamples / "broken" / "robots"))
    if (entry.path().extension() == ".xml") out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

TEST(BrokenRobots, EveryVerbRefusesEachAndWritesNothing) {
  const std::vector<fs::path> robots = broken_robots();
  ASSERT_GE(robots.size(), 60u);
  const std::string task = read_file(kExamples / "puppy" / "sideways.toml");
  for (const fs::path& robot : robots) {
    const TemporaryFolder folder;
    fs::copy_file(robot, folder.path() / "robot.xml");
    write_file(folder.path() / "task.toml", task);
    const auto before = bytes_below(folder.path());
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"init", "robot.xml", "--write"},
                                               {"init", "robot.xml", "-o", "new.xml"},
                                               {"check", "task.toml"},
                                               {"optimize", "task.toml", "-o", "run"}}) {
      const auto start = std::chrono::steady_clock::now();
      const Outcome outcome = call_in(folder.path(), words);
      const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
      EXPECT_EQ(outcome.code, 2) << words[0] << " " << robot << outcome.err;
      EXPECT_TRUE(contains(outcome.err, "robot.xml")) << words[0] << " " << outcome.err;
      EXPECT_EQ(outcome.out, "") << words[0] << " " << robot;
      EXPECT_EQ(outcome.err.find('\x1b'), std::string::npos) << robot;
      EXPECT_LT(spent.count(), 30.0) << words[0] << " " << robot;
    }
    EXPECT_TRUE(bytes_below(folder.path()) == before) << robot << " left something behind";
  }
}

/// `diff` takes whatever MuJoCo opens; it refuses or compares, and neither writes nor dies.
TEST(BrokenRobots, DiffRefusesOrCompares) {
  int refused = 0;
  for (const fs::path& robot : broken_robots()) {
    const TemporaryFolder folder;
    fs::copy_file(robot, folder.path() / "robot.xml");
    const auto before = bytes_below(folder.path());
    const Outcome outcome = call_in(folder.path(), {"diff", "robot.xml", "robot.xml"});
    EXPECT_TRUE(outcome.code == 2 || outcome.code == 0) << robot << outcome.code << outcome.err;
    EXPECT_EQ(outcome.err.find('\x1b'), std::string::npos) << robot;
    EXPECT_TRUE(outcome.code == 0 || contains(outcome.err, "robot.xml")) << outcome.err;
    EXPECT_TRUE(bytes_below(folder.path()) == before) << robot << " left something behind";
    refused += outcome.code == 2;
  }
  EXPECT_GT(refused, 20);
}

/// Negative control: the same verbs take a robot that is whole, and do write.
TEST(BrokenRobots, AWholeRobotIsTaken) {
  const TemporaryFolder folder;
  fs::copy_file(kExamples / "puppy" / "robot.xml", folder.path() / "robot.xml");
  fs::copy_file(kExamples / "puppy" / "sideways.toml", folder.path() / "task.toml");
  const auto before = bytes_below(folder.path());
  EXPECT_EQ(call_in(folder.path(), {"check", "task.toml"}).code, 0);
  EXPECT_EQ(call_in(folder.path(), {"diff", "robot.xml", "robot.xml"}).code, 0);
  EXPECT_EQ(call_in(folder.path(), {"init", "robot.xml", "-o", "new.xml"}).code, 0);
  EXPECT_FALSE(bytes_below(folder.path()) == before);
}

}  // namespace
}  // namespace legwright
