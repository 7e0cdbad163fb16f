// SPDX-License-Identifier: Apache-2.0
// The shapes of trunk and limbs that the planner keeps apart are those between which MuJoCo makes
// contacts, and where MuJoCo has them, in the file and in a rewritten design.
#include "mjcf/shape/capsules.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "mjcf/read/collisions.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "optimizer/design/kinematics.hpp"
#include "tests/mjcf/robots/mjcf_builder.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

/// Two legs of three hinges beside a box; a lidar, a tail that is held and a mesh on the trunk; a
/// ring on the thigh.
std::string boxer() {
  std::string legs;
  for (const char* const side : {"L", "R"})
    legs += test::roll_pitch_knee_leg(
        side, 0.06, 0.08, {R"(<geom name="{}_motor" type="sphere" size="0.03"/>)"},
        {R"(<geom name="{}_rod" type="capsule" fromto="0 0 -0.03 0 0 -0.17" size="0.02"/>)",
         R"(<geom name="{}_ring" type="ellipsoid" pos="0.01 0 -0.1" size="0.01 0.02 0.03"/>)"});
  return R"(<mujoco model="boxer"><compiler angle="radian"/>
<asset><mesh name="wedge" vertex="-0.05 -0.02 0  0.07 -0.02 0  -0.05 0.02 0  0.07 0.02 0  -0.01 0 0.06"/></asset>
<worldbody><body name="trunk" pos="0 0 0.4"><freejoint/>
<geom name="box" type="box" size="0.2 0.1 0.06" mass="5"/>
<geom name="drawn" type="box" size="0.3 0.3 0.3" contype="0" conaffinity="0" mass="0"/>
<geom name="cone" type="mesh" mesh="wedge" pos="0.1 0.02 0.08" euler="0.2 0.1 0.3"/>
<body name="lidar" pos="-0.1 0 0.09"><geom name="disc" type="cylinder" size="0.05 0.02"/></body>
<body name="tail" pos="-0.2 0 0"><joint name="wag" axis="0 0 1"/>
<geom name="tail" type="capsule" fromto="0 0 0 -0.2 0 0.05" size="0.01"/></body>)" +
         legs + R"(</body></worldbody>
<contact><exclude body1="R_thigh" body2="trunk"/><exclude body1="tail" body2="trunk"/></contact>
<actuator>)" +
         test::roll_pitch_knee_motors() + R"(</actuator>
<custom>)" +
         test::declarations({{"trunk", "0.12 0.1 0.2", "m | stretch y: trunk | w"},
                             {"thigh", "0.2 0.15 0.3", "m | stretch link: L_thigh R_thigh | l"}}) +
         R"(
</custom></mujoco>)";
}

using Names = std::set<std::pair<std::string, std::string>>;

Names planned(const mjModel& model, const Structure& structure) {
  Names names;
  for (const auto& [a, b] : trunk_collisions(model, structure))
    names.emplace(name_of(model, mjOBJ_GEOM, a), name_of(model, mjOBJ_GEOM, b));
  return names;
}

/// Between trunk and limbs, of MuJoCo's own making: with margins wider than the robot all that can
/// collide does.
Names of_physics(const mjModel& compiled, const Structure& structure) {
  ModelPointer model(mj_copyModel(nullptr, &compiled));
  for (int g = 0; g < model->ngeom; ++g) model->geom_margin[g] = 5.0;
  model->opt.disableflags |= mjDSBL_MIDPHASE;  // its boxes were made for the margins of the file
  DataPointer data(mj_makeData(model.get()));
  mj_forward(model.get(), data.get());
  Names names;
  for (int k = 0; k < data->ncon; ++k) {
    int a = data->contact[k].geom[0], b = data->contact[k].geom[1];
    const auto on_trunk = [&](int geom) {
      return moving_body(*model, structure, model->geom_bodyid[geom]) == structure.trunk;
    };
    if (!on_trunk(a)) std::swap(a, b);
    if (on_trunk(a) && !on_trunk(b))
      names.emplace(name_of(*model, mjOBJ_GEOM, a), name_of(*model, mjOBJ_GEOM, b));
  }
  return names;
}

TEST(Collisions, OfTrunkAndLimbsAreThoseOfMujoco) {
  const std::string variants[] = {
      boxer(),
      test::with(boxer(), "<compiler angle=\"radian\"/>",
                 "<compiler angle=\"radian\"/><option><flag filterparent=\"disable\"/></option>"),
      test::with(boxer(), "<contact>", "<contact><pair geom1=\"drawn\" geom2=\"R_rod\"/>"),
      test::with(boxer(), "name=\"box\" type", "name=\"box\" contype=\"2\" conaffinity=\"4\" type"),
      test::with(boxer(), "<compiler angle=\"radian\"/>",
                 "<compiler angle=\"radian\"/><option><flag contact=\"disable\"/></option>")};
  std::set<std::size_t> sizes;
  for (const std::string& xml : variants) {
    const Structure structure = parse_robot(xml, "robot.xml").structure;
    // What is held is rigid when the robot is played.
    const ModelPointer model =
        compile_mjcf(test::with(xml, "<joint name=\"wag\" axis=\"0 0 1\"/>", ""), "robot.xml");
    Structure played = structure;
    played.moves.erase(played.moves.begin() + 1);
    EXPECT_EQ(planned(*model, played), of_physics(*model, played));
    EXPECT_EQ(planned(*compile_mjcf(xml, "robot.xml"), structure), planned(*model, played));
    sizes.insert(planned(*model, played).size());
  }
  EXPECT_EQ(sizes.size(), 5u) << "each variant was to differ";
}

/// Where a capsule is in the world, with the trunk at the origin and all joints at zero.
struct Placed {
  Vector3d from, to;
  double radius;
};

std::vector<Placed> placed(const RobotModel& robot, const VectorXd& s, const std::string& geom) {
  const ModelPointer model = compile_mjcf(robot.xml, "robot.xml");
  const Morphology& morphology = robot.morphology;
  const GeometryAtDesign geometry(morphology, s);
  PoseKinematics pose;
  pose.compute(morphology, geometry, VectorXd::Zero(morphology.pose_size()), PoseDetail::place);
  std::vector<Placed> out;
  for (int k = 0; k < static_cast<int>(morphology.capsules.size()); ++k)
    if (morphology.capsules[static_cast<std::size_t>(k)].part ==
        mj_name2id(model.get(), mjOBJ_GEOM, geom.c_str()))
      out.push_back({capsule_end_place(morphology, geometry, pose, 2 * k),
                     capsule_end_place(morphology, geometry, pose, 2 * k + 1),
                     morphology.capsules[static_cast<std::size_t>(k)].radius});
  return out;
}

double signed_distance(const Placed& capsule, const Vector3d& p) {
  const Vector3d u = capsule.to - capsule.from;
  const double t =
      u.isZero(0.0) ? 0.0 : std::clamp((p - capsule.from).dot(u) / u.squaredNorm(), 0.0, 1.0);
  return (p - capsule.from - t * u).norm() - capsule.radius;
}

TEST(Capsules, FillTheTrunksBoxToItsEdgesAndNoMore) {
  const RobotModel robot = parse_robot(boxer(), "robot.xml");
  const VectorXd s = robot.space.initial();
  const std::vector<Placed> box = placed(robot, s, "box");
  ASSERT_EQ(box.size(), 6u);  // two as thick as it is, four in its edges
  const Vector3d half(0.2, 0.1, 0.06);
  for (const Placed& capsule : box)
    for (const Vector3d& end : {capsule.from, capsule.to})
      EXPECT_TRUE(((end.cwiseAbs().array() + capsule.radius) <= half.array() + 1e-12).all());
  double worst = 0.0;  // over its long sides, but for their ends, which are rounded too
  for (double x = -0.14; x < 0.141; x += 0.02)
    for (double share = -1.0; share <= 1.0; share += 0.01)
      for (const Vector3d& p : {Vector3d(x, 0.1 * share, 0.06), Vector3d(x, 0.1, 0.06 * share)}) {
        double nearest = 1.0;
        for (const Placed& capsule : box) nearest = std::min(nearest, signed_distance(capsule, p));
        worst = std::max(worst, nearest);
      }
  EXPECT_LT(worst, 0.014);
  EXPECT_GT(worst, 0.0);  // the edges are rounded
  EXPECT_TRUE(placed(robot, s, "drawn").empty());
}

TEST(Capsules, OfRodsAndBallsAreTheGeomsThemselves) {
  const RobotModel robot = parse_robot(boxer(), "robot.xml");
  const VectorXd s = robot.space.initial();
  const std::vector<Placed> rod = placed(robot, s, "L_rod"), foot = placed(robot, s, "L_foot");
  ASSERT_EQ(rod.size(), 1u);
  EXPECT_LT((rod[0].from - Vector3d(0, 0.14, -0.17)).norm() +
                (rod[0].to - Vector3d(0, 0.14, -0.03)).norm(),
            1e-9);
  EXPECT_EQ(rod[0].radius, 0.02);
  ASSERT_EQ(foot.size(), 1u);
  EXPECT_LT((foot[0].from - Vector3d(0, 0.14, -0.4)).norm(), 1e-9);
  EXPECT_EQ(foot[0].from, foot[0].to);
  EXPECT_EQ(placed(robot, s, "R_ring").size(), 2u);
  // The tail is held where the file draws it, and rides on the trunk.
  EXPECT_LT((placed(robot, s, "tail").at(0).from - Vector3d(-0.4, 0, 0.05)).norm(), 1e-9);
}

TEST(Capsules, FollowTheDesignAsTheRewrittenFileDoes) {
  const RobotModel robot = parse_robot(boxer(), "robot.xml");
  VectorXd s(2);
  s << 0.13, 0.27;
  const RobotModel again = parse_robot(rewrite_robot(robot, s), "robot.xml");
  for (const char* geom : {"box", "disc", "tail", "L_rod", "R_ring", "L_foot", "cone"}) {
    const std::vector<Placed> meant = placed(robot, s, geom),
                              made = placed(again, again.space.initial(), geom),
                              before = placed(robot, robot.space.initial(), geom);
    ASSERT_EQ(meant.size(), made.size()) << geom;
    double moved = 0.0;
    for (std::size_t k = 0; k < meant.size(); ++k) {
      EXPECT_LT((meant[k].from - made[k].from).norm(), 1e-9) << geom;
      EXPECT_LT((meant[k].to - made[k].to).norm(), 1e-9) << geom;
      EXPECT_NEAR(meant[k].radius, made[k].radius, 1e-12) << geom;
      moved += (meant[k].to - before[k].to).norm();
    }
    EXPECT_EQ(moved > 1e-4, std::string(geom) != "tail" && std::string(geom) != "disc") << geom;
  }
}

TEST(Capsules, AreLimitedInNumberAndAThinPlateCounts) {
  const auto with_parts = [](int count, const std::string& size) {
    std::string parts, text = boxer();
    for (int k = 0; k < count; ++k)
      parts += "<geom type=\"box\" mass=\"0\" size=\"" + size + "\"/>";
    return text.insert(text.find("<geom name=\"cone\""), parts);
  };
  const auto pairs = [&](int count, const std::string& size) {
    return parse_robot(with_parts(count, size), "boxer.xml").morphology.capsule_pairs.size();
  };
  const std::size_t few = pairs(0, ""), more = pairs(10, "0.05 0.05 1e-13");
  EXPECT_GT(more, few) << "so thin that its width over it is no int";
  EXPECT_LT(more, 20000u);
  try {
    pairs(5000, "0.05 0.05 0.05");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("pairs of shapes"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace legwright
