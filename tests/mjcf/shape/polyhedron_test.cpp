// SPDX-License-Identifier: Apache-2.0
// What hulls weigh: against MuJoCo's own meshes, and as their corners move.
#include "mjcf/shape/polyhedron.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "mjcf/text/compile.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/text/numbers.hpp"

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

/// Σ m p̂ p̂ᵀ at a design.
Eigen::Matrix4d moments_at(const std::vector<PointMass>& masses, const Eigen::VectorXd& s) {
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
  for (const PointMass& point : masses) {
    const Eigen::Vector4d p = point.position.at(s).homogeneous();
    sum += point.mass * point.growth_at(s) * p * p.transpose();
  }
  return sum;
}

Eigen::Matrix4d moments_at(const std::vector<Facet>& facets,
                           const std::vector<AffineVector>& points, double density,
                           const Eigen::VectorXd& s) {
  std::vector<Vector3d> now;
  for (const AffineVector& point : points) now.push_back(point.at(s));
  const SolidMoments found = moments_of_solid(facets, now);
  Eigen::Matrix4d out;
  out.topLeftCorner<3, 3>() = found.second + found.volume * found.centre * found.centre.transpose();
  out.topRightCorner<3, 1>() = found.volume * found.centre;
  out.bottomLeftCorner<1, 3>() = found.volume * found.centre.transpose();
  out(3, 3) = found.volume;
  return density * out;
}

/// Half of the points go with parameter 0, and some with 2.
std::vector<AffineVector> moving_cloud(unsigned seed) {
  const Vector3d along = Vector3d(1, 2, -2) / 3.0, across = Vector3d(2, 1, 2) / 3.0;
  std::vector<AffineVector> out;
  for (const Vector3d& point : cloud(seed)) {
    AffineVector moving{point, {}};
    const bool far = out.size() % 2 == 0;
    if (far) moving.constant -= 0.07 * along;
    if (far) moving.slopes.push_back({0, along});
    if (out.size() % 3 == 0) moving.constant -= 0.02 * across;
    if (out.size() % 3 == 0) moving.slopes.push_back({2, 0.4 * across});
    out.push_back(moving);
  }
  return out;
}

TEST(Polyhedron, MassesAreItsOwnForEveryDesign) {
  const Eigen::Vector3d initial(0.08, 7.0, 0.05);
  for (unsigned seed = 0; seed < 10; ++seed) {
    const std::vector<AffineVector> points = moving_cloud(seed);
    std::vector<Vector3d> now;
    for (const AffineVector& point : points) now.push_back(point.at(initial));
    const std::vector<Facet> facets = convex_hull(now);
    const std::vector<PointMass> masses = masses_of_solid(facets, points, 1240.0, initial);
    EXPECT_EQ(masses.size(), 44u);  // 4 terms of the volume, 11 places each
    for (const Vector3d& s : {Vector3d(0.08, 7.0, 0.05), Vector3d(0.1, 1.0, 0.05),
                              Vector3d(0.07, 1.0, 0.09), Vector3d(0.13, 2.0, 0.03)}) {
      const Eigen::Matrix4d wanted = moments_at(facets, points, 1240.0, s);
      const Eigen::Matrix4d found = moments_at(masses, s);
      EXPECT_NEAR((found - wanted).norm(), 0.0, 1e-11 * wanted.norm());
      double volume = 0.0;
      for (const PointMass& point : masses) volume += point.volume * point.growth_at(s);
      EXPECT_NEAR(1240.0 * volume, wanted(3, 3), 1e-11 * wanted(3, 3));
    }
  }
}

TEST(Polyhedron, OfPointsThatStayIsSevenMasses) {
  std::vector<AffineVector> points;
  const std::vector<Vector3d> still = cloud(3);
  for (const Vector3d& point : still) points.push_back({point, {}});
  const std::vector<Facet> facets = convex_hull(still);
  const std::vector<PointMass> masses =
      masses_of_solid(facets, points, 1000.0, Eigen::VectorXd::Ones(1));
  EXPECT_EQ(masses.size(), 7u);
  const Eigen::VectorXd s = Eigen::VectorXd::Constant(1, 2.0);
  const Eigen::Matrix4d wanted = moments_at(facets, points, 1000.0, s);
  EXPECT_NEAR((moments_at(masses, s) - wanted).norm(), 0.0, 1e-13 * wanted.norm());
}

// Two directions of one parameter would make volumes that are not affine in it.
TEST(Polyhedron, RefusesTwoDirectionsOfOneParameter) {
  std::vector<AffineVector> points = moving_cloud(1);
  points[0].slopes[0].slope = Vector3d::UnitX();
  points[2].slopes[0].slope = Vector3d::UnitY();
  std::vector<Vector3d> now;
  for (const AffineVector& point : points) now.push_back(point.at(Vector3d(0.08, 7.0, 0.05)));
  EXPECT_THROW(masses_of_solid(convex_hull(now), points, 1.0, Vector3d(0.08, 7.0, 0.05)),
               std::logic_error);
}

}  // namespace
}  // namespace legwright
