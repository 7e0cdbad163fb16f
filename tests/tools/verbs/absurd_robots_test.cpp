// SPDX-License-Identifier: Apache-2.0
// Robots and tasks beyond measure: the reason comes at once, where it can be known before a run.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "tests/tools/verbs/program.hpp"

namespace legwright {
namespace {

class AbsurdRobots : public testing::Test, protected test::CallsInFolder {
 protected:
  /// Calls the program, which takes 0.1 to 1.7 s of a quiet processor (1.2 s of it MuJoCo's own
  /// reader, which lists a body's sites anew at each of them); a search would take minutes.
  test::Outcome call_at_once(const std::vector<std::string>& words) const {
    const double before = child_seconds();
    const test::Outcome outcome = call(words);
    EXPECT_LT(child_seconds() - before, 10.0) << words.front();
    return outcome;
  }
  void put(const std::string& robot, const std::string& task_ends_with = "") const {
    write_file(folder_.path() / "robot.xml", robot);
    write_file(
        folder_.path() / "task.toml",
        "robot = \"robot.xml\"\n[travel]\nvelocity = [0.1, 0.0]\n[gait]\nname = \"walk\"\nperiod "
        "= 1.0\n" +
            task_ends_with);
  }

 private:
  static double child_seconds() {
    struct rusage used {};
    ::getrusage(RUSAGE_CHILDREN, &used);
    const auto seconds = [](const timeval& time) {
      return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
  }
};

std::string puppy() { return read_file(test::kExamples / "puppy/robot.xml"); }

TEST_F(AbsurdRobots, MassesInGramsAreToldByInitAndCheck) {
  std::string robot = puppy();
  for (std::size_t at = 0; (at = robot.find(" mass=\"", at)) != std::string::npos;) {
    at += 7;
    const std::size_t end = robot.find('"', at);
    const double mass = std::stod(robot.substr(at, end - at));
    robot.replace(at, end - at, std::to_string(1000.0 * mass));
  }
  put(robot);
  const test::Outcome init = call_at_once({"init", "robot.xml"});
  EXPECT_TRUE(test::contains(init.out + init.err, "gram")) << init.out << init.err;
  const test::Outcome check = call_at_once({"check", "task.toml"});
  EXPECT_TRUE(test::contains(check.out + check.err, "motors too weak to stand"))
      << check.out << check.err;
}

TEST_F(AbsurdRobots, APayloadThatIsTooHeavyIsToldByCheck) {
  put(puppy(), "[payload]\nmass = 102.0\n");
  const test::Outcome check = call_at_once({"check", "task.toml"});
  EXPECT_TRUE(test::contains(check.out + check.err, "motors too weak to stand"))
      << check.out << check.err;
}

TEST_F(AbsurdRobots, ManySitesAndManyKnotsAreCheckedAtOnce) {
  std::string sites;
  for (int k = 0; k < 19'000; ++k)
    sites += "<site name=\"mark" + std::to_string(k) + "\" pos=\"0 0 0.01\"/>\n";
  std::string robot = puppy();
  const std::size_t in_trunk = robot.find("<inertial");
  ASSERT_NE(in_trunk, std::string::npos);
  robot.insert(in_trunk, sites);
  put(robot);
  EXPECT_EQ(call_at_once({"check", "task.toml"}).code, 0);
  put(puppy(), "knots = 384\n");
  EXPECT_EQ(call_at_once({"check", "task.toml"}).code, 0);
}

}  // namespace
}  // namespace legwright
