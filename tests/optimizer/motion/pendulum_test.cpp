// SPDX-License-Identifier: Apache-2.0
// How a COM sways over flat feet: balance of moments, symmetry and a closed form.
#include "optimizer/motion/pendulum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "optimizer/design/morphology.hpp"
#include "optimizer/motion/initial_guess.hpp"
#include "tests/support/flat_biped.hpp"

namespace legwright {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kHeight = 0.55, kHalfTrack = 0.09;
const std::vector<Vector2d> kFeet{{0.01, kHalfTrack}, {0.01, -kHalfTrack}};

Task walk(double duty, int knots, double period = 1.0) {
  Task task;
  task.gait = Gait({"walk", {0.0, 0.5}, duty}, period, knots, {0, 1});
  return task;
}

Vector2d acceleration(const Task& task, const std::vector<Vector2d>& path, int i) {
  const auto count = static_cast<int>(path.size());
  const auto at = [&](int k) { return path[static_cast<std::size_t>((k + count) % count)]; };
  const double h = task.gait.time_step();
  return (at(i - 1) - 2.0 * at(i) + at(i + 1)) / (h * h);
}

/// Where all force can act so that it turns nothing: on the ground, on the line of COM and g
/// up + a.
Vector2d balance_point(const Task& task, const std::vector<Vector2d>& path, int i) {
  Vector3d force = kGravity * task.up;
  force.head<2>() += acceleration(task, path, i);
  return path[static_cast<std::size_t>(i)] - kHeight / force.z() * force.head<2>();
}

/// Where a foot stands, seen from the moving path, from its touchdown to its lift-off.
Vector2d stands_at(const Task& task, int foot, int knot) {
  int first = knot, last = knot;
  while (task.gait.in_contact(first - 1, foot)) --first;
  while (task.gait.in_contact(last + 1, foot)) ++last;
  return kFeet[static_cast<std::size_t>(foot)] +
         (0.5 * (first + last) - knot) * task.gait.time_step() * task.velocity;
}

/// Most distance of the balance point from the one foot that stands, or from between both.
double worst_balance(const Task& task, const std::vector<Vector2d>& path) {
  double most = 0.0;
  for (int i = 0; i < task.gait.knot_count(); ++i) {
    const Vector2d point = balance_point(task, path, i), left = stands_at(task, 0, i),
                   right = stands_at(task, 1, i);
    const bool on_left = task.gait.in_contact(i, 0), on_right = task.gait.in_contact(i, 1);
    double miss = (point - (on_left ? left : right)).norm();
    if (on_left && on_right) {
      const Vector2d between = right - left;
      const double share =
          std::clamp((point - left).dot(between) / between.squaredNorm(), 0.0, 1.0);
      miss = (point - left - share * between).norm();
    }
    most = std::max(most, miss);
  }
  return most;
}

TEST(PendulumPath, FeetCarryItByTheirMiddles) {
  Task task = walk(0.6, 24);
  task.velocity = {0.1, 0.03};
  const std::vector<Vector2d> path = pendulum_path(task, kFeet, kHeight);
  ASSERT_EQ(path.size(), 24u);
  EXPECT_LT(worst_balance(task, path), 1e-12);
  EXPECT_GT(worst_balance(task, std::vector<Vector2d>(24, Vector2d::Zero())), 0.05)
      << "a COM that stays on its line walks on a rope";
  EXPECT_GT(worst_balance(task, pendulum_path(task, kFeet, 1.2 * kHeight)), 1e-3);
}

TEST(PendulumPath, FeetCarryItOnASlopeToo) {
  Task task = walk(0.6, 24);
  task.velocity = {0.1, 0.0};
  const std::vector<Vector2d> level = pendulum_path(task, kFeet, kHeight);
  task.up = up_on_slope(task.velocity, 0.3, -0.15);
  EXPECT_LT(worst_balance(task, pendulum_path(task, kFeet, kHeight)), 1e-12);
  EXPECT_GT(worst_balance(task, level), 0.05);
}

TEST(PendulumPath, SwaysAlikeToBothSides) {
  Task task = walk(0.65, 28);
  task.velocity = {0.08, 0.0};
  const std::vector<Vector2d> path = pendulum_path(task, kFeet, kHeight);
  double widest = 0.0;
  for (std::size_t i = 0; i < 28; ++i) {
    const Vector2d &here = path[i], &later = path[(i + 14) % 28];
    EXPECT_NEAR(here.x(), later.x(), 1e-12);
    EXPECT_NEAR(here.y(), -later.y(), 1e-12);
    widest = std::max(widest, std::abs(here.y()));
  }
  EXPECT_GT(widest, 0.005);
  EXPECT_LT(widest, kHalfTrack) << "it never gets above a foot";
  const std::vector<Vector2d> askew =
      pendulum_path(task, {{0.01, kHalfTrack}, {0.01, -0.05}}, kHeight);
  EXPECT_GT(std::abs(askew[3].y() + askew[17].y()), 1e-3);
}

TEST(PendulumPath, LeansToTheFootThatStands) {
  const Task task = walk(0.5, 24);
  const std::vector<Vector2d> path = pendulum_path(task, kFeet, kHeight);
  EXPECT_GT(path[6].y(), 0.005);  // in the middle of the left stance
  EXPECT_LT(path[18].y(), -0.005);
}

TEST(PendulumPath, DoesNotSwayWhereBothFeetAlwaysStand) {
  const Task task = walk(1.0, 24);
  for (const Vector2d& place : pendulum_path(task, {{0.0, 0.09}, {0.0, -0.09}}, kHeight))
    EXPECT_LT(place.norm(), 1e-12);
  for (const Vector2d& place : pendulum_path(task, {{0.02, 0.12}, {0.02, -0.06}}, kHeight))
    EXPECT_LT((place - Vector2d(0.02, 0.03)).norm(), 1e-12) << "above the middle of the feet";
}

/// Feet that a slope has moved downhill, so that gravity goes through their middle, leave nothing
/// to sway for.
TEST(PendulumPath, StandsOnASlopeAboveItsFootprint) {
  const test::Puppy biped = test::make_flat_biped();
  Task task = walk(1.0, 24);
  task.up = up_on_slope(task.velocity, 0.2, 0.1);
  const StyleTargets style = style_targets(biped.morphology, biped.space.initial(), task);
  const Vector2d level = home_stance(biped.morphology, biped.space.initial()).footprint[0];
  EXPECT_GT((style.footprint[0] - level).norm(), 0.05);
  const Vector2d middle(level.x(), 0.0);  // of the feet at home, ahead of the COM or behind
  for (const Vector2d& place : pendulum_path(task, style.footprint, style.com_height))
    EXPECT_LT((place - middle).norm(), 1e-12);
}

/// ÿ = (y − p) ω² for p = ±d by turns: y = d (1 − cosh ω(t − P/4)/cosh ωP/4) over the left stance,
/// and ẏ = d ω tanh ωP/4 at touchdown.
TEST(PendulumPath, SwaysByTheClosedFormForPressureThatJumps) {
  for (const double period : {0.8, 1.3})
    for (const double height : {0.3, 0.9}) {
      const double omega = std::sqrt(kGravity / height), quarter = 0.25 * omega * period;
      const auto widest = [&](int knots) {
        double most = 0.0;
        for (const Vector2d& place : pendulum_path(walk(0.5, knots, period), kFeet, height))
          most = std::max(most, place.y());
        return most;
      };
      const double exact = kHalfTrack * (1.0 - 1.0 / std::cosh(quarter));
      EXPECT_NEAR(widest(200), exact, 1e-3 * exact);
      EXPECT_NEAR(widest(24), exact, 0.05 * exact);
      EXPECT_GT(std::abs(widest(200) - kHalfTrack * (1.0 - 1.0 / std::cosh(1.1 * quarter))),
                0.03 * exact);
      double fastest = 0.0;
      const Task task = walk(0.5, 400, period);
      const std::vector<Vector2d> path = pendulum_path(task, kFeet, height);
      for (std::size_t i = 0; i + 1 < path.size(); ++i)
        fastest = std::max(fastest, (path[i + 1].y() - path[i].y()) / task.gait.time_step());
      EXPECT_NEAR(fastest / (kHalfTrack * omega), std::tanh(quarter), 0.03);
      EXPECT_GT(std::abs(fastest / (kHalfTrack * omega) - std::tanh(1.3 * quarter)), 0.03);
    }
}

}  // namespace
}  // namespace legwright
