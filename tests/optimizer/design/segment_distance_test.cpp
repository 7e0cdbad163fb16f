// SPDX-License-Identifier: Apache-2.0
// Distance of two segments: exact away from its switches, close and twice differentiable at them,
// finite always.
#include "optimizer/design/segment_distance.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <random>

namespace legwright {
namespace {

using Eigen::Vector3d;
using Ends = Eigen::Matrix<double, 12, 1>;

constexpr double kRounding = 0.005;

SegmentDistance measure(const Ends& z, DistanceDetail detail = DistanceDetail::hessian) {
  return segment_distance(z.segment<3>(0), z.segment<3>(3), z.segment<3>(6), z.segment<3>(9),
                          kRounding, detail);
}

double point_to_segment(const Vector3d& x, const Vector3d& p, const Vector3d& q) {
  const Vector3d u = q - p;
  const double t =
      u.squaredNorm() > 0.0 ? std::clamp((x - p).dot(u) / u.squaredNorm(), 0.0, 1.0) : 0.0;
  return (x - p - t * u).norm();
}

/// By cases: the lines' nearest points where they are inside, else the nearest of four ends to the
/// other segment.
double by_cases(const Ends& z) {
  const Vector3d p1 = z.segment<3>(0), q1 = z.segment<3>(3), p2 = z.segment<3>(6),
                 q2 = z.segment<3>(9);
  const double nearest_end = std::min({point_to_segment(p1, p2, q2), point_to_segment(q1, p2, q2),
                                       point_to_segment(p2, p1, q1), point_to_segment(q2, p1, q1)});
  const Vector3d u = q1 - p1, v = q2 - p2, w = p1 - p2;
  Eigen::Matrix2d A;
  A << u.dot(u), -u.dot(v), -u.dot(v), v.dot(v);
  if (A.determinant() < 1e-12 * A(0, 0) * A(1, 1)) return nearest_end;
  const Eigen::Vector2d st = A.inverse() * Eigen::Vector2d(-u.dot(w), v.dot(w));
  if (st.minCoeff() < 0.0 || st.maxCoeff() > 1.0) return nearest_end;
  return std::min(nearest_end, (w + st[0] * u - st[1] * v).norm());
}

/// Segments of about a tenth of a metre, a few centimetres apart.
Ends random_ends(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Ends z;
  for (double& value : z) value = 0.06 * normal(random);
  return z;
}

TEST(SegmentDistance, IsNeverBelowAndHardlyAboveTheDistance) {
  std::mt19937 random(1);
  int exact = 0;
  double excess = 0.0;  // of the square, in lengths²
  for (int repeat = 0; repeat < 20000; ++repeat) {
    const Ends z = random_ends(random);
    const double expected = by_cases(z), found = measure(z, DistanceDetail::value).value;
    if (expected < kRounding) continue;
    ASSERT_GT(found, expected - 1e-13);
    const double longest = std::max((z.segment<3>(3) - z.segment<3>(0)).norm(),
                                    (z.segment<3>(9) - z.segment<3>(6)).norm());
    excess = std::max(excess, (found * found - expected * expected) / (longest * longest));
    exact += std::abs(found - expected) < 1e-12;
  }
  EXPECT_LT(excess, 1e-3);
  EXPECT_GT(exact, 15000) << "away from its switches the closed form is exact";
}

struct Case {
  const char* what;
  Ends ends;
  double distance;
};

Ends ends_of(const Vector3d& p1, const Vector3d& q1, const Vector3d& p2, const Vector3d& q2) {
  return (Ends() << p1, q1, p2, q2).finished();
}

TEST(SegmentDistance, KnowsEveryCaseExactly) {
  const Case cases[] = {
      {"crossing", ends_of({-1, 0, 0}, {1, 0, 0}, {0, -1, 0.3}, {0, 1, 0.3}), 0.3},
      {"end over segment", ends_of({0, 0, 0.2}, {0, 0, 1}, {-1, 0, 0}, {1, 0, 0}), 0.2},
      {"end to end", ends_of({0, 0, 0}, {-1, 0, 0}, {3, 4, 0}, {4, 8, 0}), 5.0},
      {"parallel, side by side", ends_of({0, 0, 0}, {1, 0, 0}, {0, 0.4, 0}, {1, 0.4, 0}), 0.4},
      {"antiparallel", ends_of({0, 0, 0}, {1, 0, 0}, {1, 0.4, 0}, {0, 0.4, 0}), 0.4},
      {"parallel, one after the other", ends_of({0, 0, 0}, {1, 0, 0}, {4, 4, 0}, {9, 4, 0}), 5.0},
      {"on one line", ends_of({0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {4, 0, 0}), 2.0},
      {"a point and a segment", ends_of({0, 0, 0.7}, {0, 0, 0.7}, {-1, 0, 0}, {1, 0, 0}), 0.7},
      {"a segment and a point", ends_of({-1, 0, 0}, {1, 0, 0}, {0, 0, 0.7}, {0, 0, 0.7}), 0.7},
      {"two points", ends_of({0, 0, 0}, {0, 0, 0}, {0, 3, 4}, {0, 3, 4}), 5.0},
  };
  for (const Case& c : cases) {
    const SegmentDistance at = measure(c.ends);
    EXPECT_NEAR(at.value, c.distance, 1e-12) << c.what;
    EXPECT_EQ(at.value, measure(c.ends, DistanceDetail::value).value) << c.what;
    const SegmentDistance slope = measure(c.ends, DistanceDetail::gradient);
    EXPECT_EQ(at.value, slope.value) << c.what;
    EXPECT_EQ(at.gradient, slope.gradient) << c.what;
    EXPECT_TRUE(at.gradient.allFinite() && at.hessian.allFinite()) << c.what;
  }
}

TEST(SegmentDistance, IsFiniteWhereSegmentsTouchOrCoincide) {
  const Ends touching[] = {
      ends_of({-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}),  // cross
      ends_of({0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 1, 0}),    // share an end
      ends_of({0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}),    // the same
      ends_of({0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}),    // all in one point
  };
  for (const Ends& z : touching) {
    const SegmentDistance at = measure(z);
    EXPECT_TRUE(std::isfinite(at.value) && at.gradient.allFinite() && at.hessian.allFinite());
    EXPECT_GE(at.value, 0.0);
    EXPECT_LT(at.value, 0.02);
  }
}

/// Largest relative error of gradient and Hessian against central differences.
double derivative_error(const Ends& z, double step) {
  const SegmentDistance at = measure(z);
  Ends gradient;
  Eigen::Matrix<double, 12, 12> hessian;
  for (int k = 0; k < 12; ++k) {
    const Ends e = step * Ends::Unit(k);
    const SegmentDistance up = measure(z + e), down = measure(z - e);
    gradient[k] = (up.value - down.value) / (2 * step);
    hessian.col(k) = (up.gradient - down.gradient) / (2 * step);
  }
  const double scale = std::max(1.0, at.hessian.cwiseAbs().maxCoeff());
  return std::max((gradient - at.gradient).cwiseAbs().maxCoeff(),
                  (hessian - at.hessian).cwiseAbs().maxCoeff() / scale);
}

TEST(SegmentDistance, DerivativesMatchCentralDifferences) {
  std::mt19937 random(2);
  for (int repeat = 0; repeat < 500; ++repeat)
    EXPECT_LT(derivative_error(random_ends(random), 1e-7), 1e-4) << repeat;
}

/// Walks from one configuration to another and returns the largest jump of the Hessian between
/// neighbours, relative to the largest Hessian on the way.
double largest_jump(const Ends& from, const Ends& to, int steps) {
  double jump = 0.0, largest = 0.0;
  Eigen::Matrix<double, 12, 12> last = measure(from).hessian;
  for (int k = 1; k <= steps; ++k) {
    const double share = static_cast<double>(k) / steps;
    const SegmentDistance at = measure((1 - share) * from + share * to);
    EXPECT_TRUE(at.hessian.allFinite());
    jump = std::max(jump, (at.hessian - last).cwiseAbs().maxCoeff());
    largest = std::max(largest, at.hessian.cwiseAbs().maxCoeff());
    last = at.hessian;
  }
  return jump / largest;
}

TEST(SegmentDistance, SecondDerivativesAreContinuousAcrossSwitches) {
  const Ends crossing = ends_of({-0.05, 0, 0}, {0.05, 0, 0}, {0, -0.05, 0.03}, {0.01, 0.05, 0.03});
  const Ends end_over = ends_of({0.02, 0, 0}, {0.12, 0, 0}, {0, -0.05, 0.03}, {0.01, 0.05, 0.03});
  const Ends end_to_end =
      ends_of({0.02, 0.07, 0}, {0.12, 0.07, 0}, {0, -0.05, 0.03}, {0.01, 0.05, 0.03});
  const Ends along =
      ends_of({-0.05, 0, 0}, {0.05, 0, 0}, {-0.05, 0.001, 0.03}, {0.05, 0.001, 0.03});
  const Ends tilted =
      ends_of({-0.05, 0, 0}, {0.05, 0, 0.02}, {-0.05, 0.001, 0.05}, {0.05, 0.001, 0.03});
  const Ends touching =
      ends_of({-0.05, 0, 0}, {0.05, 0, 0}, {0, -0.05, -0.01}, {0.01, 0.05, -0.01});
  const std::pair<Ends, Ends> ways[] = {
      {crossing, end_over}, {end_over, end_to_end}, {crossing, end_to_end}, {crossing, along},
      {along, tilted},      {end_over, along},      {crossing, touching}};
  for (const auto& [from, to] : ways) {
    // A jump would stay as it is on a finer walk; a steep slope halves.
    const double coarse = largest_jump(from, to, 20000), fine = largest_jump(from, to, 80000);
    EXPECT_LT(fine, 0.01);
    EXPECT_LT(fine, 0.5 * coarse + 1e-9);
    for (int k = 0; k <= 200; ++k)
      EXPECT_LT(derivative_error(from + k / 200.0 * (to - from), 1e-8), 2e-3) << k;
  }
}

TEST(SegmentDistanceControl, AClampWithoutRoundingWouldJump) {
  // The distance by cases: its second difference along a way across a switch does jump.
  const Ends crossing = ends_of({-0.05, 0, 0}, {0.05, 0, 0}, {0, -0.05, 0.03}, {0.01, 0.05, 0.03});
  const Ends end_over = ends_of({0.02, 0, 0}, {0.12, 0, 0}, {0, -0.05, 0.03}, {0.01, 0.05, 0.03});
  const auto largest = [&](double (*distance)(const Ends&), int steps) {
    double jump = 0.0, last = 0.0;
    const double h = 1.0 / steps;
    for (int k = 1; k < steps; ++k) {
      const auto at = [&](int i) -> double {
        return distance(crossing + i * h * (end_over - crossing));
      };
      const double bend = (at(k + 1) - 2 * at(k) + at(k - 1)) / (h * h);
      if (k > 1) jump = std::max(jump, std::abs(bend - last));
      last = bend;
    }
    return jump;
  };
  const auto smooth = [](const Ends& z) { return measure(z, DistanceDetail::value).value; };
  EXPECT_GT(largest(by_cases, 1000), 20 * largest(smooth, 1000));
}

}  // namespace
}  // namespace legwright
