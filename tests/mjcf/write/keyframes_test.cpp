// SPDX-License-Identifier: Apache-2.0
// Keyframes of rewritten robots: the feet stay where they stood.
#include "mjcf/write/keyframes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mjcf/text/compile.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

/// Heights of the lowest points of the feet in a keyframe, as MuJoCo has them.
std::vector<double> foot_heights(const RobotModel& robot, const mjModel& model, int key) {
  const DataPointer data = kinematics_at(model, model.key_qpos + key * model.nq, "test");
  std::vector<double> heights;
  for (const Foot& foot : robot.morphology.feet) {
    const int geom = mj_name2id(&model, mjOBJ_GEOM, foot.name.c_str());
    heights.push_back(data->geom_xpos[3 * geom + 2] - model.geom_size[3 * geom]);
  }
  return heights;
}

double largest_gap(const std::vector<double>& a, const std::vector<double>& b) {
  double gap = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) gap = std::max(gap, std::abs(a[k] - b[k]));
  return gap;
}

/// The value of an attribute of the first <key>.
std::string key_text(const std::string& xml, const std::string& name) {
  const std::size_t begin = xml.find(name + "=\"", xml.find("<key ")) + name.size() + 2;
  return xml.substr(begin, xml.find('"', begin) - begin);
}

class Examples : public testing::TestWithParam<const char*> {};

TEST_P(Examples, FeetKeepTheirHeightAtRandomDesigns) {
  const std::string xml = test::example_robot(GetParam());
  const RobotModel robot = parse_robot(xml, GetParam());
  const ModelPointer before = compile_mjcf(xml, GetParam());
  const std::vector<double> wanted = foot_heights(robot, *before, 0);
  std::mt19937 random(31);
  int moved = 0, all_feet = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const VectorXd s = test::random_design(robot.space, random);
    const std::string text = rewrite_robot(robot, s);
    const ModelPointer after = compile_mjcf(text, GetParam());
    const std::vector<double> heights = foot_heights(robot, *after, 0);
    EXPECT_NEAR(*std::min_element(heights.begin(), heights.end()),
                *std::min_element(wanted.begin(), wanted.end()), 1e-9);
    all_feet += largest_gap(wanted, heights) < 1e-9;
    for (int j = 1; j < after->njnt; ++j) {  // within their ranges
      EXPECT_GE(after->key_qpos[after->jnt_qposadr[j]], after->jnt_range[2 * j]);
      EXPECT_LE(after->key_qpos[after->jnt_qposadr[j]], after->jnt_range[2 * j + 1]);
    }
    // Negative control: in the old keyframe they stand elsewhere.
    mju_copy(after->key_qpos, before->key_qpos, after->nq);
    moved += largest_gap(wanted, foot_heights(robot, *after, 0)) > 1e-4;
  }
  EXPECT_GE(all_feet, 36);  // else a leg's joints cannot reach the ground
  EXPECT_EQ(moved, 40);
}
INSTANTIATE_TEST_SUITE_P(Robots, Examples,
                         testing::Values("puppy", "piston_puppy", "quadruped", "hexapod", "biped"));

/// The puppy with front shanks of 10 cm instead of 8.
VectorXd longer(const RobotModel& robot) {
  VectorXd s = robot.space.initial();
  s[robot.space.find("front_shank_length")] = 0.1;
  return s;
}

TEST(Keyframes, WhatStaysKeepsItsTextAndMirrorImagesTheSameNumbers) {
  const std::string xml =
      test::with(test::example_robot("puppy"), "qpos=\"0 0 0.2045118502  1 0 0 0 ",
                 "qpos=\"0.0e0 0.000 0.2045118502  1.00 0 0 0 ");
  const RobotModel robot = parse_robot(xml, "puppy");
  const std::string text = key_text(rewrite_robot(robot, longer(robot)), "qpos");
  EXPECT_EQ(text.substr(0, 12), "0.0e0 0.000 ");
  EXPECT_NE(text.find("  1.00 0 0 0  "), std::string::npos) << text;
  const std::string angles = text.substr(text.find("0 0 0  ") + 7);
  const std::size_t second = angles.find("  "), third = angles.find("  ", second + 2);
  EXPECT_EQ(angles.substr(0, second), angles.substr(second + 2, third - second - 2)) << text;
}

TEST(Keyframes, ControlsOfPositionServosFollowTheirAngles) {
  const RobotModel robot = parse_robot(test::example_robot("puppy"), "puppy");
  const std::string text = rewrite_robot(robot, longer(robot));
  const std::string angles = key_text(text, "qpos");
  EXPECT_EQ(angles.substr(angles.find("0 0 0  ") + 7), key_text(text, "ctrl"));
  EXPECT_NE(key_text(text, "ctrl"), key_text(robot.xml, "ctrl"));
  // A motor's control is a torque, which stays.
  std::string motors = test::example_robot("puppy");
  for (std::size_t at = motors.find("<position name"); at != std::string::npos;
       at = motors.find("<position name", at))
    motors.replace(at, 9, "<motor forcerange=\"-3 3\"");
  const RobotModel with_motors = parse_robot(motors, "motors");
  EXPECT_EQ(key_text(rewrite_robot(with_motors, longer(with_motors)), "ctrl"),
            key_text(robot.xml, "ctrl"));
}

TEST(Keyframes, AServoOnATendonGetsItsLength) {
  const std::string xml = test::example_robot("piston_puppy");
  const RobotModel bare = parse_robot(xml, "piston");
  const ModelPointer model = compile_mjcf(xml, "piston");
  ASSERT_GT(model->ntendon, 0);
  std::string ctrl;
  const DataPointer data = kinematics_at(*model, model->key_qpos, "piston");
  mj_fwdPosition(model.get(), data.get());
  for (int i = 0; i < model->nactuator; ++i)
    ctrl += fmt::format("{:.6f} ", data->actuator_length[model->actuator_outadr[i]]);
  const std::string with_length =
      test::with(xml, "<key name=\"home\"", "<key name=\"home\" ctrl=\"" + ctrl + "\"");
  const RobotModel robot = parse_robot(with_length, "piston");
  std::mt19937 random(3);
  const ModelPointer after =
      compile_mjcf(rewrite_robot(robot, test::random_design(robot.space, random)), "piston");
  const DataPointer there = kinematics_at(*after, after->key_qpos, "piston");
  mj_fwdPosition(after.get(), there.get());
  double change = 0.0;
  for (int i = 0; i < after->nactuator; ++i) {
    const double length = there->actuator_length[after->actuator_outadr[i]];
    EXPECT_NEAR(after->key_ctrl[i], length, 2e-6);  // as written above, six digits
    change = std::max(change, std::abs(length - data->actuator_length[model->actuator_outadr[i]]));
  }
  EXPECT_GT(change, 1e-3);
}

/// Lies on its belly; jumps; is named by its controls alone; lies on its back.
/// A keyframe that was placed by eye: its own numbers for its own body, the ground for another.
TEST(Keyframes, FeetInTheGroundStandOnItWithAnotherBody) {
  for (const auto& [height, wanted] :
       {std::pair{"0.1975118502", 0.0}, std::pair{"0.2044118502", -1e-4}}) {  // 7 mm, 0.1 mm
    const std::string xml = test::with(test::example_robot("puppy"), "qpos=\"0 0 0.2045118502",
                                       std::string("qpos=\"0 0 ") + height);
    const RobotModel robot = parse_robot(xml, "puppy");
    EXPECT_EQ(rewrite_robot(robot, robot.space.initial()), xml);
    const ModelPointer after = compile_mjcf(rewrite_robot(robot, longer(robot)), "puppy");
    for (const double foot : foot_heights(robot, *after, 0)) EXPECT_NEAR(foot, wanted, 1e-6);
  }
}

TEST(Keyframes, FeetAreLiftedOutOfTheGroundHoweverDeep) {
  const std::string xml = test::example_robot("puppy");
  for (const double deep : {0.007, 0.15}) {
    const std::string height = fmt::format("qpos=\"0 0 {:.10g}", 0.2045118502 - deep);
    const RobotModel robot =
        parse_robot(test::with(xml, "qpos=\"0 0 0.2045118502", height), "puppy");
    const LiftedKeyframes raised = with_lifted_keyframes(robot);
    EXPECT_NEAR(raised.lifted, deep, 1e-6);
    const ModelPointer model = compile_mjcf(raised.files.text(), "puppy");
    for (const double foot : foot_heights(robot, *model, 0)) EXPECT_NEAR(foot, 0.0, 1e-6);
  }
  const RobotModel high =
      parse_robot(test::with(xml, "qpos=\"0 0 0.2045118502", "qpos=\"0 0 0.5"), "puppy");
  EXPECT_EQ(with_lifted_keyframes(high).lifted, 0.0) << "in the air it falls onto its feet";
}

TEST(Keyframes, WhereNoFootStandsNothingChanges) {
  const std::string xml = test::example_robot("puppy");
  const std::string angles = "0.5 -1 0.6 0.5 -1 0.6 0.5 -1 0.6 0.5 -1 0.6";
  for (const std::string& key :
       {"<key name=\"home\" qpos=\"0 0 0.02 1 0 0 0 " + angles + "\"/>",
        "<key name=\"home\" qpos=\"0 0 0.5 1 0 0 0 " + angles + "\"/>",
        "<key name=\"home\" qpos=\"0 0 0.2 0 1 0 0 " + angles + "\"/>",
        std::string("<key name=\"home\" ctrl=\"0 0 0 0 0 0 0 0 0 0 0 0\"/>")}) {
    const std::size_t begin = xml.find("<key "), end = xml.find("/>", begin) + 2;
    const std::string text = xml.substr(0, begin) + key + xml.substr(end);
    const RobotModel robot = parse_robot(text, "puppy");
    EXPECT_NE(rewrite_robot(robot, longer(robot)).find(key), std::string::npos) << key;
  }
}

TEST(Keyframes, EveryKeyIsChecked) {
  const std::string standing =
      "<key name=\"again\" qpos=\"1 2 0.2045118502 1 0 0 0 0.5 -1 0.6 0.5 -1 0.6 0.5 -1 0.6 0.5 -1 "
      "0.6\"/>";
  const RobotModel robot = parse_robot(
      test::with(test::example_robot("puppy"), "</keyframe>", standing + "</keyframe>"), "puppy");
  const ModelPointer after = compile_mjcf(rewrite_robot(robot, longer(robot)), "puppy");
  EXPECT_EQ(after->key_qpos[after->nq], 1.0);
  for (int k = 2; k < after->nq; ++k)
    EXPECT_NEAR(after->key_qpos[k], after->key_qpos[after->nq + k], 1e-9);
}

/// Joints that cannot turn: the trunk rises until the longest leg stands, the angles stay.
TEST(Keyframes, WithoutRangeOnlyTheTrunkRises) {
  std::string xml =
      test::with(test::example_robot("puppy"), "range=\"-2.6 2.6\"", "range=\"-2.6 2.6\" ");
  for (const auto& [joint, range] :
       {std::pair{"hip", "0.5 0.5001"}, std::pair{"knee", "-1 -0.9999"},
        std::pair{"ankle", "0.6 0.6001"}})
    for (const char* leg : {"FL", "FR", "HL", "HR"}) {
      const std::string name = std::string("name=\"") + leg + "_" + joint + "\"";
      xml =
          test::with(xml, "<joint " + name, "<joint range=\"" + std::string(range) + "\" " + name);
    }
  const RobotModel robot = parse_robot(xml, "stiff");
  const std::string text = rewrite_robot(robot, longer(robot));
  const std::string before = key_text(xml, "qpos"), after = key_text(text, "qpos");
  EXPECT_EQ(before.substr(before.find("  1 0 0 0")), after.substr(after.find("  1 0 0 0")));
  const std::vector<double> heights = foot_heights(robot, *compile_mjcf(text, "stiff"), 0),
                            wanted = foot_heights(robot, *compile_mjcf(xml, "stiff"), 0);
  EXPECT_NEAR(*std::min_element(heights.begin(), heights.end()), wanted[0], 1e-9);
  EXPECT_GT(largest_gap(heights, wanted), 0.01);  // the hind feet hang in the air
}

TEST(Keyframes, AFootAtAnotherHeightIsFound) {
  const std::string xml = test::example_robot("puppy");
  const RobotModel robot = parse_robot(xml, "puppy");
  const auto file = load_xml(xml, "puppy");
  const ModelPointer model = compile_mjcf(xml, "puppy");
  std::vector<StandingKey> keys =
      solve_keyframes(robot, *file, *model, robot.space.initial(), KeyframeEffort::angles);
  ASSERT_EQ(keys.size(), 1u);
  EXPECT_EQ(find_lifted_foot(robot.structure, keys, *file, *model), "");
  keys[0].foot_height[2] += 1e-6;
  EXPECT_NE(find_lifted_foot(robot.structure, keys, *file, *model).find("foot HL"),
            std::string::npos);
  keys[0].every_foot = false;  // then the lowest counts
  EXPECT_EQ(find_lifted_foot(robot.structure, keys, *file, *model), "");
  for (double& height : keys[0].foot_height) height -= 1e-6;
  EXPECT_NE(find_lifted_foot(robot.structure, keys, *file, *model), "");
}

}  // namespace
}  // namespace legwright
