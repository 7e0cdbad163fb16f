// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/rotation.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d rotation(const Vector3d& o) {
  RotationDerivatives at;
  rotation_of_vector(o, 0, at);
  return at.rotation;
}

/// Angles around zero, around the switch from series to closed form (t² = 0.05), and large ones.
class RotationOfVector : public testing::TestWithParam<double> {
 protected:
  Vector3d o_ = GetParam() * Vector3d(0.36, -0.48, 0.8);
};

TEST_P(RotationOfVector, IsRodrigues) {
  const double angle = o_.norm();
  const Matrix3d expected =
      angle > 0 ? Eigen::AngleAxisd(angle, o_ / angle).toRotationMatrix() : Matrix3d::Identity();
  EXPECT_LT((rotation(o_) - expected).norm(), 1e-14);
}

TEST_P(RotationOfVector, DerivativesMatchDifferences) {
  RotationDerivatives at;
  rotation_of_vector(o_, 2, at);
  const double h = 1e-4;
  for (int a = 0; a < 3; ++a) {
    const Vector3d ea = h * Vector3d::Unit(a);
    const Matrix3d first = (rotation(o_ + ea) - rotation(o_ - ea)) / (2 * h);
    EXPECT_LT((skew(at.turn[a]) * at.rotation - first).norm(), 1e-8);
    for (int b = 0; b < 3; ++b) {
      const Vector3d eb = h * Vector3d::Unit(b);
      const Matrix3d second = (rotation(o_ + ea + eb) - rotation(o_ + ea - eb) -
                               rotation(o_ - ea + eb) + rotation(o_ - ea - eb)) /
                              (4 * h * h);
      EXPECT_LT((at.second[a][b] * at.rotation - second).norm(), 2e-7);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Angles, RotationOfVector,
                         testing::Values(0.0, 1e-9, 1e-3, 0.2235, 0.2237, 1.0, 2.5));

TEST(RotationOfVectorSeries, MeetsTheClosedForm) {
  // Both sides of the switch give the same second derivatives: nothing jumps.
  RotationDerivatives below, above;
  const Vector3d direction = Vector3d(1, 2, -2) / 3.0;
  rotation_of_vector(std::sqrt(0.05) * (1 - 1e-9) * direction, 2, below);
  rotation_of_vector(std::sqrt(0.05) * (1 + 1e-9) * direction, 2, above);
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) EXPECT_LT((below.second[a][b] - above.second[a][b]).norm(), 1e-8);
}

TEST(RotationAbout, TurnsTheAxisNotAtAll) {
  const Vector3d axis = Vector3d(1, 2, 2) / 3.0;
  EXPECT_LT((rotation_about(axis, 0.7) * axis - axis).norm(), 1e-15);
  EXPECT_GT((rotation_about(axis, 0.7) * Vector3d::UnitX() - Vector3d::UnitX()).norm(), 0.1);
  EXPECT_EQ(unskew(skew(axis)), axis);
}

TEST(SmallestRotation, TakesOneDirectionToTheOtherAboutTheirNormal) {
  const Vector3d from(0.3, -2.0, 0.7), to(1.0, 0.4, -0.2);
  const Eigen::Quaterniond turn = smallest_rotation(from, to);
  EXPECT_LT((turn * from.normalized() - to.normalized()).norm(), 1e-15);
  EXPECT_NEAR(turn.vec().dot(from), 0.0, 1e-15);
  EXPECT_NEAR(turn.vec().dot(to), 0.0, 1e-15);
  EXPECT_EQ(turn.coeffs(), Eigen::Quaterniond::FromTwoVectors(from, to).coeffs());
}

TEST(SmallestRotation, TurnsHalfwayRoundAnAxisThatIsPerpendicular) {
  const Vector3d down = -Vector3d::UnitZ();
  EXPECT_EQ(smallest_rotation(Vector3d::UnitZ(), down).coeffs(), Eigen::Vector4d(1, 0, 0, 0));
  for (const Vector3d& from : {Vector3d(1, 0, 0), Vector3d(0, 3, 0), Vector3d(0.3, -2.0, 0.7)}) {
    const Eigen::Quaterniond turn = smallest_rotation(from, -from);
    EXPECT_NEAR(turn.norm(), 1.0, 1e-15);
    EXPECT_LT((turn * from + from).norm(), 1e-14);
  }
}

}  // namespace
}  // namespace legwright
