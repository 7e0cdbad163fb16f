// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/root_motion.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tools/simulate/mujoco_host.hpp"

namespace legwright {
namespace {

constexpr const char* kFreeBody =
    "<mujoco><worldbody><body><freejoint/><geom size='0.1'/></body></worldbody></mujoco>";

// A rotation vector that moves as a parabola through `centre`.
struct Curve {
  Eigen::Vector3d centre, rate, second;
  RootRotation at(double t) const {
    return root_rotation(centre + t * rate + 0.5 * t * t * second, rate + t * second, second);
  }
};

std::array<mjtNum, 7> qpos(const RootRotation& root) {
  const auto& q = root.quaternion;
  return {0, 0, 0, q[0], q[1], q[2], q[3]};
}

// By MuJoCo's own difference of positions.
Eigen::Vector3d difference_velocity(const mjModel& model, const Curve& curve, double t) {
  constexpr double kStep = 1e-5;
  const auto before = qpos(curve.at(t - kStep)), after = qpos(curve.at(t + kStep));
  std::array<mjtNum, 6> velocity{};
  mj_differentiatePos(&model, velocity.data(), 2 * kStep, before.data(), after.data());
  return {velocity[3], velocity[4], velocity[5]};
}

class RootMotion : public testing::TestWithParam<Curve> {};

TEST_P(RootMotion, VelocityIsMujocosDifferenceOfPositions) {
  const auto model = compile_model(kFreeBody, "free body");
  const RootRotation root = GetParam().at(0);
  EXPECT_LT((root.velocity - difference_velocity(*model, GetParam(), 0)).norm(), 1e-7);
}

TEST_P(RootMotion, AccelerationIsTheDifferenceOfVelocities) {
  constexpr double kStep = 1e-5;
  const Eigen::Vector3d difference =
      (GetParam().at(kStep).velocity - GetParam().at(-kStep).velocity) / (2 * kStep);
  EXPECT_LT((GetParam().at(0).acceleration - difference).norm(), 1e-8);
}

INSTANTIATE_TEST_SUITE_P(
    Angles, RootMotion,
    testing::Values(Curve{{0, 0, 0}, {0.3, -0.5, 0.7}, {1, 2, -3}},
                    Curve{{1e-9, 0, 0}, {0.3, -0.5, 0.7}, {1, 2, -3}},
                    Curve{{0.03, -0.02, 0.01}, {1, 0.5, -2}, {-4, 1, 3}},  // Taylor side
                    Curve{{0.04, -0.03, 0.01}, {1, 0.5, -2}, {-4, 1, 3}},  // just beyond it
                    Curve{{0.4, -0.6, 0.9}, {1, 0.5, -2}, {-4, 1, 3}},
                    Curve{{-1.5, 1.2, 2.0}, {2, -1, 1}, {1, 1, 1}}));

TEST(RootMotion, RateOfTheThreeNumbersIsNoAngularVelocity) {  // the tests above can fail
  const Curve curve{{0.4, -0.6, 0.9}, {1, 0.5, -2}, {-4, 1, 3}};
  const auto model = compile_model(kFreeBody, "free body");
  EXPECT_GT((curve.rate - difference_velocity(*model, curve, 0)).norm(), 0.1);
}

}  // namespace
}  // namespace legwright
