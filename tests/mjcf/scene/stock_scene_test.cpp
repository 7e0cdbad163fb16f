// SPDX-License-Identifier: Apache-2.0
#include "mjcf/scene/stock_scene.hpp"

#include <gtest/gtest.h>

#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"

namespace legwright {
namespace {

constexpr const char* kScene = R"(<mujoco>
  <extension>
    <plugin plugin="mujoco.pid"/>
    <plugin plugin="legwright.gait">
      <instance name="gait"><config key="kp" value="5"/></instance>
    </plugin>
    <plugin plugin="legwright.sensor"/>
  </extension>
  <default><default class="pd"><general biastype="affine" biasprm="0 -5 -0.1"/></default></default>
  <worldbody><body name="leg"><joint name="knee" range="-1 1"/><geom size="0.1"/></body></worldbody>
  <actuator>
    <plugin name="servo" class="pd" plugin="legwright.gait" instance="gait" joint="knee"
            forcerange="-2 2"/>
  </actuator>
  <sensor>
    <plugin name="tracking" plugin="legwright.gait" instance="gait"/>
    <jointpos name="angle" joint="knee"/>
  </sensor>
</mujoco>)";

std::string without(std::string text, const std::string& what) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos);
  return text.erase(at, what.size());
}

TEST(StockScene, ServosKeepTheirLawAndOnlyOursGoes) {
  const std::string scene = without(kScene, "<plugin plugin=\"mujoco.pid\"/>");
  const ModelPointer model = compile_mjcf(stock_scene(scene, "scene.xml"), "scene.xml");
  ASSERT_EQ(model->nu, 1);
  EXPECT_EQ(model->actuator_biasprm[1], -5.0);
  EXPECT_EQ(model->actuator_biasprm[2], -0.1);
  EXPECT_EQ(model->actuator_gainprm[0], 1.0);
  EXPECT_EQ(model->actuator_forcerange[1], 2.0);
  EXPECT_EQ(model->actuator_plugin[0], -1);
  EXPECT_EQ(model->nsensor, 1) << "the robot's own sensor stays";
}

TEST(StockScene, PluginsOfOthersStay) {
  const std::string text = stock_scene(kScene, "scene.xml");
  EXPECT_NE(text.find("mujoco.pid"), std::string::npos);
  EXPECT_EQ(text.find("legwright."), std::string::npos);
}

TEST(StockScene, ASceneWithoutAGaitIsRefused) {
  try {
    (void)stock_scene("<mujoco>\n<worldbody/></mujoco>", "plain.xml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "plain.xml:1: actuator: no actuator is driven by legwright.gait; expected the scene "
        "of a gait");
  }
  EXPECT_THROW((void)stock_scene("<mujoco>", "torn.xml"), InputError);
}

}  // namespace
}  // namespace legwright
