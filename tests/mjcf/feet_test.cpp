// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "mjcf/compile.hpp"
#include "mjcf/played_robot.hpp"
#include "mjcf/rewrite_robot.hpp"
#include "tests/mjcf/construction_robots.hpp"
#include "tests/mjcf/robots.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

struct FootCase {
  const char* text;
  Vector3d position;  // in the shank's frame
  double radius;
};

TEST(Feet, OfEveryShapeTouchWhereTheyAreLowest) {
  const double r = std::sqrt(0.5);
  const FootCase cases[] = {
      {"<geom size=\"0.02\" pos=\"0.01 0 -0.2\"/>", {0.01, 0, -0.2}, 0.02},
      {"<geom type=\"capsule\" fromto=\"0 0 0 0.01 0 -0.2\" size=\"0.015\"/>",
       {0.01, 0, -0.2},
       0.015},
      {"<geom type=\"capsule\" pos=\"0 0 -0.15\" size=\"0.02 0.05\"/>", {0, 0, -0.2}, 0.02},
      {"<geom type=\"capsule\" pos=\"0 0 -0.2\" euler=\"1.5707963267948966 0 0\" size=\"0.02 "
       "0.05\"/>",
       {0, 0, -0.2},
       0.02},
      {"<geom type=\"box\" pos=\"0.02 0 -0.19\" size=\"0.05 0.03 0.01\"/>", {0.02, 0, -0.2}, 0},
      {"<geom type=\"box\" pos=\"0 0 -0.2\" euler=\"0 0.7853981633974483 0\" size=\"0.02 0.03 "
       "0.02\"/>",
       {0, 0, -0.2 - 0.04 * r},
       0},
      {"<geom type=\"cylinder\" pos=\"0 0.01 -0.15\" size=\"0.03 0.05\"/>", {0, 0.01, -0.2}, 0},
      {"<geom type=\"cylinder\" pos=\"0 0 -0.2\" euler=\"1.5707963267948966 0 0\" size=\"0.04 "
       "0.01\"/>",
       {0, 0, -0.2},
       0.04},
      {"<geom type=\"ellipsoid\" pos=\"0 0 -0.18\" size=\"0.05 0.03 0.02\"/>", {0, 0, -0.2}, 0},
      {"<geom type=\"mesh\" mesh=\"shoe\" pos=\"0 0 -0.2\"/>", {0.01, 0, -0.2}, 0},
      {"<site pos=\"0.02 0 -0.2\" size=\"0.012\"/>", {0.02, 0, -0.2}, 0.012}};
  for (const FootCase& one : cases) {
    const std::string xml = test::hopper_with(one.text);
    const RobotModel robot = parse_robot(xml, "robot.xml");
    ASSERT_EQ(robot.morphology.feet.size(), 1u);
    const Foot& foot = robot.morphology.feet[0];
    EXPECT_EQ(foot.name, "shank");
    EXPECT_LT((foot.position.at(VectorXd()) - one.position).norm(), 1e-7) << one.text;
    EXPECT_EQ(foot.radius, one.radius) << one.text;
    const ModelPointer played = compile_mjcf(played_robot(robot, xml), "played.xml");
    const int geom = mj_name2id(played.get(), mjOBJ_GEOM, "shank");
    ASSERT_GE(geom, 0) << one.text;
    EXPECT_TRUE(played->geom_contype[geom]);
    // Tools measure at this site, or at the ball's middle where there is none.
    const int site = mj_name2id(played.get(), mjOBJ_SITE, "foot:shank");
    const Vector3d marked =
        Vector3d::Map(site >= 0 ? played->site_pos + 3 * site : played->geom_pos + 3 * geom);
    EXPECT_LT((marked - one.position).norm(), 1e-7) << one.text;
    EXPECT_EQ(site < 0, played->geom_type[geom] == mjGEOM_SPHERE) << one.text;
    EXPECT_EQ(played->body_subtreemass[0], compile_mjcf(xml, "x")->body_subtreemass[0]);
  }
}

TEST(Feet, TheLowestCollidingGeomIsItAndABallBeforeItsLike) {
  const auto name = [](const std::string& foot) {
    return parse_robot(test::hopper_with(foot), "robot.xml").morphology.feet[0].name;
  };
  const std::string
      ball = "<geom name=\"ball\" size=\"0.02\" pos=\"0 0 -0.2\"/>",
      hull = "<geom name=\"hull\" type=\"box\" size=\"0.03 0.03 0.11\" pos=\"0 0 -0.115\"/>",
      drawn =
          "<geom name=\"drawn\" size=\"0.1\" pos=\"0 0 -0.3\" contype=\"0\" conaffinity=\"0\"/>";
  EXPECT_EQ(name(hull + ball + drawn), "ball");  // 5 mm higher than the hull
  EXPECT_EQ(name(test::with(hull, "0.11\"", "0.13\"") + ball), "hull");
}

TEST(Feet, KeepTheirPlaceWhenTheLegTurnsAndStretches) {
  // Turned far, another face of the box would be the lowest at home.
  std::string xml =
      test::hopper_with("<geom type=\"box\" pos=\"0.02 0 -0.1\" size=\"0.05 0.03 0.1\"/>", 0.2);
  xml = test::with(
      xml, "<keyframe>",
      "<custom><numeric name=\"legwright/yaw\" data=\"0 -1.5 1.5\"/>"
      "<text name=\"legwright/yaw\" data=\"rad | axis z: knee | y\"/>"
      "<numeric name=\"legwright/long\" data=\"0.2 0.1 0.4\"/>"
      "<text name=\"legwright/long\" data=\"m | stretch z: shank | l\"/></custom><keyframe>");
  xml = test::with(xml, "0 0.2\"/></keyframe>", "0 1.1\"/></keyframe>");
  const RobotModel robot = parse_robot(xml, "robot.xml");
  std::mt19937 random(8);
  for (int trial = 0; trial < 20; ++trial) {
    const VectorXd s = test::random_design(robot.space, random);
    const std::string text = rewrite_robot(robot, s);  // verifies the foot
    const ModelPointer model = compile_mjcf(text, "x");
    EXPECT_NEAR(robot.morphology.feet[0].position.at(s).z(),
                model->geom_pos[2] - model->geom_size[2], 1e-11);
  }
}

TEST(Feet, NamesThatAreTakenAreNotTakenAgain) {
  const std::string xml = test::with(test::hopper_with("<geom size=\"0.02\" pos=\"0 0 -0.2\"/>"),
                                     "<body name=\"thigh\">",
                                     "<geom name=\"shank\" size=\"0.01\"/><body name=\"thigh\">");
  EXPECT_EQ(parse_robot(xml, "robot.xml").morphology.feet[0].name, "shank_foot");
}

}  // namespace
}  // namespace legwright
