// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/mirror.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mjcf/propose/proposals.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/robots/construction_robots.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/mjcf/robots/turned_biped.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using test::turned_biped;

const double kHalf = std::acos(-1.0);

/// How far axes (as lines) and anchors of left and right are from mirror images, at the joint
/// angles that the home pose of `home` has.
double asymmetry(const std::string& xml, const std::string& home) {
  const ModelPointer model = compile_mjcf(xml, "x"), old = compile_mjcf(home, "x");
  const DataPointer data(mj_makeData(model.get()));
  mju_copy(data->qpos, old->key_qpos, static_cast<int>(model->nq));
  mj_kinematics(model.get(), data.get());
  double worst = 0.0;
  for (const char* joint : {"yaw", "pitch", "knee"}) {
    const int left = mj_name2id(model.get(), mjOBJ_JOINT, (std::string("left_") + joint).c_str()),
              right = mj_name2id(model.get(), mjOBJ_JOINT, (std::string("right_") + joint).c_str());
    const auto at = [](const mjtNum* array, int id) -> Vector3d {
      return Vector3d::Map(array + 3 * id);
    };
    const auto image = [](const Vector3d& v) { return Vector3d(v.x(), -v.y(), v.z()); };
    worst = std::max(worst, (image(at(data->xanchor, left)) - at(data->xanchor, right)).norm());
    worst = std::max(worst, image(at(data->xaxis, left)).cross(at(data->xaxis, right)).norm());
  }
  return worst;
}

const Binding::Target& second_target(const RobotModel& robot, const std::string& parameter) {
  for (int k = 0; k < robot.space.size(); ++k)
    if (robot.space.parameters[k].name == parameter) return robot.bindings[k].targets.at(1);
  throw std::out_of_range(parameter);
}

TEST(Mirror, DesignsStayMirrorImagesHoweverTheRightBodyIsTurned) {
  for (const double turn : {0.0, kHalf, kHalf / 2, 0.7}) {
    const std::string bare = turned_biped({turn, 0.0, false});
    ASSERT_LT(asymmetry(bare, bare), 1e-9) << turn;
    const RobotModel robot = parse_robot(test::declared(bare), "robot.xml");
    ASSERT_GE(robot.space.size(), 8) << turn;  // two lengths, six axes
    std::mt19937 random(5);
    for (int trial = 0; trial < 5; ++trial) {
      const std::string text = rewrite_robot(robot, test::random_design(robot.space, random));
      EXPECT_LT(asymmetry(text, bare), 1e-9) << turn;
    }
  }
}

/// What the old rule, about the body's own axes, would make of a turned leg.
TEST(Mirror, IsThatOfTheBodysFrameOnlyWhereFramesAgree) {
  const auto direction = [](double turn) {
    const RobotModel robot =
        parse_robot(test::declared(turned_biped({turn, 0.0, false})), "robot.xml");
    return second_target(robot, "yaw_axis_roll").direction;
  };
  EXPECT_EQ(direction(0.0), Vector3d(-1, 0, 0));
  EXPECT_EQ(direction(0.05), Vector3d(-1, 0, 0));  // drawn by hand: as it was
  EXPECT_LT((direction(kHalf) - Vector3d(1, 0, 0)).norm(), 1e-9);
}

TEST(Mirror, ItsOriginalIsTheHingeOppositeOfIt) {
  std::string xml = test::declared(turned_biped({kHalf, 0.0, false}));
  const ModelPointer model = compile_mjcf(xml, "x");
  const int trunk = 1;
  std::vector<int> all(static_cast<std::size_t>(model->njnt - 1));
  std::iota(all.begin(), all.end(), 1);
  for (int j = 1; j < model->njnt; ++j)
    EXPECT_EQ(mirror_image(*model, trunk, j, Across::y, all), (j + 2) % 6 + 1);
  EXPECT_EQ(mirror_image(*model, trunk, 1, Across::y, {}), -1);
}

TEST(Mirror, HingesDrawnAtOtherAnglesAreNotTied) {
  const ProposedParameters found =
      propose_parameters(turned_biped({0.0, kHalf, false}), "robot.xml");
  ASSERT_EQ(found.limbs[0].partner, 1);
  const auto left_out = [&](const std::string& name) {
    return std::any_of(found.left_out.begin(), found.left_out.end(), [&](const std::string& line) {
      return line.rfind(name + ": ", 0) == 0 &&
             line.find("angles that are no mirror images") != std::string::npos;
    });
  };
  EXPECT_TRUE(left_out("yaw_axis_roll"));
  EXPECT_FALSE(left_out("pitch_axis_roll"));
  const ProposedParameters plain = propose_parameters(turned_biped({0.0, 0.0, false}), "robot.xml");
  EXPECT_TRUE(plain.left_out.empty()) << plain.left_out.front();  // twin
}

TEST(Shared, AWaistIsReportedOnceAndItsAxisInPlainWords) {
  const ProposedParameters found = propose_parameters(turned_biped({0.0, 0.0, true}), "robot.xml");
  ASSERT_EQ(found.limbs.size(), 2u);
  EXPECT_EQ(found.limbs[0].shared, 1);
  EXPECT_EQ(found.limbs[1].shared, 1);
  EXPECT_EQ(std::count_if(found.left_out.begin(), found.left_out.end(),
                          [](const std::string& line) {
                            return line.find("'waist' is above several legs") != std::string::npos;
                          }),
            1);
  for (const std::string& line : found.left_out)
    EXPECT_EQ(line.find("twice"), std::string::npos) << line;
  EXPECT_EQ(propose_parameters(turned_biped({}), "robot.xml").limbs[0].shared, 0);
}

TEST(Limbs, AxesAreSeenFromTheTrunkAtHome) {
  const ProposedParameters found =
      propose_parameters(turned_biped({kHalf / 2, 0.0, false}), "robot.xml");
  for (const Limb& limb : found.limbs) {
    ASSERT_EQ(limb.axes.size(), 3u);
    EXPECT_EQ(axis_name(limb.axes[0]), "yaw");
    // The right leg's is the x axis of its own body, and toes point out by 0.3 rad.
    EXPECT_NEAR(std::abs(limb.axes[1].y()), std::cos(0.3), 1e-9);
  }
}

}  // namespace
}  // namespace legwright
