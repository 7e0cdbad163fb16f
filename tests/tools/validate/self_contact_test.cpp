// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/self_contact.hpp"
#include "tests/support/paths.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <memory>
#include <string>

namespace legwright {
namespace {

using OwnModel = std::unique_ptr<mjModel, void (*)(mjModel*)>;
using OwnData = std::unique_ptr<mjData, void (*)(mjData*)>;

/// Two balls above a floor, one of which flies at the other; no gravity.
OwnModel balls(bool collide) {
  const std::string xml = fmt::format(
      R"(<mujoco><option gravity="0 0 0"/><worldbody>
  <geom type="plane" size="5 5 1"/>
  <body name="left" pos="-0.2 0 0.099"><freejoint/><geom size="0.1"/></body>
  <body name="right" pos="0.1 0 0.3"><freejoint/><geom size="0.1" contype="{0}" conaffinity="{0}"/></body>
</worldbody></mujoco>)",
      collide ? 1 : 0);
  char error[256] = "";
  mjSpec* spec = mj_parseXMLString(xml.c_str(), nullptr, error, sizeof error);
  EXPECT_NE(spec, nullptr) << error;
  OwnModel model(mj_compile(spec, nullptr), mj_deleteModel);
  mj_deleteSpec(spec);
  return model;
}

/// A trunk with two legs, whose feet collide, and a lid that is fixed to it.
TEST(NeverTouch, NamesLinksWithoutAShapeThatMeetsAnother) {
  const auto names = [](const std::string& left, const std::string& right,
                        const std::string& more = "",
                        const std::string& trunk = "contype=\"0\" conaffinity=\"0\"") {
    const std::string xml = fmt::format(
        R"(<mujoco><worldbody><geom type="plane" size="5 5 1"/>
  <body name="trunk"><freejoint/><geom size="0.1" {}/>
    <body name="lid"><geom size="0.1" contype="0" conaffinity="0"/></body>
    <body name="left" pos="0 1 0"><joint/><geom size="0.1" {}/></body>
    <body name="right" pos="0 -1 0"><joint/><geom size="0.1" {}/></body></body>
</worldbody>{}</mujoco>)",
        trunk, left, right, more);
    char error[256] = "";
    mjSpec* spec = mj_parseXMLString(xml.c_str(), nullptr, error, sizeof error);
    EXPECT_NE(spec, nullptr) << error;
    const OwnModel model(mj_compile(spec, nullptr), mj_deleteModel);
    mj_deleteSpec(spec);
    EXPECT_EQ(link_count(*model, 1), 3) << "the lid is of the trunk";
    return links_that_never_touch(*model, 1);
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names("", ""), Names{"trunk"});
  EXPECT_EQ(names("contype=\"0\" conaffinity=\"0\"", ""), (Names{"trunk", "left", "right"}));
  EXPECT_EQ(names("contype=\"2\" conaffinity=\"1\"", "contype=\"1\" conaffinity=\"4\""),
            Names{"trunk"});
  EXPECT_EQ(names("contype=\"1\" conaffinity=\"2\"", "contype=\"1\" conaffinity=\"2\""),
            (Names{"trunk", "left", "right"}))
      << "they meet the floor alone";
  const Names all{"trunk", "left", "right"}, none{"trunk"};
  EXPECT_EQ(names("", "", "<contact><exclude body1=\"right\" body2=\"left\"/></contact>"), all);
  EXPECT_EQ(names("name=\"a\" contype=\"0\" conaffinity=\"0\"", "name=\"b\"",
                  "<contact><pair geom1=\"a\" geom2=\"b\"/></contact>"),
            none);
  EXPECT_EQ(names("", "", "<option><flag contact=\"disable\"/></option>"), all);
  EXPECT_EQ(names("contype=\"0\" conaffinity=\"4\"", "contype=\"0\" conaffinity=\"0\"", "",
                  "contype=\"4\" conaffinity=\"0\""),
            all)
      << "next to each other";
}

SelfContact fly(const mjModel& model) {
  OwnData data(mj_makeData(&model), mj_deleteData);
  data->qpos[2] = 0.299;  // lifted off the floor, which it touched
  data->qvel[0] = 1.0;
  SelfContactWatch watch(model);
  for (int n = 0; n < 500; ++n) {
    mj_step(&model, data.get());
    watch.observe(data->time, *data);
  }
  return watch.finish();
}

TEST(SelfContact, TwoBodiesThatMeetOnceTouchOnce) {
  const OwnModel model = balls(true);
  const SelfContact seen = fly(*model);
  EXPECT_EQ(seen.count, 1);
  EXPECT_GT(seen.share, 0.0);
  EXPECT_LT(seen.share, 0.3);
  EXPECT_GT(seen.force_max, 1.0);
  EXPECT_GT(seen.depth_max, 1e-4);
  EXPECT_LT(seen.depth_max, 0.05);
  EXPECT_NEAR(seen.force_time, 0.1, 0.05);  // 0.1 m between them at 1 m/s
  EXPECT_EQ(seen.first, "left");
  EXPECT_EQ(seen.second, "right");
}

TEST(SelfContact, BodiesThatPassThroughEachOtherDoNotTouch) {
  const OwnModel model = balls(false);
  const SelfContact seen = fly(*model);
  EXPECT_EQ(seen.count, 0);
  EXPECT_EQ(seen.share, 0.0);
  EXPECT_EQ(seen.force_max, 0.0);
  EXPECT_EQ(seen.depth_max, 0.0);
  EXPECT_EQ(seen.first, "");
}

TEST(SelfContact, TheFloorIsNotPartOfTheRobot) {
  const OwnModel model = balls(true);
  OwnData data(mj_makeData(model.get()), mj_deleteData);
  mj_forward(model.get(), data.get());
  ASSERT_GT(data->ncon, 0);  // the left ball is in the floor by a millimetre
  SelfContactWatch watch(*model);
  watch.observe(0.0, *data);
  EXPECT_EQ(watch.finish().count, 0);
}

/// Touches of the example hexapod with the first joint of two legs turned, legs in the order of the
/// file.
SelfContact hexapod(const char* joint, double angle, const char* other, double other_angle) {
  char error[256] = "";
  const std::string file = test::source_dir() + "/examples/hexapod/robot.xml";
  OwnModel model(mj_loadXML(file.c_str(), nullptr, error, sizeof error), mj_deleteModel);
  EXPECT_NE(model, nullptr) << error;
  OwnData data(mj_makeData(model.get()), mj_deleteData);
  mj_resetDataKeyframe(model.get(), data.get(), 0);
  for (const auto& [name, value] : {std::pair{joint, angle}, {other, other_angle}}) {
    const int id = mj_name2id(model.get(), mjOBJ_JOINT, name);
    EXPECT_GE(id, 0) << name;
    data->qpos[model->jnt_qposadr[id]] = value;
  }
  mj_forward(model.get(), data.get());
  SelfContactWatch watch(*model);
  watch.observe(0.0, *data);
  return watch.finish();
}

TEST(SelfContact, LegsOfTheHexapodTouchTheirNeighboursButNotThemselves) {
  EXPECT_EQ(hexapod("FL_swing", 0.0, "ML_swing", 0.0).count, 0);  // at home
  EXPECT_GT(hexapod("FL_swing", 0.25, "ML_swing", -0.25).count, 0);
  EXPECT_GT(hexapod("MR_swing", 0.25, "HR_swing", -0.25).count, 0);
  EXPECT_EQ(hexapod("FL_swing", -0.25, "ML_swing", 0.25).count, 0);  // apart
  EXPECT_EQ(hexapod("FL_lift", 1.0, "FL_knee", -2.6).count, 0);      // folded up
}

}  // namespace
}  // namespace legwright
