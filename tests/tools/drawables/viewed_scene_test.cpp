// SPDX-License-Identifier: Apache-2.0
#include "tools/drawables/viewed_scene.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/tools/simulate/tiny_scene.hpp"

namespace legwright {
namespace {

std::vector<NamedScene> two() {
  std::vector<NamedScene> scenes;
  scenes.push_back({"before", parse_scene(TinyScene{}.xml(), "tiny")});
  scenes.push_back({"after", parse_scene(TinyScene{.wag = 0.4}.xml(), "tiny")});
  return scenes;
}

TEST(ViewedScenes, HaveWhatTheViewerNeeds) {
  const Json told = viewed_scenes_json(two());
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[0]["name"], "before");
  for (const Json& each : told) {
    const Json& design = each["design"];
    const auto bodies = design["bodies"].size();
    EXPECT_EQ(each["motion"]["bodies"], bodies);
    ASSERT_FALSE(design["geoms"].empty());
    for (const Json& geom : design["geoms"]) {
      EXPECT_LT(geom["body"].get<std::size_t>(), bodies);
      EXPECT_NE(geom["type"], "plane") << "the page draws its own floor";
    }
    for (const Json& foot : each["motion"]["feet"]) {
      EXPECT_GT(foot["radius"], 0.0);
      EXPECT_GT(foot["body"], 0);
    }
    EXPECT_GT(each["motion"]["weight"], 0.0);
  }
  EXPECT_NE(told[0]["motion"]["poses"], told[1]["motion"]["poses"]);
}

TEST(ViewedScenes, TheSameScenesGiveTheSameBytes) {
  EXPECT_EQ(viewed_scenes_json(two()).dump(), viewed_scenes_json(two()).dump());
}

TEST(ViewedScenes, MeshesAreThereAndSmallEnough) {
  std::string xml = TinyScene{}.xml();
  const std::string ball = "<asset><mesh name='ball' builtin='sphere' params='4'/></asset>";
  xml.insert(xml.find("<worldbody>"), ball);
  xml.insert(xml.find("<worldbody>") + 11,
             "<geom type='mesh' mesh='ball' contype='0' conaffinity='0' pos='0 0 3'/>");
  std::vector<NamedScene> scenes;
  scenes.push_back({"it", parse_scene(xml, "tiny", 1.0, {}, MeshDetail::triangles)});
  const auto faces_with = [&](int most) {
    const Json meshes = viewed_scenes_json(scenes, most)[0]["design"]["meshes"];
    EXPECT_EQ(meshes.size(), 1U);
    return meshes.begin()->at("faces").get<std::string>().size();
  };
  const std::size_t whole = faces_with(1'000'000);
  EXPECT_LT(faces_with(200), whole / 4);
  EXPECT_LE(faces_with(200), 1.3 * 200 * 12 * 4 / 3 + 8);
}

}  // namespace
}  // namespace legwright
