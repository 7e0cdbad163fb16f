// SPDX-License-Identifier: Apache-2.0
#include "tools/drawables/motion_frames.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "mjcf/text/mujoco_pointers.hpp"
#include "tests/tools/simulate/tiny_scene.hpp"
#include "tools/files/base64.hpp"
#include "tools/simulate/scene.hpp"

namespace legwright {
namespace {

std::vector<float> floats_of(const Json& text) {
  const std::string bytes = from_base64(text.get<std::string>()).value();
  std::vector<float> out(bytes.size() / sizeof(float));
  std::memcpy(out.data(), bytes.data(), bytes.size());
  return out;
}

class MotionFrames : public testing::Test {
 protected:
  static Scene scene() {
    TinyScene tiny;
    tiny.swinging_foot = true;
    return parse_scene(tiny.xml(), "tiny");
  }
  Scene scene_ = scene();
  Json told_ = motion_frames_json(*scene_.model, scene_.trajectory);
};

TEST_F(MotionFrames, PosesAreThoseOfThePlayedSpline) {
  const mjModel& model = *scene_.model;
  const std::vector<float> poses = floats_of(told_["poses"]);
  const int frames = told_["frames"];
  ASSERT_EQ(poses.size(), static_cast<std::size_t>(7 * frames * model.nbody));
  const DataPointer data = make_data(model);
  for (const int frame : {0, frames / 3, frames - 1}) {
    const PlayedState at =
        played_state(model, scene_.joints, scene_.trajectory, TinyScene::kPeriod * frame / frames);
    std::copy(at.qpos.begin(), at.qpos.end(), data->qpos);
    mj_kinematics(&model, data.get());
    for (int body = 0; body < model.nbody; ++body) {
      const float* pose = poses.data() + 7 * (frame * model.nbody + body);
      for (int k = 0; k < 3; ++k) EXPECT_FLOAT_EQ(pose[k], data->xpos[3 * body + k]);
      for (int k = 0; k < 4; ++k) EXPECT_FLOAT_EQ(pose[3 + k], data->xquat[4 * body + k]);
    }
  }
}

TEST_F(MotionFrames, FeetStandAndPushAsPlanned) {
  const auto frames = told_["frames"].get<std::size_t>();
  ASSERT_EQ(told_["feet"].size(), 4U);
  const Json& swinging = told_["feet"][0];
  EXPECT_EQ(swinging["name"], "FL");
  ASSERT_EQ(swinging["stance"].size(), frames);
  EXPECT_EQ(swinging["stance"][frames / 4], 1);
  EXPECT_EQ(swinging["stance"][3 * frames / 4], 0);
  EXPECT_EQ(told_["feet"][1]["stance"][3 * frames / 4], 1);
  EXPECT_EQ(floats_of(told_["forces"]).size(), 3 * 4 * frames);
  EXPECT_EQ(floats_of(told_["places"]).size(), 3 * 4 * frames);
  EXPECT_EQ(told_["period"], TinyScene::kPeriod);
}

}  // namespace
}  // namespace legwright
