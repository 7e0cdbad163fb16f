// SPDX-License-Identifier: Apache-2.0
#include "plugin/spline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/plugin/allocation_count.hpp"
#include "tests/plugin/toy_trajectory.hpp"

namespace legwright {
namespace {

constexpr int kKnots = 9;
constexpr double kPeriod = 0.63;  // s
constexpr double kKnotInterval = kPeriod / kKnots;

class SplineTest : public testing::Test {
 protected:
  SplineTest() {
    trajectory.travel = {0.3, -0.2, 0.05};
    trajectory.turn = 0.4;
  }

  /// Control point of any knot number, cycles beyond the table included.
  double control(int knot, int column, double drift) const {
    const int cycle = static_cast<int>(std::floor(static_cast<double>(knot) / kKnots));
    return trajectory.at(knot - cycle * kKnots, column) + cycle * drift;
  }

  SplinePoint point(double time, int column, double drift) const {
    return spline_point(trajectory, phase_at(trajectory, time), column, drift);
  }

  Trajectory trajectory = toy_trajectory(2, 2, kKnots, kPeriod, 7);
};

TEST_F(SplineTest, AtAKnotHasThePlannersDifferences) {
  const int column = trajectory.root_column(0);
  const double drift = trajectory.travel[0];
  for (int knot = -2 * kKnots; knot <= 3 * kKnots; ++knot) {
    const double before = control(knot - 1, column, drift), here = control(knot, column, drift),
                 after = control(knot + 1, column, drift);
    const SplinePoint p = point(knot * kKnotInterval, column, drift);
    EXPECT_NEAR(p.value, (before + 4.0 * here + after) / 6.0, 1e-12) << knot;
    EXPECT_NEAR(p.rate, (after - before) / (2.0 * kKnotInterval), 1e-11) << knot;
    EXPECT_NEAR(p.acceleration, (before - 2.0 * here + after) / (kKnotInterval * kKnotInterval),
                1e-9)
        << knot;
  }
}

TEST_F(SplineTest,
       DoesNotPassThroughItsKnots) {  // an interpolating spline would, and would be wrong
  const int column = trajectory.target_column(0);
  const double gap = point(3 * kKnotInterval, column, 0.0).value - trajectory.at(3, column);
  EXPECT_GT(std::abs(gap), 1e-3);
}

TEST_F(SplineTest, MatchesTheTruncatedPowerFormOfTheBasis) {
  // B(x) = Σ (−1)^k C(4, k) max(0, x + 2 − k)³ / 6 is the same basis, written without pieces.
  const auto basis = [](double x) {
    const double binomial[] = {1, -4, 6, -4, 1};
    double sum = 0.0;
    for (int k = 0; k <= 4; ++k) sum += binomial[k] * std::pow(std::max(0.0, x + 2.0 - k), 3) / 6.0;
    return sum;
  };
  const int column = trajectory.com_column(1);
  const double drift = trajectory.travel[1];
  for (double time = -1.0; time < 2.0; time += 0.0137) {
    double expected = 0.0;
    for (int knot = -20; knot < 40; ++knot) {
      expected += basis(time / kKnotInterval - knot) * control(knot, column, drift);
    }
    EXPECT_NEAR(point(time, column, drift).value, expected, 1e-10) << time;
  }
}

TEST_F(SplineTest, DerivativesMatchDifferences) {
  const int column = trajectory.target_column(1);
  constexpr double kDelta = 1e-5;
  for (double time = 0.001; time < kPeriod; time += 0.0171) {
    const SplinePoint p = point(time, column, 0.0);
    const SplinePoint ahead = point(time + kDelta, column, 0.0);
    const SplinePoint behind = point(time - kDelta, column, 0.0);
    EXPECT_NEAR(p.rate, (ahead.value - behind.value) / (2 * kDelta), 1e-5) << time;
    EXPECT_NEAR(p.acceleration, (ahead.rate - behind.rate) / (2 * kDelta), 5e-2) << time;
  }
}

TEST_F(SplineTest, RepeatsAndMovesOnByTravelAndTurn) {
  TrajectorySample now, later;
  for (double time = 0.0; time < kPeriod; time += 0.0193) {
    sample(trajectory, time, now);
    sample(trajectory, time + 5 * kPeriod, later);
    for (std::size_t joint = 0; joint < 2; ++joint) {
      EXPECT_NEAR(later.target[joint], now.target[joint], 1e-12);
      EXPECT_NEAR(later.torque[joint], now.torque[joint], 1e-12);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(later.root[axis] - now.root[axis], 5 * trajectory.travel[axis], 1e-11);
      EXPECT_NEAR(later.com[axis] - now.com[axis], 5 * trajectory.travel[axis], 1e-11);
      EXPECT_NEAR(later.foot[1][axis] - now.foot[1][axis], 5 * trajectory.travel[axis], 1e-11);
      EXPECT_NEAR(later.root_rate[axis], now.root_rate[axis], 1e-10);
    }
    EXPECT_NEAR(later.root[3], now.root[3], 1e-12);
    EXPECT_NEAR(later.root[5] - now.root[5], 5 * trajectory.turn, 1e-11);
  }
}

TEST_F(SplineTest, StraightLineOfKnotsGivesUniformMotion) {
  for (int knot = 0; knot < kKnots; ++knot) {
    trajectory.at(knot, trajectory.root_column(0)) = 1.0 + trajectory.travel[0] * knot / kKnots;
  }
  for (double time = -1.0; time < 2.0; time += 0.0271) {
    const SplinePoint p = point(time, trajectory.root_column(0), trajectory.travel[0]);
    EXPECT_NEAR(p.value, 1.0 + trajectory.travel[0] * time / kPeriod, 1e-12);
    EXPECT_NEAR(p.rate, trajectory.travel[0] / kPeriod, 1e-12);
    EXPECT_NEAR(p.acceleration, 0.0, 1e-10);
  }
}

TEST_F(SplineTest, TorqueAndForceAreLinearBetweenKnotsAndContactIsTheNearestKnots) {
  TrajectorySample out;
  const int last = kKnots - 1;
  sample(trajectory, (last + 0.25) * kKnotInterval,
         out);  // between the last knot and the first one again
  const auto between = [&](int column) {
    return 0.75 * trajectory.at(last, column) + 0.25 * trajectory.at(0, column);
  };
  EXPECT_NEAR(out.torque[1], between(trajectory.torque_column(1)), 1e-12);
  EXPECT_NEAR(out.force[1][2], between(trajectory.force_column(1, 2)), 1e-12);
  sample(trajectory, 3.4 * kKnotInterval, out);
  EXPECT_EQ(out.contact[0], true);
  EXPECT_EQ(out.contact[1], false);
  sample(trajectory, 3.6 * kKnotInterval, out);
  EXPECT_EQ(out.contact[0], false);
}

TEST_F(SplineTest, AnyTimeGivesAPhaseWithinTheTable) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double time :
       {0.0, -0.0, -1e-300, 1e-300, kPeriod, -kPeriod, std::nextafter(kPeriod, 0.0), 1e6, -1e6,
        1e300, -1e300, kInfinity, -kInfinity, std::nan("")}) {
    const SplinePhase phase = phase_at(trajectory, time);
    double sum = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_GE(phase.knot[k], 0) << time;
      EXPECT_LT(phase.knot[k], kKnots) << time;
      sum += phase.value[k];
    }
    EXPECT_NEAR(sum, 1.0, 1e-14) << time;
    EXPECT_GE(phase.fraction, 0.0) << time;
    EXPECT_LE(phase.fraction, 1.0) << time;
  }
}

TEST_F(SplineTest, SamplingAgainAllocatesNothing) {
  TrajectorySample out;
  const long before_first = allocation_count();
  sample(trajectory, 0.0, out);
  EXPECT_GT(allocation_count(), before_first);  // the counter counts
  const long before = allocation_count();
  for (int i = 0; i < 100; ++i) sample(trajectory, 0.01 * i, out);
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace legwright
