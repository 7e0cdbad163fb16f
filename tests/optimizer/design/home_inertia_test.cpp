// SPDX-License-Identifier: Apache-2.0
// Moments of inertia of the home pose against sums over the point masses, their derivatives against
// central differences.
#include "optimizer/design/home_inertia.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "optimizer/design/kinematics.hpp"
#include "tests/support/puppy.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::Masses;

/// The puppy without ties, at a design of its own.
class PuppyAtHome {
 public:
  explicit PuppyAtHome(Masses masses) : puppy_(test::make_puppy(false)) {
    test::make_masses(puppy_, masses);
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    s = puppy_.space.initial();
    for (int k = 0; k < s.size(); ++k) s[k] += 0.1 * puppy_.space.scale()[k] * normal(random);
    parameters_.resize(static_cast<std::size_t>(s.size()));
    std::iota(parameters_.begin(), parameters_.end(), 0);
  }
  HomeInertia at(const VectorXd& design) const {
    return home_inertia(puppy_.morphology, parameters_, design);
  }
  Matrix3d summed() const {
    const GeometryAtDesign geometry(puppy_.morphology, s);
    const PoseKinematics home = home_pose(puppy_.morphology, geometry);
    const Vector3d com = home.first_moment(0) / geometry.total_mass;
    Matrix3d sum = Matrix3d::Zero();
    for (std::size_t l = 0; l < puppy_.morphology.links.size(); ++l)
      for (const PointMass& point : puppy_.morphology.links[l].masses) {
        const int link = static_cast<int>(l);
        const Vector3d arm = home.origin(link) + home.rotation(link) * point.at(s) - com;
        sum += point.mass * point.growth_at(s) *
               (arm.squaredNorm() * Matrix3d::Identity() - arm * arm.transpose());
      }
    return sum;
  }
  double scale(int k) const { return puppy_.space.scale()[k]; }

  VectorXd s;

 private:
  test::Puppy puppy_;
  std::vector<int> parameters_;
};

TEST(HomeInertia, IsTheSumOverPointMassesAboutTheirCentre) {
  for (const Masses masses : {Masses::plain, Masses::printed, Masses::turning}) {
    const PuppyAtHome puppy(masses);
    const Matrix3d wanted = puppy.summed();
    EXPECT_LT((symmetric_matrix(puppy.at(puppy.s).value) - wanted).norm(), 1e-12 * wanted.norm());
  }
}

TEST(HomeInertia, DerivativesMatchCentralDifferences) {
  for (const Masses masses : {Masses::plain, Masses::printed, Masses::turning}) {
    const PuppyAtHome puppy(masses);
    const HomeInertia exact = puppy.at(puppy.s);
    const double size = exact.value.norm();
    for (int k = 0; k < puppy.s.size(); ++k) {
      const double step = 1e-5 * puppy.scale(k);
      VectorXd up = puppy.s, down = puppy.s;
      up[k] += step;
      down[k] -= step;
      const HomeInertia above = puppy.at(up), below = puppy.at(down);
      const HomeInertia::Entries slope = (above.value - below.value) / (2 * step);
      EXPECT_LT((exact.jacobian.row(k).transpose() - slope).norm() * puppy.scale(k), 1e-9 * size)
          << k;
      const MatrixXd bend = (above.jacobian - below.jacobian) / (2 * step);
      for (int entry = 0; entry < 6; ++entry) {
        const VectorXd found = exact.hessian[static_cast<std::size_t>(entry)].col(k);
        const double unit = puppy.scale(k) * puppy.scale(k);
        EXPECT_LT((found - bend.col(entry)).norm() * unit, 1e-8 * size) << k << ", " << entry;
      }
    }
  }
}

TEST(HomeInertia, ChangesWithLengthsAndAxes) {  // else the derivatives above would be trivial
  const PuppyAtHome puppy(Masses::plain);
  const HomeInertia exact = puppy.at(puppy.s);
  EXPECT_GT(exact.jacobian.rowwise().norm().minCoeff(), 1e-6);
}

}  // namespace
}  // namespace legwright
