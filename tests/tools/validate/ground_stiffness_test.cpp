// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/ground_stiffness.hpp"

#include <gtest/gtest.h>

#include "tests/tools/simulate/tiny_scene.hpp"
#include "tools/simulate/mujoco_host.hpp"

namespace legwright {
namespace {

/// Mean depth of the contacts of a table that has come to rest [m].
double depth_at_rest(const Scene& scene) {
  const DataPointer data = make_data(*scene.model);
  mj_resetDataKeyframe(scene.model.get(), data.get(), scene.start_key);
  for (int n = 0; n < 3000; ++n) mj_step(scene.model.get(), data.get());
  double sum = 0.0;
  for (int c = 0; c < data->ncon; ++c) sum -= data->contact[c].dist;
  return sum / std::max(1, data->ncon);
}

Scene standing_table() {
  TinyScene table;
  table.wag = 0.0;
  return parse_scene(table.xml(), "tiny");
}

TEST(GroundStiffness, FeetSinkInAsDeepAsAsked) {
  const Scene hard = standing_table();
  EXPECT_NEAR(planted_load(hard), 1.01 * 9.81 / 4, 1e-9);
  const double own = depth_at_rest(hard);
  for (const double sink : {0.001, 0.002}) {
    Scene soft = standing_table();
    soften_ground(soft, sink);
    EXPECT_NEAR(depth_at_rest(soft), sink, 0.25 * sink);
    EXPECT_GT(depth_at_rest(soft), 2 * own);
  }
}

TEST(GroundStiffness, NeverMakesTheGroundHarder) {
  const double own = depth_at_rest(standing_table());
  Scene asked = standing_table();
  soften_ground(asked, 1e-7);
  EXPECT_EQ(depth_at_rest(asked), own);
}

}  // namespace
}  // namespace legwright
