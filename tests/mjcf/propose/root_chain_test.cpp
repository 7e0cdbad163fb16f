// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/root_chain.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <string>

#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

const char* const kChainFile = "chain.xml";
constexpr const char* kSpeck =
    "<inertial pos=\"0 0 0\" mass=\"0.001\" diaginertia=\"1e-6 1e-6 1e-6\"/>";

/// A box on two legs that five bodies of one joint each carry, turned and apart, by a class that
/// all within inherit; `in_carrier` stands in the second, `more` behind the bodies.
std::string carried(const std::string& in_carrier = "", const std::string& more = "",
                    const std::string& speck = kSpeck) {
  std::string out =
      "<mujoco>\n  <default><default class=\"light\"><geom density=\"300\"/></default></default>\n"
      "  <worldbody>\n";
  const char* const joints[] = {"type=\"slide\" axis=\"1 0 0\"", "type=\"slide\" axis=\"0 1 0\"",
                                "type=\"slide\" axis=\"0 0 1\"", "axis=\"0 0 1\"",
                                "axis=\"0 1 0\""};
  for (int k = 0; k < 5; ++k)
    out += "    <body name=\"c" + std::to_string(k) + "\" " +
           (k == 0   ? "childclass=\"light\" pos=\"0 0 0.2\""
            : k == 2 ? "pos=\"0 0 0.1\" euler=\"0 0 90\""
                     : "") +
           ">\n      <!-- carries -->\n      <joint name=\"j" + std::to_string(k) + "\" " +
           joints[k] + "/>" + (k == 1 ? in_carrier : "") + speck + "\n";
  return out +
         "    <body name=\"trunk\">\n      <joint name=\"j5\" axis=\"1 0 0\"/>\n"
         "      <geom name=\"box\" type=\"box\" size=\"0.1 0.1 0.05\"/>\n"
         "      <body name=\"left\" pos=\"0 0.1 0\">\n        <joint name=\"l\" axis=\"0 1 0\"/>\n"
         "        <geom name=\"lg\" size=\"0.02\" pos=\"0 0 -0.2\"/>\n      </body>\n"
         "      <body name=\"right\" pos=\"0 -0.1 0\">\n        <joint name=\"r\" axis=\"0 1 "
         "0\"/>\n"
         "        <geom name=\"rg\" size=\"0.02\" pos=\"0 0 -0.2\"/>\n      </body>\n    </body>\n"
         "    </body></body></body></body></body>\n  </worldbody>\n" +
         more + "</mujoco>\n";
}

std::string freed(const std::string& text) {
  const RobotFiles files = RobotFiles::from_text(text, kChainFile);
  const auto root = find_six_joint_root(files.text(), files.file());
  return root ? with_free_root(files, *root).main_text() : "";
}

/// Places and velocities of the last five geoms and their bodies in the only keyframe, and masses.
Eigen::MatrixXd shown(const std::string& text) {
  const ModelPointer model = compile_mjcf(text, kChainFile);
  const DataPointer data(mj_makeData(model.get()));
  mj_resetDataKeyframe(model.get(), data.get(), 0);
  mj_forward(model.get(), data.get());
  Eigen::MatrixXd out(10, 3);
  for (int k = 0; k < 3; ++k) {
    const int g = static_cast<int>(model->ngeom) - 3 + k, b = model->geom_bodyid[g];
    out.col(k).head<3>() = vector_at(data->geom_xpos, g);
    mj_objectVelocity(model.get(), data.get(), mjOBJ_XBODY, b, out.col(k).data() + 3, 0);
    out(9, k) = model->body_mass[b];
  }
  return out;
}

TEST(RootChain, AChainOfBodiesBecomesAFreeJointOfTheTrunk) {
  const std::string keys =
      "  <keyframe>\n    <key name=\"home\" qpos=\"0.4 -0.3 0.1 0.7 -0.4 0.2 0.3 -0.5\" "
      "qvel=\"1 2 -0.5 0.3 0.7 -1.1 2 3\"/>\n  </keyframe>\n";
  const std::string given = carried("", keys), made = freed(given);
  ASSERT_FALSE(made.empty());
  EXPECT_EQ(std::count(made.begin(), made.end(), '\n'),
            std::count(given.begin(), given.end(), '\n'));
  const ModelPointer model = compile_mjcf(made, kChainFile);
  EXPECT_EQ(model->nbody, 4);
  EXPECT_EQ(model->njnt, 3);
  const auto root = find_six_joint_root(given, kChainFile);
  ASSERT_TRUE(root.has_value());
  EXPECT_EQ(root->body, "trunk");
  EXPECT_EQ(root->carriers, (std::vector<std::string>{"c0", "c1", "c2", "c3", "c4"}));
  EXPECT_EQ(root->joints, (std::vector<std::string>{"j0", "j1", "j2", "j3", "j4", "j5"}));
  EXPECT_LT((shown(made) - shown(given)).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_GT(shown(given).row(3).norm(), 0.1);  // it turns
}

TEST(RootChain, ATrunkThatIsFixedOnTheLastOfThemIsMeant) {
  const std::string fixed =
      test::with(carried(), "<body name=\"trunk\">\n      <joint name=\"j5\" axis=\"1 0 0\"/>",
                 "<body name=\"c5\"><joint name=\"j5\" axis=\"1 0 0\"/>" + std::string(kSpeck) +
                     "<body name=\"trunk\">");
  const std::string made = freed(test::with(fixed, "</body></body></body></body></body>",
                                            "</body></body></body></body></body></body>"));
  ASSERT_FALSE(made.empty());
  const ModelPointer model = compile_mjcf(made, kChainFile);
  EXPECT_EQ(name_of(*model, mjOBJ_BODY, 1), "trunk");
  EXPECT_NEAR(model->qpos0[2], 0.3, 1e-12);
  EXPECT_NEAR(model->qpos0[3], std::sqrt(0.5), 1e-9);  // turned as the chain was
}

TEST(RootChain, BodiesThatWeighOrTouchOrBranchAreNoChain) {
  EXPECT_EQ(freed(carried("", "", "<inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/>")),
            "");
  EXPECT_EQ(freed(carried("<geom size=\"0.001\"/>")), "");
  EXPECT_NE(freed(carried("<geom size=\"0.001\" contype=\"0\" conaffinity=\"0\"/>")), "");
  EXPECT_EQ(freed(carried("<body name=\"arm\"><joint/>" + std::string(kSpeck) + "</body>")), "");
}

TEST(RootChain, WhatStandsInACarrierOrNamesOneIsToldWithItsLine) {
  const std::string more =
      "  <contact>\n    <exclude body1=\"c3\" body2=\"left\"/>\n  </contact>\n";
  try {
    freed(
        carried("<geom name=\"g\" size=\"0.001\" contype=\"0\" conaffinity=\"0\"/>"
                "<frame><site name=\"imu\"/></frame>",
                more));
    FAIL() << "a site in a frame went with its body";
  } catch (const InputError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("chain.xml:9: site 'imu': stands in a body that does nothing but carry"),
              std::string::npos)
        << said;
    EXPECT_NE(said.find("exclude: attribute body1: names 'c3'"), std::string::npos) << said;
    EXPECT_NE(said.find("name 'trunk'"), std::string::npos) << said;
  }
}

/// Cameras, lights and sites are seen where they were while the chain is at rest.
TEST(RootChain, WhatShowsMovesIntoTheTrunk) {
  const std::string given = carried(
      "\n<camera name=\"track\" mode=\"trackcom\"\n  pos=\"0 -1 0.25\" euler=\"70 0 0\"/>"
      "<site name=\"imu\" pos=\"0.1 0.2 0.3\" euler=\"0 20 0\"/><light pos=\"0 0 3\"/>");
  const std::string made = freed(given);
  ASSERT_FALSE(made.empty());
  EXPECT_EQ(std::count(made.begin(), made.end(), '\n'),
            std::count(given.begin(), given.end(), '\n'));
  const ModelPointer was = compile_mjcf(given, kChainFile), is = compile_mjcf(made, kChainFile);
  ASSERT_EQ(is->ncam, 1);
  ASSERT_EQ(is->nsite, 1);
  ASSERT_EQ(is->nlight, 1);
  EXPECT_EQ(name_of(*is, mjOBJ_BODY, is->cam_bodyid[0]), "trunk");
  const DataPointer before = kinematics_at(*was, nullptr, kChainFile),
                    after = kinematics_at(*is, nullptr, kChainFile);
  for (const DataPointer* data : {&before, &after}) {
    const mjModel* const model = data == &before ? was.get() : is.get();
    mj_comPos(model, data->get());
    mj_camlight(model, data->get());
  }
  EXPECT_LT((vector_at(before->site_xpos, 0) - vector_at(after->site_xpos, 0)).norm(), 1e-9);
  EXPECT_LT((matrix_at(before->site_xmat, 0) - matrix_at(after->site_xmat, 0)).norm(), 1e-9);
  EXPECT_LT((vector_at(before->cam_xpos, 0) - vector_at(after->cam_xpos, 0)).norm(), 1e-9);
  EXPECT_LT((matrix_at(before->cam_xmat, 0) - matrix_at(after->cam_xmat, 0)).norm(), 1e-9);
  EXPECT_LT((vector_at(before->light_xpos, 0) - vector_at(after->light_xpos, 0)).norm(), 1e-9);
}

/// One body with all six is the root itself: a frame around the trunk may hold what it likes.
TEST(RootChain, ABodyWithAllSixKeepsWhatStandsInIt) {
  std::string joints;
  for (const char* axis : {"1 0 0", "0 1 0", "0 0 1"})
    joints +=
        "<joint type=\"slide\" axis=\"" + std::string(axis) + "\"/><joint axis=\"" + axis + "\"/>";
  const std::string given =
      "<mujoco><worldbody><body name=\"frame\"><camera name=\"track\" pos=\"0 -1 0\"/>" + joints +
      "<body name=\"trunk\"><geom type=\"box\" size=\"0.1 0.1 0.05\"/>"
      "<body name=\"left\"><joint name=\"l\"/><geom size=\"0.02\"/></body></body></body>"
      "</worldbody></mujoco>";
  const std::string made = freed(given);
  ASSERT_FALSE(made.empty());
  const ModelPointer model = compile_mjcf(made, kChainFile);
  EXPECT_EQ(name_of(*model, mjOBJ_BODY, 1), "frame");
  EXPECT_EQ(model->cam_bodyid[0], 1);
  EXPECT_EQ(model->nq, 8);
}

}  // namespace
}  // namespace legwright
