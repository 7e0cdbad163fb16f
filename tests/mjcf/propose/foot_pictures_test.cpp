// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/foot_pictures.hpp"

#include <gtest/gtest.h>

#include "mjcf/read/read_robot.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

const char* const kShin =
    R"(<geom class="bone" fromto="0 0 0 0 0 -0.19" size="0.012"/>
            <geom name="lf_foot" class="ball" pos="0 0 -0.2"/>)";

/// Remarks on lurcher, whose left fore shank collides as given and shows a mesh as long as itself.
std::vector<std::string> with_shank(const std::string& colliding) {
  std::string xml = test::read_file(test::source_path("tests/robots/lurcher/robot.xml"));
  xml = test::with(xml, kShin, colliding + R"(<geom type="mesh" mesh="shin" pos="0 0 -0.11"/>)");
  xml = test::with(xml, "<worldbody>",
                   R"(<asset><mesh name="shin" vertex="-.01 -.01 -.11 .01 -.01 -.11 .01 .01 -.11
                   -.01 .01 -.11 -.01 -.01 .11 .01 -.01 .11 .01 .01 .11 -.01 .01 .11"/></asset>
                   <worldbody>)");
  const std::string legs = "0 0.6 -1.2 ";
  xml = test::with(xml, "</mujoco>",
                   "<keyframe><key name=\"home\" qpos=\"0 0 0 1 0 0 0 " + legs + legs + legs +
                       legs + "\"/></keyframe></mujoco>");
  return feet_beside_pictures(parse_robot(xml, "lurcher.xml"));
}

TEST(FootPictures, AShapeThatIsDrawnAsItCollidesIsFine) {
  EXPECT_TRUE(with_shank(kShin).empty());
  EXPECT_TRUE(with_shank(R"(<geom name="lf_foot" type="box" contype="1" conaffinity="1"
                            size="0.012 0.012 0.11" pos="0 0 -0.11"/>)")
                  .empty());
}

/// As drawn around a bent shin by hand: with the knee bent its corner is lower than the foot.
TEST(FootPictures, ABoxThatReachesLowerIsTold) {
  const std::string box = R"(<geom name="lf_foot" type="box" contype="1" conaffinity="1"
                                   size="0.06 0.02 0.13" pos="-0.03 0 -0.13"/>)";
  EXPECT_TRUE(with_shank(box).empty()) << "one that is drawn beside the mesh is seen";
  const auto remarks = with_shank(test::with(box, "/>", " group=\"3\"/>"));
  ASSERT_EQ(remarks.size(), 1U);
  for (const char* part : {"feet 'lf_foot'", "a box that collides reaches 0.0",
                           "m lower than its meshes", "let the meshes collide"})
    EXPECT_NE(remarks[0].find(part), std::string::npos) << part << "\n" << remarks[0];
}

TEST(FootPictures, ABoxThatEndsAboveTheMeshIsTold) {
  const auto remarks = with_shank(R"(<geom name="lf_foot" type="box" contype="1" conaffinity="1"
                                     size="0.012 0.012 0.08" pos="0 0 -0.08"/>)");
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_NE(remarks[0].find("m less low than its meshes"), std::string::npos) << remarks[0];
}

}  // namespace
}  // namespace legwright
