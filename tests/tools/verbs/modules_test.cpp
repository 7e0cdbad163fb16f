// SPDX-License-Identifier: Apache-2.0
// `legwright modules`: the library as a table, a module with its sources, pictures.
#include <gtest/gtest.h>

#include <sstream>

#include "tests/tools/modules/servo_text.hpp"
#include "tests/tools/verbs/program.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::call;
using test::contains;
using test::Outcome;

TEST(Modules, ListsTheLibraryWithinAHundredColumns) {
  const Outcome told = call({"modules"});
  EXPECT_EQ(told.code, 0) << told.err;
  std::istringstream lines(told.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
  EXPECT_TRUE(contains(told.out, "XL430-W250    ROBOTIS     57.2  28.5 x 46.5 x 34      11.1"))
      << told.out;
  EXPECT_TRUE(contains(told.out, "ball_foot_12"));
}

TEST(Modules, TellsWhereEachFigureIsFrom) {
  const Outcome told = call({"modules", "xl430-w250"});
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_TRUE(contains(told.out, "joint.no_load_speed      5.969 rad/s, 57 rev/min")) << told.out;
  EXPECT_TRUE(contains(told.out, "https://emanual.robotis.com/docs/en/dxl/x/xl430-w250/"));
  EXPECT_TRUE(contains(told.out, "not known\n  joint.continuous_torque, joint.friction"));
  EXPECT_TRUE(contains(told.out, "assumed\n  attachment.screws: ")) << told.out;
  EXPECT_TRUE(contains(told.out, "\n  joint.position: not of a drawing")) << told.out;
}

TEST(Modules, ReadsAFolderOfOnesOwn) {
  const test::TemporaryFolder folder;
  write_file(folder.path() / "hs1.toml", test::kWholeServo);
  const Json json =
      Json::parse(call({"modules", "HS-1", "--library", folder.path().string(), "--json"}).out);
  ASSERT_EQ(json["modules"].size(), 1u);
  EXPECT_EQ(json["modules"][0]["joint"]["stall_torque_nm"], 1.1);
  EXPECT_EQ(json["modules"][0]["sources"][0]["note"], "of 2020");
  const Outcome typo = call({"modules", "HS-2", "--library", folder.path().string()});
  EXPECT_EQ(typo.code, 2);
  EXPECT_TRUE(contains(typo.err, "did you mean 'HS-1'?")) << typo.err;
  write_file(folder.path() / "hs1.toml", "name = \"HS-1\"\n");
  const Outcome broken = call({"modules", "--library", folder.path().string()});
  EXPECT_EQ(broken.code, 2);
  EXPECT_TRUE(contains(broken.err, "hs1.toml") && contains(broken.err, "kind: is missing"))
      << broken.err;
  EXPECT_EQ(call({"modules", "--library", (folder.path() / "gone").string()}).code, 3);
}

/// Beside an assembly that is built of it, which the library passes over.
TEST(Modules, AndRobotsOfThemTellFiguresThatAreHardlyMeant) {
  const test::TemporaryFolder folder;
  std::string servo = test::kWholeServo;
  servo.replace(servo.find("stall_torque = 1.1"), 18, "stall_torque = 110");
  write_file(folder.path() / "hs1.toml", servo);
  const fs::path dog = folder.path() / "dog.toml";
  write_file(dog, R"(servo = "HS-1"
[trunk]
size = [0.2, 0.09, 0.04]
mass = 250
[[limb]]
names = ["F", "H"]
hip = [0.09, 0.07, 0.0]
step = [-0.18, 0.0, 0.0]
copies = 2
mirror = "y"
foot = "ball_foot_12"
foot_offset = [0.0, 0.0, -0.09]
joint = [{ name = "hip", axis = [0, 1, 0] },
         { name = "knee", axis = [0, 1, 0], offset = [0.0, 0.0, -0.09] }]
)");
  const std::string library = folder.path().string();
  const std::string torque = "110 N cm are 1.1 N m", mass = "dog.toml:4: trunk.mass: is 250 kg";
  EXPECT_TRUE(contains(call({"modules", "--library", library}).out, torque));
  const auto build = [&](const char* name, const std::vector<std::string>& more) {
    std::vector<std::string> words{"build", dog.string(), "--library",
                                   library, "-o",         (folder.path() / name).string()};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome told = call(words);
    EXPECT_EQ(told.code, 0) << told.err;
    return told.out;
  };
  const std::string told = build("a.xml", {});
  EXPECT_TRUE(contains(told, "warning  " + (folder.path() / "hs1.toml").string())) << told;
  EXPECT_TRUE(contains(told, torque) && contains(told, mass)) << told;
  const Json json = Json::parse(build("b.xml", {"--json"}));
  ASSERT_EQ(json["warnings"].size(), 2u);
  EXPECT_TRUE(contains(json["warnings"][1].get<std::string>(), mass)) << json["warnings"];
}

TEST(Modules, TellsItsKeys) {
  const Outcome told = call({"modules", "--keys"});
  EXPECT_EQ(told.code, 0);
  EXPECT_TRUE(contains(told.out, "\njoint.stall_torque = 1.4\n")) << told.out;
  const Json json = Json::parse(call({"modules", "--keys", "--json"}).out);
  EXPECT_EQ(json["keys"][0]["key"], "name");
}

TEST(Modules, DrawsAModule) {
  const test::TemporaryFolder folder;
  const fs::path drawn = folder.path() / "drawn";
  const Outcome told = call({"modules", "AK80-9", "--draw", drawn.string()});
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_GT(fs::file_size(drawn / "AK80-9.png"), 10000u);
  EXPECT_EQ(std::distance(fs::directory_iterator(drawn), fs::directory_iterator()), 1)
      << "nothing but the picture";
}

}  // namespace
}  // namespace legwright
