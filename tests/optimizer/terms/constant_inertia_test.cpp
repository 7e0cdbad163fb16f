// SPDX-License-Identifier: Apache-2.0
// Equation (13) as the paper has it, against a calculation by hand.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/optimizer/terms/term_bench.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Bench = test::TermBench;

TEST(TermsByHand, TorqueBalanceWithConstantInertia) {
  Bench b("torque_balance", false, Dynamics::constant_inertia);
  const int at = b.layout().home_inertia();
  Matrix3d inertia;
  inertia << b.x[at], b.x[at + 3], b.x[at + 4], b.x[at + 3], b.x[at + 1], b.x[at + 5], b.x[at + 4],
      b.x[at + 5], b.x[at + 2];
  const auto turned = [&](int knot) { return b.at(b.layout().pose(knot) + 3); };
  for (const int knot : {0, 2}) {
    const Vector3d x = b.at(b.layout().com(knot));
    const Vector3d before = knot > 0 ? turned(knot - 1) : turned(7) - 0.24 * Vector3d::UnitZ();
    const Matrix3d heading = Bench::heading(knot * b.h());
    Vector3d sum = -heading * inertia * heading.transpose() *
                   (before - 2 * turned(knot) + turned(knot + 1)) / (b.h() * b.h());
    for (int j = 0; j < 4; ++j) {
      const int f = b.layout().force(knot, j);
      if (f < 0) continue;
      const Vector3d ground =
          b.at(b.layout().foot(knot, j)) - b.robot().feet[j].radius * Vector3d::UnitZ();
      sum += (ground - x).cross(b.at(f));
    }
    b.expect(knot, b.layout().com(knot), sum / (b.weight() * b.leg()));
  }
}

}  // namespace
}  // namespace legwright
