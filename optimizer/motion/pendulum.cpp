// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/pendulum.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "optimizer/design/morphology.hpp"

namespace legwright {
namespace {

using Eigen::Vector2d;

/// Half the knots at which a foot stands beside others: over so many it takes its load, and gives
/// it.
int overlap(const Gait& gait, int foot) {
  int knots = 0;
  for (int i = 0; i < gait.knot_count(); ++i) {
    int standing = 0;
    for (int j = 0; j < gait.foot_count(); ++j) standing += gait.in_contact(i, j);
    knots += gait.in_contact(i, foot) && standing > 1;
  }
  return std::max(1, knots / 2);
}

/// Between the feet that stand at a knot, seen from the moving path; a foot's load rises after its
/// touchdown and falls before its lift-off.
Vector2d centre_of_pressure(const Task& task, const std::vector<Vector2d>& footprint, int knot) {
  Vector2d sum = Vector2d::Zero();
  double load = 0.0;
  for (int foot = 0; foot < task.gait.foot_count(); ++foot) {
    if (!task.gait.in_contact(knot, foot)) continue;
    const Stance stance = task.gait.stance_around(knot, foot, 0);
    const double full = overlap(task.gait, foot) + 1.0;
    const double share =
        std::min({1.0, (knot - stance.first + 1) / full, (stance.last - knot + 1) / full});
    const double ahead = 0.5 * (stance.first + stance.last) - knot;  // knots to mid-stance
    const Vector2d place =
        footprint[static_cast<std::size_t>(foot)] + ahead * task.gait.time_step() * task.velocity;
    sum += share * place;
    load += share;
  }
  return load > 0.0 ? Vector2d(sum / load) : Vector2d::Zero();
}

}  // namespace

std::vector<Vector2d> pendulum_path(const Task& task, const std::vector<Vector2d>& footprint,
                                    double com_height) {
  const int T = task.gait.knot_count();
  const double h = task.gait.time_step();
  const double rate = h * h * kGravity * task.up.z() / com_height;  // what presses on the ground
  // x_{i−1} − (2 + rate) x_i + x_{i+1} = −rate p_i, once round the cycle.
  Eigen::MatrixXd pendulum = Eigen::MatrixXd::Zero(T, T);
  Eigen::MatrixX2d pressure(T, 2);
  const Vector2d downhill = -com_height / task.up.z() * task.up.head<2>();  // where gravity points
  for (int i = 0; i < T; ++i) {
    pendulum(i, i) -= 2.0 + rate;
    pendulum(i, (i + 1) % T) += 1.0;
    pendulum(i, (i + T - 1) % T) += 1.0;
    pressure.row(i) = -rate * (centre_of_pressure(task, footprint, i) - downhill).transpose();
  }
  const Eigen::MatrixX2d path = pendulum.partialPivLu().solve(pressure);
  std::vector<Vector2d> out;
  for (int i = 0; i < T; ++i) out.push_back(path.row(i).transpose());
  return out;
}

}  // namespace legwright
