// SPDX-License-Identifier: Apache-2.0
#include "tools/modules/assembly_file.hpp"

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>

#include "mjcf/assembly/assembly_names.hpp"
#include "mjcf/text/input_error.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/support/source_tree.hpp"
#include "tests/tools/modules/installed_modules.hpp"
#include "tests/tools/modules/told.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/task/task_text.hpp"

namespace legwright {
namespace {

/// Every key is given, but trunk.module, which stands for size and mass.
const std::string kWholeAssembly = R"(name = "dog"
servo = "XL430-W250"
torque = "stall"
torque_share = 0.8
armature = 0.004
contacts = "all"
[trunk]
size = [0.2, 0.09, 0.04]
mass = 0.25
[[part]]
module = "lipo_3s_2200"
position = [0.0, 0.0, 0.01]
[link]
shape = "hull"
radius = 0.006
wall = 0.004
clearance = 0.002
density = 1240.0
[[limb]]
name = "leg"
names = ["F", "H"]
hip = [0.09, 0.07, 0.0]
step = [-0.18, 0.0, 0.0]
copies = 2
mirror = "y"
foot = "ball_foot_12"
foot_offset = [0.0, 0.0, -0.09]
[[limb.joint]]
name = "hip"
link = "thigh"
axis = [0, 2, 0]
[[limb.joint]]
name = "knee"
link = "shank"
axis = [0, 1, 0]
offset = [0.0, 0.0, -0.08]
servo = "XM430-W350"
range = [-1.5, 1.5]
roll = 0.1
)";

std::string complaint_about(const std::string& text) {
  try {
    (void)parse_assembly(text, "dog.toml", test::installed_modules());
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string assembly_with(const std::string& part, const std::string& by) {
  return test::with(kWholeAssembly, part, by);
}

void expect_complaint(const std::string& text, const std::string& part) {
  test::expect_told(complaint_about(text), part);
}

TEST(AssemblyFile, ReadsAWholeAssembly) {
  const Assembly dog = parse_assembly(kWholeAssembly, "x.toml", test::installed_modules());
  EXPECT_EQ(dog.name, "dog");
  EXPECT_EQ(dog.torque_share, 0.8);
  EXPECT_EQ(dog.armature, 0.004);
  EXPECT_EQ(dog.trunk.mass, 0.25);
  ASSERT_EQ(dog.parts.size(), 1u);
  EXPECT_EQ(dog.parts[0].module.kind, ModuleKind::battery);
  ASSERT_EQ(dog.limbs.size(), 1u);
  EXPECT_EQ(dog.link_shape, LinkShape::hull);
  EXPECT_EQ(dog.link_wall, 0.004);
  EXPECT_EQ(dog.link_clearance, 0.002);
  const AssemblyLimb& leg = dog.limbs[0];
  EXPECT_EQ(leg.names, (std::vector<std::string>{"F", "H"}));
  EXPECT_TRUE(leg.mirrored);
  EXPECT_EQ(leg.foot.name, "ball_foot_12");
  ASSERT_EQ(leg.joints.size(), 2u);
  EXPECT_EQ(leg.joints[0].servo.name, "XL430-W250") << "that of the file";
  EXPECT_EQ(leg.joints[0].axis, Eigen::Vector3d::UnitY()) << "of length 1";
  EXPECT_EQ(leg.joints[1].servo.name, "XM430-W350") << "its own";
  EXPECT_EQ(leg.joints[1].link, "shank");
  EXPECT_EQ((*leg.joints[1].range)[1], 1.5);
  const std::vector<PlacedLimb> limbs = placed_limbs(dog);
  ASSERT_EQ(limbs.size(), 4u);
  EXPECT_EQ(limbs[3].name, "HR");
  EXPECT_EQ(limbs[3].hip, Eigen::Vector3d(-0.09, -0.07, 0.0));
}

TEST(AssemblyFile, ExamplesAreReadInTwentyLines) {
  for (const char* name : {"puppy", "hexapod"}) {
    const auto file = test::kExamples / "assemblies" / (std::string(name) + ".toml");
    const std::string text = read_file(file);
    EXPECT_EQ(parse_assembly(text, file, test::installed_modules()).name, name) << "after its file";
    int lines = 0;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines += !line.empty() && line[0] != '#';
    EXPECT_LE(lines, 20) << name;
  }
}

TEST(AssemblyFile, TakesATrunkFromTheLibrary) {
  const std::string text =
      assembly_with("size = [0.2, 0.09, 0.04]\nmass = 0.25", "module = \"plate_200x100\"");
  EXPECT_EQ(parse_assembly(text, "x.toml", test::installed_modules()).trunk.name, "plate_200x100");
  expect_complaint(assembly_with("mass = 0.25", "mass = 0.25\nmodule = \"plate_200x100\""),
                   "trunk.module: stands beside size or mass");
  expect_complaint(assembly_with("mass = 0.25\n", ""), "trunk.mass: is missing");
}

TEST(AssemblyFile, LinksMayBeCapsules) {
  const std::string text =
      assembly_with("shape = \"hull\"\nradius = 0.006\nwall = 0.004\nclearance = 0.002\n",
                    "shape = \"capsule\"\n");
  EXPECT_EQ(parse_assembly(text, "x.toml", test::installed_modules()).link_shape,
            LinkShape::capsule);
  expect_complaint(assembly_with("shape = \"hull\"", "shape = \"capsule\""),
                   "link.wall: is of hulls; take it out");
  expect_complaint(assembly_with("shape = \"hull\"", "shape = \"box\""),
                   "expected \"hull\" or \"capsule\"");
}

TEST(AssemblyFile, MayBeToBePrinted) {
  const auto read = [&](const std::string& tables) {
    return parse_assembly(assembly_with("[link]\n", tables + "[link]\n"), "x.toml",
                          test::installed_modules());
  };
  EXPECT_FALSE(read("").print);
  EXPECT_EQ(read("[print]\n").print.value().bed, PrintLimits{}.bed);
  EXPECT_EQ(read("[print]\nbed = [0.18, 0.2]\n").print.value().bed, Eigen::Vector2d(0.18, 0.2));
  EXPECT_EQ(read("[print]\n").print.value().margin, 0.004) << "free of a skirt";
  EXPECT_EQ(read("[print]\nmargin = 0\n").print.value().margin, 0.0);
  expect_complaint(
      assembly_with("[link]\n", "[print]\nmargin = 0.11\n[link]\n"),
      "print.margin: a margin of 0.11 m at each side of a bed of 0.22 x 0.22 m leaves no");
  expect_complaint(assembly_with("[link]\n", "[print]\nbed = [0.18]\n[link]\n"), "print.bed");
  expect_complaint(assembly_with("[link]\n", "[print]\nwall = 0.1\n[link]\n"), "print.wall");
  expect_complaint(
      assembly_with("shape = \"hull\"\nradius = 0.006\nwall = 0.004\nclearance = 0.002\n",
                    "shape = \"capsule\"\n[print]\n"),
      "print: is of hulls; take it out, or let [link] shape be \"hull\"");
}

TEST(AssemblyFile, OffersTheNearestModule) {
  expect_complaint(assembly_with("\"XL430-W250\"", "\"XL430-W25\""),
                   "dog.toml:2: servo: names \"XL430-W25\", which is not in the library; did you "
                   "mean \"XL430-W250\"?");
  expect_complaint(assembly_with("\"ball_foot_12\"", "\"lipo_3s_2200\""),
                   "limb.foot: names \"lipo_3s_2200\", which is a battery; expected a foot");
  expect_complaint(assembly_with("module = \"lipo_3s_2200\"", "module = \"AX-12A\""),
                   "part.module: names \"AX-12A\", a servo");
  expect_complaint(assembly_with("module = \"lipo_3s_2200\"", "module = \"jetson_orin_nan\""),
                   "did you mean \"jetson_orin_nano\"?");
  expect_complaint(assembly_with("servo = \"XL430-W250\"\n", ""), "limb.joint.servo: is missing");
}

TEST(AssemblyFile, RefusesLimbsThatDoNotFit) {
  expect_complaint(assembly_with("[\"F\", \"H\"]", "[\"F\"]"),
                   "limb.names: has 1 names for 2 limbs");
  expect_complaint(assembly_with("[\"F\", \"H\"]", "[\"F\", \"F\"]"),
                   "limb.names: has \"F\" a second time");
  expect_complaint(assembly_with("hip = [0.09, 0.07, 0.0]", "hip = [0.09, 0.0, 0.0]"),
                   "limb.mirror: leaves the hip where it is");
  expect_complaint(assembly_with("mirror = \"y\"", "mirror = \"x\""), "expected \"y\"");
  expect_complaint(assembly_with("step = [-0.18, 0.0, 0.0]\n", ""), "limb.step: is missing");
  expect_complaint(assembly_with("offset = [0.0, 0.0, -0.08]\n", ""),
                   "limb.joint.offset: is missing");
  expect_complaint(assembly_with("axis = [0, 2, 0]", "axis = [0, 2, 0]\noffset = [0, 0, 1]"),
                   "limb.joint.offset: is of the first joint");
  expect_complaint(assembly_with("axis = [0, 2, 0]", "axis = [0, 0, 0]"), "has no length");
  expect_complaint(assembly_with("range = [-1.5, 1.5]", "range = [1.5, -1.5]"),
                   "limb.joint.range: is [1.5, -1.5]; expected the lesser angle first");
  expect_complaint(assembly_with("name = \"knee\"", "name = \"hip\""),
                   "limb.joint.name: is \"hip\" a second time in this limb");
  expect_complaint(assembly_with("\"shank\"", "\"thigh\""), "limb.joint.link: is \"thigh\"");
  expect_complaint(assembly_with("\"shank\"", "\"hip_servo\""), "none that ends in _servo");
  std::string twins = kWholeAssembly.substr(kWholeAssembly.find("[[limb]]"));
  twins.replace(twins.find("[\"F\", \"H\"]"), 10, "[\"FL\", \"HX\"]");
  twins.erase(twins.find("mirror = \"y\"\n"), 13);
  expect_complaint(kWholeAssembly + twins, "dog.toml:40: limb: makes \"FL\" a second time");
  expect_complaint(assembly_with("name = \"dog\"", "name = \"a dog\""), "expected letters");
  expect_complaint(assembly_with("foot_offset = [0.0, 0.0, -0.09]", "foot_offset = [0, 0, 0]"),
                   "limb.foot_offset: has no length");
  expect_complaint(assembly_with("torque = \"stall\"", "torque = \"peak\""),
                   "expected \"stall\" or \"continuous\"");
  expect_complaint("name = \"a\"\n", "limb: is missing");
  expect_complaint(assembly_with("mirror", "miror"), "did you mean 'limb.mirror'?");
}

/// The assembly with a second limb, of which all copies have their own names.
std::string with_second_limb(const std::string& names, const std::string& hip) {
  std::string limb = kWholeAssembly.substr(kWholeAssembly.find("[[limb]]"));
  const auto put = [&](const std::string& part, const std::string& by) {
    limb.replace(limb.find(part), part.size(), by);
  };
  put("[\"F\", \"H\"]", names);
  put("[0.09, 0.07, 0.0]", hip);
  return kWholeAssembly + limb;
}

int count_of(const std::string& part, const std::string& text) {
  int count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++count;
  return count;
}

TEST(AssemblyFile, RefusesHipsInOnePlace) {
  EXPECT_EQ(complaint_about(with_second_limb("[\"A\", \"B\"]", "[0.09, 0.1, 0.0]")), "");
  const std::string near = assembly_with("hip = [0.09, 0.07, 0.0]", "hip = [0.09, 1e-12, 0.0]");
  expect_complaint(near, "limb.mirror: leaves the hip where it is");
  const std::string step = assembly_with("step = [-0.18, 0.0, 0.0]", "step = [0, 0, 0]");
  expect_complaint(step, "dog.toml:23: limb.step: has no length, which puts all copies in one");
  for (const std::string& text : {near, step})
    EXPECT_EQ(complaint_about(text).find("puts the hips of"), std::string::npos) << "told once";
  expect_complaint(assembly_with("step = [-0.18, 0.0, 0.0]", "step = [0.0, -0.14, 0.0]"),
                   "puts the hips of \"FR\" and \"HR\" in one place, [0.09, -0.07, 0]");
  expect_complaint(with_second_limb("[\"A\", \"B\"]", "[0.09, 0.07, 0.0]"),
                   "puts the hips of \"FL\" and \"AL\" in one place");
}

/// A fault is told where it is, and not what follows from it.
TEST(AssemblyFile, TellsNothingThatFollowsFromWhatIsRefused) {
  const auto told_once = [](const std::string& text, const std::string& fault, int lines) {
    const std::string told = complaint_about(text);
    EXPECT_NE(told.find(fault), std::string::npos) << told;
    EXPECT_EQ(count_of("dog.toml:", told), lines) << told;
  };
  told_once(assembly_with("hip = [0.09, 0.07, 0.0]", "hip = [90, 0.07, 0.0]"),
            "dog.toml:22: limb.hip: is 90; expected -5 <= hip <= 5 m; 90 mm are 0.09 m", 1);
  told_once(assembly_with("step = [-0.18, 0.0, 0.0]\n", ""), "limb.step: is missing", 1);
  told_once(assembly_with("step = [-0.18, 0.0, 0.0]", "step = [-180, 0.0, 0.0]"),
            "limb.step: is -180; expected -5 <= step <= 5 m; -180 mm are -0.18 m", 1);
  told_once(assembly_with("[\"F\", \"H\"]", "[\"F\", \"F\"]"),
            "dog.toml:21: limb.names: has \"F\" a second time", 1);
  told_once(kWholeAssembly + kWholeAssembly.substr(kWholeAssembly.find("[[limb]]")),
            "dog.toml:42: limb.names: has \"H\" a second time", 2);
  std::string empty = kWholeAssembly.substr(0, kWholeAssembly.find("[[limb.joint]]"));
  told_once(empty + "joint = []\n",
            "limb.joint: is empty; expected one table at least: [[limb.joint]], or joint = [{…}]",
            1);
}

TEST(AssemblyFile, TakesItsNameFromTheFile) {
  const std::string text = assembly_with("name = \"dog\"\n", "");
  EXPECT_EQ(parse_assembly(text, "puppy.toml", test::installed_modules()).name, "puppy");
  try {
    (void)parse_assembly(text, "mein röbot.toml", test::installed_modules());
    FAIL();
  } catch (const InputError& error) {
    const std::string told = error.what();
    EXPECT_NE(told.find("name: is missing, and the file's name is \"mein röbot\"; expected "
                        "letters, digits, '_' and '-': add name = \"puppy\""),
              std::string::npos)
        << told;
  }
}

TEST(AssemblyFile, RefusesALinkWithoutLength) {
  const std::string text = assembly_with("offset = [0.0, 0.0, -0.08]", "offset = [0, 0, 0.0009]");
  expect_complaint(
      text, "dog.toml:36: limb.joint.offset: is shorter than 1 mm, which puts the joint into");
}

TEST(AssemblyFile, KnowsAtWhichLinesModulesStand) {
  const Assembly dog = parse_assembly(kWholeAssembly, "x.toml", test::installed_modules());
  EXPECT_EQ(dog.parts[0].line, 11);
  EXPECT_EQ(dog.limbs[0].line, 22);
  EXPECT_EQ(dog.limbs[0].joints[0].line, 29);
  EXPECT_EQ(dog.limbs[0].joints[1].line, 33);
}

TEST(AssemblyFile, RefusesNamesThatMeetInTheRobot) {
  const std::string alone = "mirror = \"y\"\n";
  std::string text = with_second_limb("[\"F_b\", \"X\"]", "[0.09, 0.1, 0.0]");
  for (std::size_t at; (at = text.find(alone)) != std::string::npos;) text.erase(at, alone.size());
  EXPECT_EQ(complaint_about(text), "");
  std::string joints = text;
  joints.replace(joints.find("\"knee\""), 6, "\"b_knee\"");
  expect_complaint(joints,
                   "would name joint \"b_knee\" of limb \"F\" and joint \"knee\" of limb \"F_b\" "
                   "alike, \"F_b_knee\"; give one of them another name");
  EXPECT_EQ(count_of("would name", complaint_about(joints)), 1) << "not of servos and links too";
  std::string links = text;
  links.replace(links.find("\"shank\""), 7, "\"b_shank\"");
  expect_complaint(links, "would name link \"b_shank\" of limb \"F\" and link \"shank\" of limb");
  // A foot of two shapes names the second after the limb.
  const ModuleFile* ball = test::installed_modules().find_or_null("ball_foot_12");
  ASSERT_NE(ball, nullptr);
  std::string feet = text;
  feet.replace(feet.find("\"F_b\""), 5, "\"F_2\"");
  Assembly dog = parse_assembly(feet, "dog.toml", test::installed_modules());
  EXPECT_TRUE(name_clashes(dog).empty());
  dog.limbs[0].foot.outline.push_back(ball->module.outline[0]);
  const std::vector<NameClash> clashes = name_clashes(dog);
  ASSERT_EQ(clashes.size(), 1u);
  EXPECT_EQ(clashes[0].name, "F_2");
  EXPECT_EQ(clashes[0].first, "shape 2 of the foot of limb \"F\"");
  EXPECT_EQ(clashes[0].second, "the foot of limb \"F_2\"");
}

TEST(AssemblyKeys, AreThoseOfTheReader) {
  std::set<std::string_view> seen;
  int checked = 0;
  for (const TaskKey& key : assembly_keys()) {
    EXPECT_TRUE(seen.insert(key.path).second) << key.path;
    EXPECT_TRUE(key.meaning.ends_with('.')) << key.path;
    if (key.forms[0].kind == KeyKind::tables || key.path == "trunk.module") continue;
    std::vector<std::string> path;
    std::string table(key.table());
    const std::string word(table.empty() ? key.path : key.path.substr(table.size() + 1));
    if (table == "limb.joint")
      path = {"limb", "0", "joint", "1"};
    else if (table == "limb" || table == "part")
      path = {table, "0"};
    else if (!table.empty())
      path = {table};
    path.push_back(word);
    const bool slides = word == "lever" || word == "mount";  // which servos have not
    const std::string whole =
        slides ? assembly_with("\"XM430-W350\"", "\"L16-50-35\"") : kWholeAssembly;
    const auto told = [&](const std::string& value) {
      return complaint_about(with_key(whole, path, value));
    };
    EXPECT_EQ(told(std::string(key.example)), "") << key.path;
    const bool is_text = key.forms[0].kind == KeyKind::text;
    EXPECT_NE(told(is_text ? "3" : "\"words\"").find(key.path), std::string::npos) << key.path;
    ++checked;
  }
  EXPECT_GE(checked, 25);
}

}  // namespace
}  // namespace legwright
