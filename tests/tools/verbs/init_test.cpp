// SPDX-License-Identifier: Apache-2.0
// `legwright init --task` of robots on two feet: those that would fall get no task but the reason.
#include <gtest/gtest.h>

#include "tests/mjcf/robots/flat_biped.hpp"
#include "tests/tools/verbs/program.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::call;
using test::contains;
using test::Outcome;

class InitOnTwoFeet : public testing::Test {
 protected:
  Outcome init(const test::FlatBiped& how, std::vector<std::string> more = {}) const {
    write_file(robot_, test::flat_biped(how));
    fs::remove(task_);
    std::vector<std::string> words{"init", robot_.string(), "--task", task_.string()};
    words.insert(words.end(), more.begin(), more.end());
    return call(words);
  }
  static test::FlatBiped weak() {
    test::FlatBiped how;
    how.limit = 5.0;
    how.kp = 120.0;
    return how;
  }
  static test::FlatBiped pointed() {
    test::FlatBiped how;
    how.foot = test::foot_geoms("ball");
    return how;
  }
  const test::TemporaryFolder folder_;
  const fs::path robot_ = folder_.path() / "robot.xml", task_ = folder_.path() / "task.toml";
};

TEST_F(InitOnTwoFeet, WritesATaskForFlatFeetOnStrongAnkles) {
  const Outcome told = init({});
  ASSERT_EQ(told.code, 0) << told.err;
  const std::string text = read_file(task_);
  for (const char* key : {"swing_height = ", "[servos]\nkp = ", "kd = "})
    EXPECT_TRUE(contains(text, key)) << key << text;
  const Outcome check = call({"check", task_.string()});
  EXPECT_EQ(check.code, 0) << check.err;
}

TEST_F(InitOnTwoFeet, WritesNoneForThoseThatWouldFall) {
  const Outcome weak_ones = init(weak());
  EXPECT_EQ(weak_ones.code, 1);
  EXPECT_FALSE(fs::exists(task_));
  EXPECT_TRUE(contains(weak_ones.err, "task.toml is not written: weak ankles")) << weak_ones.err;
  EXPECT_TRUE(contains(weak_ones.err, "has 5;")) << weak_ones.err;
  EXPECT_FALSE(contains(weak_ones.out, "next: legwright optimize")) << weak_ones.out;
  const Outcome points = init(pointed());
  EXPECT_EQ(points.code, 1);
  EXPECT_FALSE(fs::exists(task_));
  EXPECT_TRUE(contains(points.err, "is not written: two small feet")) << points.err;
  const Outcome document = init(pointed(), {"--json"});
  EXPECT_EQ(document.code, 1);
  EXPECT_FALSE(fs::exists(task_));
  EXPECT_NO_THROW(Json::parse(document.out));
}

TEST_F(InitOnTwoFeet, StillWritesTheirParameters) {
  const Outcome told = init(weak(), {"--write"});
  EXPECT_EQ(told.code, 1);
  EXPECT_TRUE(contains(read_file(robot_), "legwright/shank_length"));
  EXPECT_FALSE(fs::exists(task_));
}

TEST_F(InitOnTwoFeet, WritesThemAllTheSameWhereTheGaitIsNamed) {
  for (const test::FlatBiped& how : {weak(), pointed()}) {
    const Outcome told = init(how, {"--gait", "walk"});
    EXPECT_EQ(told.code, 0) << told.err;
    ASSERT_TRUE(fs::exists(task_));
    EXPECT_TRUE(contains(read_file(task_), "\"walk\""));
    const Outcome check = call({"check", task_.string()});
    EXPECT_EQ(check.code, 0) << check.err;
    EXPECT_TRUE(contains(check.out + check.err, "weak ankles") ||
                contains(check.out + check.err, "two small feet"))
        << check.out << check.err;
  }
}

}  // namespace
}  // namespace legwright
