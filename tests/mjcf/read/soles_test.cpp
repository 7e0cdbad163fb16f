// SPDX-License-Identifier: Apache-2.0
// Which feet are flat, how their planes lie, and that no design tilts them.
#include "mjcf/read/soles.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "mjcf/propose/proposals.hpp"
#include "mjcf/read/foot_words.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "optimizer/design/kinematics.hpp"
#include "tests/mjcf/robots/construction_robots.hpp"
#include "tests/mjcf/robots/flat_biped.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using test::error_message;
using test::holds;

RobotModel biped(const test::FlatBiped& how) { return parse_robot(test::flat_biped(how), "r.xml"); }
RobotModel on(const std::string& foot) {
  test::FlatBiped how;
  how.foot = foot;
  return biped(how);
}

TEST(Soles, AreFacesThatTouch) {
  for (const test::NamedFoot& foot : test::flat_feet()) {
    const RobotModel robot = on(foot.geoms);
    ASSERT_EQ(robot.morphology.feet.size(), 2u) << foot.name;
    for (const FootContact& contact : robot.structure.feet) {
      ASSERT_TRUE(contact.normal) << foot.name;
      EXPECT_LT((*contact.normal - Vector3d::UnitZ()).norm(), 1e-12) << foot.name;
    }
    EXPECT_TRUE(stands_on_soles(robot.morphology)) << foot.name;
  }
  for (const test::NamedFoot& foot : test::pointed_feet()) {
    const RobotModel robot = on(foot.geoms);
    for (const FootContact& contact : robot.structure.feet)
      EXPECT_FALSE(contact.normal) << foot.name;
    EXPECT_FALSE(stands_on_soles(robot.morphology)) << foot.name;
  }
}

TEST(Soles, LieLevelInTheHomePose) {
  for (const test::NamedFoot& foot : test::flat_feet()) {
    const RobotModel robot = on(foot.geoms);
    const GeometryAtDesign geometry(robot.morphology, robot.space.initial());
    const PoseKinematics home = home_pose(robot.morphology, geometry);
    for (const Foot& own : robot.morphology.feet) {
      ASSERT_TRUE(own.sole) << foot.name;
      const Vector3d ahead = home.rotation(own.link) * own.sole->ahead,
                     beside = home.rotation(own.link) * own.sole->beside;
      EXPECT_NEAR(ahead.norm(), 1.0, 1e-12);
      EXPECT_NEAR(ahead.z(), 0.0, 1e-12) << foot.name;
      EXPECT_NEAR(beside.z(), 0.0, 1e-12) << foot.name;
      EXPECT_LT((ahead.cross(beside) - Vector3d::UnitZ()).norm(), 1e-12) << foot.name;
    }
  }
}

/// Whichever geom is the lowest one, a sole of several carries in the middle of all.
TEST(Soles, OfSeveralGeomsCarryInTheMiddleOfAll) {
  struct Parts {
    const char* geoms;
    double x, y;
  };
  const Parts parts[] = {
      {R"(<geom type="capsule" size="0.01" fromto="-0.04 0.03 -0.04 0.1 0.03 -0.04"/>
          <geom type="capsule" size="0.01" fromto="-0.04 -0.03 -0.04 0.1 -0.03 -0.04"/>)",
       0.03, 0.0},
      {R"(<geom type="capsule" size="0.01" fromto="-0.05 -0.03 -0.04 -0.05 0.03 -0.04"/>
          <geom type="capsule" size="0.01" fromto="0.09 -0.03 -0.04 0.09 0.03 -0.04"/>)",
       0.02, 0.0},
      {R"(<geom type="box" size="0.02 0.04 0.01" pos="-0.04 0 -0.04"/>
          <geom type="box" size="0.03 0.04 0.01" pos="0.09 0 -0.04"/>)",
       0.03, 0.0},
      {R"(<geom type="box" size="0.04 0.04 0.01" pos="0 0 -0.04"/>
          <body pos="0.08 0 0"><geom type="box" size="0.04 0.04 0.01" pos="0 0 -0.04"/></body>)",
       0.04, 0.0},
  };
  for (const Parts& own : parts) {
    const RobotModel robot = on(own.geoms);
    ASSERT_TRUE(stands_on_soles(robot.morphology)) << own.geoms;
    const GeometryAtDesign geometry(robot.morphology, robot.space.initial());
    const PoseKinematics home = home_pose(robot.morphology, geometry);
    for (int j = 0; j < 2; ++j) {
      const Foot& foot = robot.morphology.feet[static_cast<std::size_t>(j)];
      EXPECT_EQ(foot.radius, 0.0) << own.geoms;
      const Vector3d ankle = home.origin(foot.link),
                     from_ankle = foot_place(robot.morphology, geometry, home, j) - ankle;
      EXPECT_LT((from_ankle - Vector3d(own.x, own.y, -0.05)).norm(), 1e-9)
          << own.geoms << from_ankle.transpose();
    }
  }
  // A single box needs no such point: it carries in its own middle.
  const RobotModel box = biped({});
  EXPECT_FALSE(box.structure.feet[0].middle);
}

TEST(Soles, ThatAreDrawnAskewHaveNormalsOfTheirOwn) {
  for (const char* euler : {"0 0.05 0", "0.05 0 0"}) {
    const bool pitched = euler[2] == '0' && euler[3] == '.';
    const std::string foot =
        std::string(R"(<geom type="box" size="0.07 0.05 0.01" pos="0.02 0 -0.04" euler=")") +
        euler + "\"/>";
    const RobotModel robot = on(foot);
    ASSERT_TRUE(robot.structure.feet[0].normal) << euler;
    const Vector3d wanted = pitched ? Vector3d(std::sin(0.05), 0.0, std::cos(0.05))
                                    : Vector3d(0.0, -std::sin(0.05), std::cos(0.05));
    EXPECT_LT((*robot.structure.feet[0].normal - wanted).norm(), 1e-9) << euler;
    const Sole& sole = *robot.morphology.feet[0].sole;
    EXPECT_LT((sole.ahead.cross(sole.beside) - wanted).norm(), 1e-9);
  }
  // Balls below a longer plate are the sole, not the plate's corners besides.
  const RobotModel plated = on(R"(<geom type="box" size="0.09 0.025 0.0075" pos="0.04 0 -0.03"/>
                                  <geom size="0.01" pos="-0.04 0.025 -0.04"/>
                                  <geom size="0.01" pos="-0.04 -0.025 -0.04"/>
                                  <geom size="0.01" pos="0.115 0.025 -0.04"/>
                                  <geom size="0.01" pos="0.115 -0.025 -0.04"/>)");
  EXPECT_EQ(touching_part(plated, 0), "middle of 4 balls of 10 mm");
  EXPECT_TRUE(stands_on_soles(plated.morphology));
  // Long and thin ones too, and those of balls, by three degrees.
  for (const char* geoms : {R"(<geom type="box" size="0.1 0.035 0.0025" pos="0.02 0 -0.045"/>)",
                            R"(<geom size="0.005" pos="0.12 0.03 -0.045"/>
                               <geom size="0.005" pos="0.12 -0.03 -0.045"/>
                               <geom size="0.005" pos="-0.05 0.03 -0.045"/>
                               <geom size="0.005" pos="-0.05 -0.03 -0.045"/>)"})
    for (const double pitch : {0.0524, -0.0524}) {
      const RobotModel robot = on("<body euler=\"0 " + std::to_string(pitch) + " 0\">" + geoms +
                                  "<inertial pos=\"0 0 0\" mass=\"0.1\" "
                                  "diaginertia=\"1e-4 1e-4 1e-4\"/></body>");
      ASSERT_TRUE(robot.structure.feet[0].normal) << geoms << pitch;
      const Sole& sole = *robot.morphology.feet[0].sole;
      EXPECT_LT(
          (sole.ahead.cross(sole.beside) - Vector3d(std::sin(pitch), 0.0, std::cos(pitch))).norm(),
          1e-9)
          << geoms;
      EXPECT_EQ(touching_part(robot, 0),
                "middle of its sole, drawn 3.0 degrees askew and laid down");
    }
  // So much that it touches with an edge only.
  EXPECT_FALSE(on(R"(<geom type="box" size="0.07 0.05 0.01" pos="0.02 0 -0.04" euler="0 0.3 0"/>)")
                   .structure.feet[0]
                   .normal);
}

TEST(TouchingPart, SaysWithWhatAFootTouches) {
  const auto part = [](const std::string& foot) { return touching_part(on(foot), 0); };
  EXPECT_EQ(part(R"(<geom size="0.02" pos="0 0 -0.03"/>)"), "ball of 20 mm");
  EXPECT_EQ(part(R"(<geom type="box" size="0.07 0.05 0.01" pos="0 0 -0.04"/>)"),
            "middle of its sole");
  EXPECT_EQ(part(R"(<geom type="box" size="0.07 0.05 0.01" pos="0 0 -0.04" euler="0 0.2 0"/>)"),
            "face of a box, drawn 11.5 degrees askew");
  EXPECT_EQ(part(R"(<geom type="box" size="0.07 0.05 0.01" pos="0 0 -0.04" euler="0 0.5 0"/>)"),
            "edge of a box");
  EXPECT_EQ(part(R"(<geom type="box" size="0.07 0.05 0.01" pos="0 0 -0.04" euler="0.5 0.5 0"/>)"),
            "corner of a box");
  EXPECT_EQ(part(R"(<geom type="cylinder" size="0.02 0.01" pos="0 0 -0.04" euler="0 0.5 0"/>)"),
            "rim of a cylinder");
  EXPECT_EQ(part(R"(<geom type="ellipsoid" size="0.03 0.02 0.01" pos="0 0 -0.04"/>)"),
            "point of an ellipsoid");
}

TEST(Soles, NeedAnAnkleThatRolls) {
  test::FlatBiped how;
  EXPECT_EQ(biped(how).morphology.joint_count(), 12);
  EXPECT_TRUE(stands_on_soles(biped(how).morphology));
  how.ankle_roll = false;
  const RobotModel without = biped(how);
  EXPECT_EQ(without.morphology.joint_count(), 10);
  for (const FootContact& foot : without.structure.feet) EXPECT_FALSE(foot.normal);
  EXPECT_FALSE(stands_on_soles(without.morphology));
}

TEST(Soles, FourLeggedRobotsHaveNone) {
  for (const char* name : {"courser", "goat", "mule", "ox", "servo_dog", "strider", "octopod"})
    for (const Foot& foot :
         read_robot(test::source_path(std::string("tests/robots/") + name + "/robot.xml"))
             .morphology.feet)
      EXPECT_FALSE(foot.sole) << name;
}

TEST(NormalOfSole, NeedsAFaceNotALine) {
  const auto normal = [](double width, double bump) {
    std::vector<Vector3d> points;
    for (const double x : {-0.1, 0.1})
      for (const double y : {-width, width}) points.emplace_back(x, y, 0.0);
    points.back().z() = bump;
    return normal_of_sole(points);
  };
  EXPECT_TRUE(normal(0.05, 0.0));
  EXPECT_FALSE(normal(0.015, 0.0)) << "an edge";
  EXPECT_TRUE(normal(0.05, 0.005));
  EXPECT_FALSE(normal(0.05, 0.03)) << "no plane";
  EXPECT_FALSE(normal_of_sole({{0, 0, 0}, {1, 0, 0}}));
  EXPECT_FALSE(normal_of_sole({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}));
}

// Stretches.

/// Both feet stretched. @param direction link, x, y or z; @param length as the file has it [m]
std::string stretched_foot(const std::string& direction, double length, const std::string& foot) {
  test::FlatBiped how;
  how.foot = foot;
  how.custom = "\n    <numeric name=\"legwright/foot\" data=\"" + std::to_string(length) +
               " 0.01 0.2\"/>\n    <text name=\"legwright/foot\" data=\"m | stretch " + direction +
               ": left_foot right_foot | l\"/>";
  return test::flat_biped(how);
}

TEST(Soles, AreNotStretchedAskew) {
  const double askew = std::hypot(0.02, 0.05);
  const std::string error_of = error_message(stretched_foot("link", askew, test::FlatBiped{}.foot));
  EXPECT_TRUE(holds(error_of, ":5:")) << error_of;  // the line of the <text>
  EXPECT_TRUE(holds(error_of, "body 'left_foot' is a flat foot")) << error_of;
  EXPECT_EQ(error_message(stretched_foot("z", 0.05, test::FlatBiped{}.foot)), "");
  EXPECT_EQ(error_message(stretched_foot("x", 0.02, test::FlatBiped{}.foot)), "");
  // A ball has no plane that could tilt.
  EXPECT_EQ(
      error_message(stretched_foot("link", askew, R"(<geom size="0.02" pos="0.02 0 -0.05"/>)")),
      "");
  // Of a sole that is drawn askew x and z are oblique, too.
  const std::string rotated =
      R"(<geom type="box" size="0.07 0.05 0.01" pos="0.02 0 -0.04" euler="0 0.05 0"/>)";
  for (const char* direction : {"x", "z"})
    EXPECT_TRUE(holds(error_message(stretched_foot(direction, 0.05, rotated)), "is a flat foot"))
        << direction;
}

/// Normal of the plane through the first four balls of a foot, in the frame of its body.
Vector3d plane_of(const std::vector<Vector3d>& balls) {
  const auto normal = normal_of_sole(balls);
  EXPECT_TRUE(normal);
  return normal.value_or(Vector3d::Zero());
}

std::vector<Vector3d> balls_of(const mjModel& model, const char* foot) {
  const int body = mj_name2id(&model, mjOBJ_BODY, foot);
  std::vector<Vector3d> balls;
  for (int k = 0; k < model.body_geomnum[body]; ++k)
    balls.push_back(Vector3d::Map(model.geom_pos + 3 * (model.body_geomadr[body] + k)));
  return balls;
}

/// Feet of other measures on shanks of other lengths, below ankles whose axes are turned.
test::FlatBiped designed(const std::string& foot) {
  test::FlatBiped how;
  how.foot = foot;
  how.custom =
      R"(<numeric name="legwright/shank" data="0.25 0.2 0.3"/>
      <text name="legwright/shank" data="m | stretch link: left_shank right_shank | l"/>
      <numeric name="legwright/turn" data="0 -0.25 0.25"/>
      <text name="legwright/turn" data="rad | axis z: left_ankle_pitch ~right_ankle_pitch | a"/>)";
  return how;
}

/// Of both feet in the home pose [rad].
double most_tilted(const std::string& xml) {
  const ModelPointer model = compile_mjcf(xml, "r.xml");
  const DataPointer data = kinematics_at(*model, model->key_qpos, "r.xml");
  double most = 0.0;
  for (const char* foot : {"left_foot", "right_foot"}) {
    const mjtNum* axes = data->xmat + 9 * mj_name2id(model.get(), mjOBJ_BODY, foot);
    most = std::max(most, std::hypot(axes[2], axes[5]));
  }
  return most;
}

TEST(Soles, StandLevelAtHomeInEveryDesign) {
  const RobotModel flat = biped(designed(test::foot_geoms("box"))),
                   point = biped(designed(R"(<geom size="0.01" pos="0.02 0 -0.04"/>)"));
  EXPECT_EQ(rewrite_robot(flat, flat.space.initial()), flat.xml);
  std::mt19937 random(4);
  double tilted = 0.0;
  for (int k = 0; k < 6; ++k) {
    const VectorXd s = test::random_design(flat.space, random);
    EXPECT_LT(most_tilted(rewrite_robot(flat, s)), 1e-8) << s.transpose();
    tilted = std::max(tilted, most_tilted(rewrite_robot(point, s)));
  }
  EXPECT_GT(tilted, 0.02) << "a ball does not mind";
}

/// The biped of designed() with hinges that hardly turn from where they are at home.
std::string held_biped(const std::vector<std::pair<std::string, double>>& hinges) {
  std::string xml = test::flat_biped(designed(test::foot_geoms("box")));
  for (const char* side : {"left", "right"})
    for (const auto& [hinge, angle] : hinges) {
      const std::string joint = std::string("<joint name=\"") + side + "_" + hinge + "\" ";
      xml = test::with(xml, joint,
                       joint + "range=\"" + std::to_string(angle - 0.001) + " " +
                           std::to_string(angle + 0.001) + "\" ");
    }
  return xml;
}

double ankle_roll_at_home(const std::string& xml) {
  const ModelPointer model = compile_mjcf(xml, "r.xml");
  const int roll = mj_name2id(model.get(), mjOBJ_JOINT, "left_ankle_roll");
  return std::abs(model->key_qpos[model->jnt_qposadr[roll]]);
}

TEST(Soles, AreLaidDownAtHomeByTheHipWhereAnklesHardlyRoll) {
  const auto design = [](const std::string& xml) {
    const RobotModel robot = parse_robot(xml, "r.xml");
    return rewrite_robot(robot, Eigen::Vector2d(0.28, 0.25));
  };
  const std::string held = design(held_biped({{"ankle_roll", 0.0}}));
  EXPECT_LT(most_tilted(held), 1e-8);
  EXPECT_LT(ankle_roll_at_home(held), 0.001 + 1e-9);
  EXPECT_GT(ankle_roll_at_home(design(held_biped({}))), 0.005) << "which would have turned";
  // Where nothing is left to lay them down the robot stands all the same; rewrite_robot compares
  // its height.
  EXPECT_GT(most_tilted(design(
                held_biped({{"ankle_roll", 0.0}, {"roll", 0.0}, {"yaw", 0.0}, {"pitch", -0.3}}))),
            0.005);
}

TEST(Soles, LieInDesignsAsInTheFile) {
  test::FlatBiped how = designed(test::foot_geoms("four_balls"));
  how.custom +=
      R"(<numeric name="legwright/tall" data="0.04 0.03 0.09"/>
      <text name="legwright/tall" data="m | stretch z: left_foot right_foot | t"/>
      <numeric name="legwright/long" data="0.02 0.01 0.03"/>
      <text name="legwright/long" data="m | stretch x: left_foot right_foot | l"/>)";
  const RobotModel robot = biped(how);
  std::mt19937 random(3);
  const ModelPointer before = compile_mjcf(robot.xml, "r.xml");
  for (int k = 0; k < 5; ++k) {
    const VectorXd s = test::random_design(robot.space, random);
    const std::string text = rewrite_robot(robot, s);
    const ModelPointer after = compile_mjcf(text, "r.xml");
    for (const char* foot : {"left_foot", "right_foot"}) {
      const std::vector<Vector3d> old = balls_of(*before, foot), now = balls_of(*after, foot);
      EXPECT_LT((plane_of(old) - plane_of(now)).norm(), 1e-9);
      EXPECT_GT((old[0] - now[0]).norm(), 1e-4) << "the foot did change";
    }
    const RobotModel design = parse_robot(text, "r.xml");
    for (std::size_t j = 0; j < 2; ++j) {
      ASSERT_TRUE(robot.morphology.feet[j].sole && design.morphology.feet[j].sole);
      const Sole &own = *robot.morphology.feet[j].sole, &other = *design.morphology.feet[j].sole;
      EXPECT_LT((own.ahead.cross(own.beside) - other.ahead.cross(other.beside)).norm(), 1e-9);
    }
  }
  // What is refused would have tilted it.
  std::vector<Vector3d> askew = balls_of(*before, "left_foot");
  const Vector3d direction = Vector3d(0.02, 0.0, -0.05).normalized();
  for (Vector3d& ball : askew) ball += direction * direction.dot(ball) * 0.3;
  EXPECT_GT((plane_of(askew) - Vector3d::UnitZ()).norm(), 0.05);
}

TEST(StudyRobot, ProposesNoLengthOfAFlatFoot) {
  for (const char* place : {"0.02 0 -0.04", "0 0 -0.04"}) {  // oblique, and right under the ankle
    test::FlatBiped how;
    how.foot = std::string(R"(<geom type="box" size="0.08 0.04 0.01" pos=")") + place + "\"/>";
    const ProposedParameters found = propose_parameters(test::flat_biped(how), "r.xml");
    for (const Proposal& proposal : found.proposals)
      EXPECT_FALSE(holds(proposal.binding, "stretch link: left_foot")) << proposal.name;
    EXPECT_EQ(std::count_if(found.left_out.begin(), found.left_out.end(),
                            [](const std::string& line) {
                              return holds(line, "foot_length: the foot is flat");
                            }),
              1)
        << place;
  }
  test::FlatBiped pointed;
  pointed.foot = R"(<geom size="0.01" pos="0.02 0 -0.04"/>)";
  const ProposedParameters found = propose_parameters(test::flat_biped(pointed), "r.xml");
  EXPECT_TRUE(std::any_of(found.proposals.begin(), found.proposals.end(), [](const Proposal& p) {
    return holds(p.binding, "stretch link: left_foot");
  }));
}

}  // namespace
}  // namespace legwright
