// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/leg_chains.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "mjcf/propose/standing_pose.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/text/compile.hpp"

namespace legwright {
namespace {

/// Two hinges and links as long as a leg's, from a place on the trunk along a direction.
std::string chain(const std::string& name, const std::string& place, double x, double z) {
  return fmt::format(
      R"(<body name="{0}1" pos="{1}"><joint name="{0}1" axis="0 1 0"/>
      <geom type="capsule" size=".01" fromto="0 0 0 {2} 0 {3}" mass=".1"/>
      <body name="{0}2" pos="{2} 0 {3}"><joint name="{0}2" axis="0 1 0"/>
      <geom type="capsule" size=".01" fromto="0 0 0 {2} 0 {3}" mass=".1"/></body></body>)",
      name, place, x, z);
}

/// Four legs that stand, and what else hangs on the trunk.
std::string dog_with(const std::string& more) {
  std::string legs;
  for (const auto& [name, place] :
       {std::tuple{"FL", "0.2 0.1 0"}, std::tuple{"FR", "0.2 -0.1 0"},
        std::tuple{"HL", "-0.2 0.1 0"}, std::tuple{"HR", "-0.2 -0.1 0"}})
    legs += chain(name, place, 0.0, -0.1);
  return R"(<mujoco><compiler angle="radian" autolimits="true"/><worldbody>
         <body name="trunk" pos="0 0 0.21"><freejoint/>
         <geom type="box" size=".2 .05 .03" mass="2"/>)" +
         legs + more + "</body></worldbody></mujoco>";
}

std::size_t legs_of(const std::string& xml) {
  const ModelPointer model = compile_mjcf(xml, "dog.xml");
  const DataPointer data = kinematics_at(*model, home_qpos(*model), "dog.xml");
  return legs_of_one_build(*model, 1, *data).size();
}

TEST(LegChains, ATailAsLongAsALegIsNone) {
  ASSERT_EQ(legs_of(dog_with("")), 4u);
  EXPECT_EQ(legs_of(dog_with(chain("tail", "-0.2 0 0", -0.1, 0.0))), 4u);
  EXPECT_EQ(legs_of(dog_with(chain("neck", "0.2 0 0", 0.08, 0.06))), 4u);
  EXPECT_EQ(legs_of(dog_with(chain("neck", "0.2 0 0", 0.08, 0.06) +
                             chain("tail", "-0.2 0 0", -0.1, 0.0))),
            6u)
      << "two chains in the middle may be the legs of a robot in one line";
}

TEST(LegChains, AFifthLegThatStandsIsOne) {
  EXPECT_EQ(legs_of(dog_with(chain("middle", "0 0 0", 0.0, -0.1))), 5u);
}

TEST(LegChains, ALegThatIsDrawnInTheAirBesideItsMirrorImageIsOne) {
  EXPECT_EQ(
      legs_of(dog_with(chain("ML", "0 0.1 0", 0.1, 0.0) + chain("MR", "0 -0.1 0", 0.0, -0.1))), 6u);
}

}  // namespace
}  // namespace legwright
