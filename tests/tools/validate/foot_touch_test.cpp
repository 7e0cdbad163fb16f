// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/foot_touch.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tools/simulate/mujoco_host.hpp"

namespace legwright {
namespace {

/// A box foot 0.3 m below its hinge, with and without the site that scenes put where the plan has
/// the foot.
ModelPointer box_foot(const std::string& site) {
  return compile_model(R"(<mujoco><worldbody><body pos="0 0 1"><joint name="ankle" axis="0 1 0"/>
    <geom name="sole" type="box" pos="0.02 0 -0.29" size="0.05 0.03 0.01"/>)" +
                           site + "</body></worldbody></mujoco>",
                       "foot.xml");
}

TEST(FootTouch, AFootThatIsNoBallIsWhereItsSiteIs) {
  const ModelPointer marked = box_foot(
      "<site name=\"foot:sole\" type=\"box\" size=\"0.002 0.002 0.002\" pos=\"0.02 0 -0.3\"/>");
  const ModelPointer plain = box_foot("");
  for (const mjModel* model : {marked.get(), plain.get()}) {
    const auto data = make_data(*model);
    data->qvel[0] = 2.0;
    mj_forward(model, data.get());
    const bool is_marked = model == marked.get();
    const double depth = is_marked ? 0.3 : 0.29;
    EXPECT_NEAR(foot_position(*model, *data, 0).z(), 1 - depth, 1e-12);
    EXPECT_EQ(foot_radius(*model, 0), 0.0);
    // ω = 2 about y: v = ω × r.
    const FootMotion motion = foot_motion(*model, *data, 0);
    EXPECT_NEAR(motion.bottom_velocity.x(), -2 * depth, 1e-12);
    EXPECT_NEAR(motion.bottom_velocity.z(), -2 * 0.02, 1e-12);
  }
}

TEST(FootTouch, AnEndOfACapsuleIsABall) {
  const ModelPointer model = compile_model(
      R"(<mujoco><worldbody><body><joint axis="0 1 0"/>
    <geom name="toe" type="capsule" pos="0 0 -0.2" size="0.02 0.1"/>
    <site name="foot:toe" size="0.02" pos="0 0 -0.3"/></body></worldbody></mujoco>)",
      "foot.xml");
  const auto data = make_data(*model);
  data->qvel[0] = 1.0;
  mj_forward(model.get(), data.get());
  EXPECT_EQ(foot_radius(*model, 0), 0.02);
  EXPECT_NEAR(foot_position(*model, *data, 0).z(), -0.3, 1e-12);
  EXPECT_NEAR(foot_motion(*model, *data, 0).bottom_velocity.x(), -0.32, 1e-12);
}

}  // namespace
}  // namespace legwright
