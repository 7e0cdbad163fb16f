// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/floquet.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/tools/simulate/tiny_scene.hpp"

namespace legwright {
namespace {

/// Plays a model for some time first. @param body with a free joint; empty: none
std::optional<double> multiplier(const std::string& xml, double before, int steps,
                                 const char* body = "", int threads = 2) {
  const ModelPointer model = compile_model(xml, "test");
  const DataPointer data = make_data(*model);
  while (data->time < before) mj_step(model.get(), data.get());
  const int root = *body == '\0' ? 0 : mj_name2id(model.get(), mjOBJ_BODY, body);
  FloquetOptions options;
  options.threads = threads;
  return floquet_multiplier(CycleStart{model.get(), data.get(), steps, root}, options);
}

constexpr const char* kSprings = R"(<mujoco><option timestep="1e-4" gravity="0 0 0"
  integrator="implicit"/><worldbody>
  <body><joint name="a" type="slide" axis="1 0 0" stiffness="50" damping="2"/>
    <geom size="0.1" mass="1"/></body>
  <body pos="0 2 0"><joint name="b" type="slide" axis="1 0 0" stiffness="80" damping="6"/>
    <geom size="0.1" mass="1"/></body>
</worldbody></mujoco>)";

// m x" + c x' + k x = 0 dies out as exp(−c t / 2m): of two masses the slower one rules.
TEST(Floquet, OfMassesOnSpringsIsThatOfTheSlowestDecay) {
  const auto found = multiplier(kSprings, 0.0, 5000);
  ASSERT_TRUE(found);
  EXPECT_NEAR(*found, std::exp(-2.0 * 0.5 / 2.0), 2e-3);
}

// Linearised about its top, θ" = (g / l) θ grows as exp(√(g / l) t); hanging and damped it decays.
TEST(Floquet, OfAPendulumTellsStandingFromHanging) {
  const auto pendulum = [](const char* damping, double to) {
    return std::string(R"(<mujoco><option timestep="1e-4" integrator="implicit"/><worldbody><body>
      <joint type="hinge" axis="0 1 0" damping=")") +
           damping + "\"/><inertial pos=\"0 0 " + std::to_string(to) +
           "\" mass=\"1\" diaginertia=\"1e-9 1e-9 1e-9\"/></body></worldbody></mujoco>";
  };
  const double rate = std::sqrt(9.81 / 0.5);
  const auto standing = multiplier(pendulum("0", 0.5), 0.0, 2000);
  ASSERT_TRUE(standing);
  EXPECT_NEAR(*standing, std::exp(rate * 0.2), 0.01);
  const auto hanging = multiplier(pendulum("0.1", -0.5), 0.0, 2000);
  ASSERT_TRUE(hanging);
  EXPECT_NEAR(*hanging, std::exp(-0.1 / 0.25 / 2 * 0.2), 2e-3);
}

constexpr const char* kBox = R"(<mujoco><option timestep="0.001"/><worldbody>
  <geom type="plane" size="5 5 1"/>
  <body name="box" pos="0.3 0.2 0.1" euler="0 0 40"><freejoint/>
    <geom type="box" size="0.2 0.3 0.1" mass="1"/></body></worldbody></mujoco>)";

// Where the box lies and which way it faces is no disturbance: with these it would be 1.
TEST(Floquet, WhereAFreeBodyIsAndFacesIsLeftOut) {
  const auto lying = multiplier(kBox, 1.0, 1000, "box");
  ASSERT_TRUE(lying);
  EXPECT_LT(*lying, 0.5);
}

TEST(Floquet, OfAFloatingBodyNothingDies) {
  const std::string adrift = R"(<mujoco><option timestep="0.001" gravity="0 0 0"/><worldbody>
    <body name="ball" pos="0 0 1"><freejoint/><geom size="0.1" mass="1"/></body>
    </worldbody></mujoco>)";
  const auto found = multiplier(adrift, 0.0, 500, "ball");
  ASSERT_TRUE(found);
  EXPECT_NEAR(*found, 1.0, 1e-3);
}

TEST(Floquet, OfASceneIsTheSameForAnyNumberOfThreads) {
  const auto of = [](int threads) {
    FloquetOptions options;
    options.threads = threads;
    return floquet_multiplier(parse_scene(TinyScene{}.xml(), "tiny"), options);
  };
  const auto alone = of(1);
  ASSERT_TRUE(alone);
  EXPECT_LT(*alone, 1.0);  // a table stands
  EXPECT_EQ(*alone, *of(3));
}

TEST(Floquet, OfARobotThatFallsThereIsNone) {
  TinyScene falling;
  falling.start_qpos = "0 0 0.1 0.5 0.86602540378 0 0 0";
  EXPECT_FALSE(floquet_multiplier(parse_scene(falling.xml(), "tiny")));
}

}  // namespace
}  // namespace legwright
