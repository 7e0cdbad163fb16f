// SPDX-License-Identifier: Apache-2.0
// What hulls weigh, against MuJoCo's own meshes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "mjcf/text/compile.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/text/numbers.hpp"
#include "optimizer/design/polyhedron.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::vector<Vector3d> cloud(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> number(-64, 64);  // which single precision holds
  std::vector<Vector3d> out;
  for (int k = 0; k < 30; ++k) {
    const int x = number(random), y = number(random), z = number(random);
    out.emplace_back(x / 1024.0, y / 512.0, 0.125 + z / 2048.0);
  }
  return out;
}

TEST(Polyhedron, WeighsWhatMujocoWeighs) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const std::vector<Vector3d> points = cloud(seed);
    const SolidMoments found = moments_of_solid(convex_hull(points), points);
    std::string vertices;
    for (const Vector3d& point : points) vertices += format_numbers(point) + " ";
    const ModelPointer model = compile_mjcf(
        fmt::format("<mujoco><asset><mesh name=\"hull\" vertex=\"{}\" inertia=\"convex\"/></asset>"
                    "<worldbody><body><freejoint/><geom type=\"mesh\" mesh=\"hull\" "
                    "density=\"1240\"/></body></worldbody></mujoco>",
                    vertices),
        "hull.xml");
    const Matrix3d axes = rotation_at(model->body_iquat, 1);
    const Matrix3d inertia =
        axes * vector_at(model->body_inertia, 1).asDiagonal() * axes.transpose();
    EXPECT_NEAR(1240 * found.volume, model->body_mass[1], 1e-12 * model->body_mass[1]);
    EXPECT_NEAR((found.centre - vector_at(model->body_ipos, 1)).norm(), 0.0, 5e-9);
    EXPECT_NEAR((1240 * found.inertia() - inertia).norm(), 0.0, 5e-9);
  }
}

}  // namespace
}  // namespace legwright
