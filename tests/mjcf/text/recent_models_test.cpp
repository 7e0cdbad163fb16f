// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/recent_models.hpp"

#include <gtest/gtest.h>

#include <string>

#include "mjcf/text/compile.hpp"
#include "mjcf/write/model_diff.hpp"
#include "tests/mjcf/robots/split_robot.hpp"
#include "tests/tools/files/temporary_folder.hpp"

namespace legwright {
namespace {

std::string text(double mass) {
  return R"(<mujoco><compiler meshdir="meshes"/><asset><mesh name="m" file="m.stl"/></asset><worldbody>
    <body><freejoint/><inertial pos="0 0 0" diaginertia="1 1 1" mass=")" +
         std::to_string(mass) + R"("/><geom type="mesh" mesh="m"/></body></worldbody></mujoco>)";
}

class RecentModelsTest : public testing::Test {
 protected:
  RecentModelsTest() { put(1.0f); }
  void put(float size) const { test::put(mesh_, test::tetrahedron_stl(size)); }
  ModelPointer compiled(double mass) const { return compile_mjcf(text(mass), file_); }
  test::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "robot.xml",
                        mesh_ = folder_.path() / "meshes/m.stl";
  RecentModels recent_;
};

TEST_F(RecentModelsTest, GivesCopiesOfWhatItKept) {
  EXPECT_FALSE(recent_.find(text(1.0), file_));
  const ModelPointer model = compiled(1.0);
  recent_.keep(text(1.0), file_, *model);
  EXPECT_FALSE(recent_.find(text(2.0), file_));
  EXPECT_FALSE(recent_.find(text(1.0), folder_.path() / "other/robot.xml"));
  ModelPointer found = recent_.find(text(1.0), file_);
  ASSERT_TRUE(found);
  EXPECT_TRUE(model_differences(*model, *found, 0.0).empty());
  found->body_mass[1] = 7.0;  // its own
  EXPECT_EQ(recent_.find(text(1.0), file_)->body_mass[1], 1.0);
  for (int k = 2; k < 6; ++k) recent_.keep(text(k), file_, *model);
  EXPECT_FALSE(recent_.find(text(1.0), file_)) << "the oldest goes";
}

TEST_F(RecentModelsTest, KnowsNoModelWhoseFilesChanged) {
  recent_.keep(text(1.0), file_, *compiled(1.0));
  put(2.0f);
  EXPECT_FALSE(recent_.find(text(1.0), file_));
  recent_.keep(text(1.0), file_, *compiled(1.0));
  EXPECT_TRUE(recent_.find(text(1.0), file_));
  std::filesystem::remove(mesh_);
  EXPECT_FALSE(recent_.find(text(1.0), file_));
}

TEST_F(RecentModelsTest, CompilingTwiceGivesTheSame) {
  const ModelPointer first = compiled(3.0), second = compiled(3.0);
  EXPECT_NE(first.get(), second.get());
  EXPECT_TRUE(model_differences(*first, *second, 0.0).empty());
}

}  // namespace
}  // namespace legwright
