// SPDX-License-Identifier: Apache-2.0
#include "mjcf/scene/seen_shapes.hpp"

#include <gtest/gtest.h>

#include "mjcf/text/compile.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

/// Groups of the geoms of a floor, a shank with a picture, a box and a ball, and a toe with a ball.
std::vector<int> groups_with(const std::string& picture, const std::string& ball = "") {
  const std::string xml =
      R"(<mujoco><worldbody><geom type="plane" size="1 1 1"/><body><freejoint/>
      <geom type="capsule" size=".01 .1" contype="0" conaffinity="0" )" +
      picture + R"(/><geom type="box" size=".02 .02 .1"/>
      <geom size=".01" pos="0 0 -.1" )" +
      ball + R"(/><body name="toe" pos="0 0 -.1"><geom size=".01"/></body></body>
      </worldbody></mujoco>)";
  return drawn_groups(*compile_mjcf(xml, "shank.xml"));
}

TEST(SeenShapes, OfALinkWithPicturesThoseThatCollideAreNotDrawn) {
  EXPECT_EQ(groups_with("group=\"1\""), (std::vector{0, 1, 3, 3, 0}))
      << "a toe without pictures is";
}

TEST(SeenShapes, InOneGroupWithWhatTheyDecorateTheyAre) {
  EXPECT_EQ(groups_with(""), (std::vector{0, 0, 0, 0, 0}));
  EXPECT_EQ(groups_with("group=\"1\"", "group=\"1\""), (std::vector{0, 1, 0, 1, 0}));
}

TEST(SeenShapes, PicturesThatNobodySeesStandInNobodysPlace) {
  EXPECT_EQ(groups_with("group=\"4\""), (std::vector{0, 4, 0, 0, 0}));
}

TEST(SeenShapes, AModelThatIsDrawnGetsTheGroups) {
  const ModelPointer model = compile_mjcf(
      R"(<mujoco><worldbody><body><freejoint/><geom size=".1" group="2" contype="0"
      conaffinity="0"/><geom size=".2"/></body></worldbody></mujoco>)",
      "ball.xml");
  hide_collision_shapes(*model);
  EXPECT_EQ(model->geom_group[0], 2);
  EXPECT_EQ(model->geom_group[1], 3);
}

}  // namespace
}  // namespace legwright
