// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "mjcf/read/foot_words.hpp"
#include "mjcf/scene/played_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/robots/construction_robots.hpp"
#include "tests/mjcf/robots/robots.hpp"

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

TEST(Feet, OfTwoPlatesOfOneShapeTheFirstCounts) {
  const auto foot_of = [](const char* first, const char* second) {
    const auto plate = [](const char* height) {
      return std::string("<geom type=\"box\" size=\"0.02 0.003 0.01\" pos=\"0 0.02 ") + height +
             "\"/>";
    };
    return parse_robot(test::hopper_with(plate(first) + plate(second)), "robot.xml")
        .structure.feet[0]
        .geom;
  };
  EXPECT_EQ(foot_of("-0.2", "-0.2000000001"), foot_of("-0.2", "-0.2"));
  EXPECT_EQ(foot_of("-0.2", "-0.21"), foot_of("-0.2", "-0.2") + 1);
}

std::string fork_of(const std::string& shape) {
  return "<geom " + shape + " pos=\"0.01 0.02 -0.2\"/><geom " + shape +
         " pos=\"0.01 -0.03 -0.2\"/>";
}

TEST(Feet, OfAForkAreInTheMiddleOfItsPlates) {
  for (const auto& [shape, z, radius] :
       {std::tuple{"type=\"box\" size=\"0.02 0.003 0.01\"", -0.21, 0.0},
        std::tuple{"type=\"capsule\" size=\"0.005 0.02\"", -0.22, 0.005},
        std::tuple{"type=\"mesh\" mesh=\"shoe\"", -0.2, 0.0}}) {
    const std::string xml = test::hopper_with(fork_of(shape));
    const RobotModel robot = parse_robot(xml, "robot.xml");
    const Foot& foot = robot.morphology.feet[0];
    const double ahead = std::string(shape).find("shoe") != std::string::npos ? 0.02 : 0.01;
    EXPECT_LT((foot.position.at(VectorXd()) - Vector3d(ahead, -0.005, z)).norm(), 1e-7) << shape;
    EXPECT_EQ(foot.radius, radius) << shape;
    EXPECT_EQ(touching_part(robot, 0), "middle of 2 plates alike");
    const ModelPointer played = compile_mjcf(played_robot(robot, xml), "played.xml");
    EXPECT_EQ(played->ngeom, 2) << "physics keeps both";
    const int site = mj_name2id(played.get(), mjOBJ_SITE, "foot:shank");
    ASSERT_GE(site, 0);
    EXPECT_NEAR(played->site_pos[3 * site + 1], -0.005, 1e-12);
  }
  const std::string box = "<geom type=\"box\" size=\"0.02 0.003 0.01\" pos=\"0 ";
  for (const char* second : {"0.02 -0.2\"/>", "-0.02 -0.198\"/>", "-0.02 -0.2\" euler=\"0 0 1\"/>"})
    EXPECT_TRUE(parse_robot(test::hopper_with(box + "0.02 -0.2\"/>" + box + second), "robot.xml")
                    .structure.feet[0]
                    .others.empty())
        << second;  // there twice, higher, turned
}

/// Both plates keep their thickness, and go where the stretch takes their soles.
TEST(Feet, OfAForkStretchAsOne) {
  for (const char* shape : {"type=\"box\" size=\"0.02 0.003 0.01\"", "type=\"mesh\" mesh=\"shoe\"",
                            "type=\"cylinder\" size=\"0.02 0.01\""}) {
    const std::string custom =
        "<custom><numeric name=\"legwright/long\" data=\"LONG 0.1 0.4\"/>"
        "<text name=\"legwright/long\" data=\"m | stretch z: shank | l\"/></custom><keyframe>";
    const bool is_mesh = std::string(shape).find("shoe") != std::string::npos;
    const RobotModel robot =
        parse_robot(test::with(test::hopper_with(fork_of(shape)), "<keyframe>",
                               test::with(custom, "LONG", is_mesh ? "0.2" : "0.21")),
                    "robot.xml");
    const ModelPointer model =
        compile_mjcf(rewrite_robot(robot, VectorXd::Constant(1, 0.3)), "x");  // verifies the foot
    EXPECT_NEAR(model->geom_pos[2], model->geom_pos[5], 1e-12) << shape;
    EXPECT_LT(model->geom_pos[2], -0.25) << shape;
  }
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

/// A sole keeps its thickness while its place moves: the point where it touches goes with the body.
TEST(Feet, APointOfASoleIsAPointOfTheStretchedBody) {
  for (const char* foot :
       {"<geom type=\"box\" pos=\"0.05 0 -0.04\" size=\"0.06 0.03 0.015\"/>",
        "<geom type=\"box\" pos=\"0.05 0 -0.04\" euler=\"0 0.1 0.2\" size=\"0.06 0.03 0.015\"/>",
        "<geom type=\"capsule\" pos=\"0.02 0 -0.15\" size=\"0.01 0.02\"/>",
        "<geom type=\"cylinder\" pos=\"0.02 0 -0.1\" size=\"0.03 0.005\"/>",
        "<geom type=\"ellipsoid\" pos=\"0.03 0 -0.1\" size=\"0.05 0.03 0.02\"/>",
        "<frame pos=\"0.02 0 -0.05\" euler=\"0 0 1\"><geom type=\"box\" size=\"0.05 0.03 "
        "0.01\"/></frame>"})
    for (const bool printed : {false, true}) {
      std::string xml = test::hopper_with(foot);
      const std::size_t inertial = xml.rfind("<inertial");
      if (printed) xml.erase(inertial, xml.find("/>", inertial) + 2 - inertial);
      const RobotModel bare = parse_robot(xml, "robot.xml");
      const Vector3d point = bare.morphology.feet[0].position.constant;
      xml = test::with(
          xml, "<keyframe>",
          fmt::format("<custom><numeric name=\"legwright/long\" data=\"{0} {1} {2}\"/>"
                      "<text name=\"legwright/long\" data=\"m | stretch link: shank | l\"/>"
                      "</custom><keyframe>",
                      point.norm(), 0.75 * point.norm(), 1.25 * point.norm()));
      const RobotModel robot = parse_robot(xml, "robot.xml");
      for (const VectorXd& s : {robot.space.lower(), robot.space.upper()}) {
        std::string text;
        ASSERT_NO_THROW(text = rewrite_robot(robot, s)) << foot << printed;
        const RobotModel read = parse_robot(text, "robot.xml", &robot.structure);
        EXPECT_LT((read.morphology.feet[0].position.at(s) - point * s[0] / point.norm()).norm(),
                  1e-9)
            << foot;
      }
    }
}

TEST(Feet, OfARodThatIsNotLevelTheLowerEndTouches) {
  const auto foot = [](const std::string& type, double tilt, double x = 0.0) {
    const std::string geom =
        fmt::format("<geom type=\"{}\" pos=\"{} 0 -0.2\" euler=\"0 {} 0\" size=\"0.02 0.1\"/>",
                    type, x, std::numbers::pi / 2 + tilt);
    return parse_robot(test::hopper_with(geom), "robot.xml").morphology.feet[0];
  };
  for (const char* type : {"capsule", "cylinder"}) {
    EXPECT_NEAR(foot(type, 0.02).position.constant.x(), 0.0, 1e-9) << type;  // level
    EXPECT_NEAR(foot(type, 0.19).position.constant.x(), 0.1 * std::cos(0.19), 1e-9) << type;
    EXPECT_NEAR(foot(type, -0.19).position.constant.x(), -0.1 * std::cos(0.19), 1e-9) << type;
    EXPECT_EQ(foot(type, 0.19).radius, 0.02) << type;
  }
}

TEST(Feet, ALinkThatLiesTouchesAtItsFarEnd) {
  const auto at = [](const char* rod) {
    return parse_robot(test::hopper_with(rod), "robot.xml")
        .morphology.feet[0]
        .position.constant.x();
  };
  EXPECT_NEAR(at("<geom type=\"capsule\" fromto=\"0 0 0 0.2 0 0\" size=\"0.02\"/>"), 0.2, 1e-9);
  EXPECT_NEAR(at("<geom type=\"capsule\" fromto=\"0.2 0 0 0 0 0\" size=\"0.02\"/>"), 0.2, 1e-9);
  // Under the ankle it is a sole, which touches with both ends.
  EXPECT_NEAR(at("<geom type=\"capsule\" fromto=\"-0.05 0 -0.03 0.1 0 -0.03\" size=\"0.02\"/>"),
              0.025, 1e-9);
}

TEST(Feet, BallsThatTouchTogetherAreOneFootInTheirMiddle) {
  const std::string heel =
                        "<geom size=\"0.01\" pos=\"-0.05 0.02 -0.2\"/>"
                        "<geom size=\"0.01\" pos=\"-0.05 -0.02 -0.2\"/>",
                    toes =
                        "<geom size=\"0.01\" pos=\"0.1 0.03 -0.2\"/>"
                        "<geom size=\"0.01\" pos=\"0.1 -0.03 -0.2\"/>";
  const RobotModel robot = parse_robot(test::hopper_with(heel + toes), "robot.xml");
  const Foot& foot = robot.morphology.feet[0];
  EXPECT_LT((foot.position.constant - Vector3d(0.025, 0, -0.2)).norm(), 1e-9);
  EXPECT_EQ(foot.radius, 0.01);
  EXPECT_EQ(robot.structure.feet[0].others.size(), 3u);
  const ModelPointer played = compile_mjcf(played_robot(robot, robot.xml), "played.xml");
  const int site = mj_name2id(played.get(), mjOBJ_SITE, ("foot:" + foot.name).c_str());
  ASSERT_GE(site, 0);
  EXPECT_NEAR(played->site_pos[3 * site], 0.025, 1e-9);
  // A heel that is lower is the foot alone.
  const RobotModel tilted = parse_robot(test::hopper_with(heel + toes, 0.1), "robot.xml");
  EXPECT_EQ(tilted.structure.feet[0].others.size(), 1u);
  EXPECT_NEAR(tilted.morphology.feet[0].position.constant.y(), 0.0, 1e-9);
}

TEST(Feet, PlusSignsAreReadAndStay) {
  const std::string plus = "<geom size=\"+0.02\" pos=\"+0.01 0 -0.2\"/>";
  const std::string xml = test::with(
      test::hopper_with(plus), "<keyframe>",
      "<custom><numeric name=\"legwright/long\" data=\"0.2 0.1 0.4\"/>"
      "<text name=\"legwright/long\" data=\"m | stretch z: shank | l\"/></custom><keyframe>");
  const RobotModel robot = parse_robot(xml, "robot.xml");
  EXPECT_EQ(robot.morphology.feet[0].radius, 0.02);
  EXPECT_TRUE(test::holds(rewrite_robot(robot, robot.space.upper()),
                          "<geom size=\"+0.02\" pos=\"+0.01 0 -0.4\"/>"));
}

TEST(Feet, NamesThatAreTakenAreNotTakenAgain) {
  const std::string xml = test::with(test::hopper_with("<geom size=\"0.02\" pos=\"0 0 -0.2\"/>"),
                                     "<body name=\"thigh\">",
                                     "<geom name=\"shank\" size=\"0.01\"/><body name=\"thigh\">");
  EXPECT_EQ(parse_robot(xml, "robot.xml").morphology.feet[0].name, "shank_foot");
}

}  // namespace
}  // namespace legwright
