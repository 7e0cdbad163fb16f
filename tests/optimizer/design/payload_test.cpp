// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/payload.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

TEST(Payload, ItsPointsHaveMassCentreAndInertiaOfTheBox) {
  const Payload box{1.5, {0.1, -0.2, 0.3}, {0.2, 0.1, 0.05}};
  double mass = 0.0;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();  // Σ m u uᵀ about the centre
  for (const PointMass& point : point_masses(box)) {
    const Vector3d place = point.position.at(Eigen::VectorXd());
    mass += point.mass;
    first += point.mass * place;
    second += point.mass * (place - box.position) * (place - box.position).transpose();
    EXPECT_TRUE(((place - box.position).cwiseAbs().array() < box.size.array() / 2).all());
    EXPECT_TRUE(point.growth.empty());
  }
  EXPECT_NEAR(mass, 1.5, 1e-15);
  EXPECT_LT((first / mass - box.position).norm(), 1e-15);
  const Matrix3d expected = (1.5 / 12.0 * box.size.cwiseAbs2()).asDiagonal();  // ∫ x² over an edge
  EXPECT_LT((second - expected).norm(), 1e-15);
}

TEST(Payload, ALitreOfWaterIsADecimetreWide) { EXPECT_NEAR(water_cube(1.0), 0.1, 1e-15); }

}  // namespace
}  // namespace legwright
