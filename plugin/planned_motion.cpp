// SPDX-License-Identifier: Apache-2.0
#include "plugin/planned_motion.hpp"

#include <cmath>

namespace legwright {
namespace {

std::array<double, 2> rotated(double x, double y, double angle) noexcept {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * x - s * y, s * x + c * y};
}

std::array<double, 4> product(const std::array<double, 4>& p,
                              const std::array<double, 4>& q) noexcept {
  return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
          p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
          p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
          p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]};
}

std::array<double, 4> exponential(const Point& o) noexcept {
  const double angle = std::sqrt(o[0] * o[0] + o[1] * o[1] + o[2] * o[2]);
  const double share = angle > 1e-12 ? std::sin(angle / 2.0) / angle : 0.5;
  return {std::cos(angle / 2.0), share * o[0], share * o[1], share * o[2]};
}

}  // namespace

PlannedMotion::PlannedMotion(const Trajectory& trajectory) noexcept
    : trajectory_(&trajectory),
      pivot_{trajectory.at(0, trajectory.root_column(0)),
             trajectory.at(0, trajectory.root_column(1))} {}

Point PlannedMotion::moved(const Point& p, double cycles) const noexcept {
  const Trajectory& t = *trajectory_;
  const double rise = p[2] + cycles * t.travel[2];
  // About the pivot: n steps of p ↦ R p + travel are Rⁿ p + (I + R + … + Rⁿ⁻¹) travel, whose sum is
  // sin(n·turn/2)/sin(turn/2) · R((n − 1)·turn/2).
  const double half = std::sin(t.turn / 2.0);
  const double sum = std::abs(half) > 1e-9 ? std::sin(cycles * t.turn / 2.0) / half
                                           : cycles * std::cos((cycles - 1.0) * t.turn / 2.0);
  const auto way = rotated(sum * t.travel[0], sum * t.travel[1], (cycles - 1.0) * t.turn / 2.0);
  const auto arm = rotated(p[0] - pivot_[0], p[1] - pivot_[1], cycles * t.turn);
  return {pivot_[0] + arm[0] + way[0], pivot_[1] + arm[1] + way[1], rise};
}

MovingPoint PlannedMotion::point(const SplinePhase& phase, int column) const noexcept {
  const Trajectory& t = *trajectory_;
  MovingPoint out;
  if (t.turn == 0.0) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const SplinePoint one =
          spline_point(t, phase, column + static_cast<int>(axis), t.travel[axis]);
      out.value[axis] = one.value;
      out.rate[axis] = one.rate;
      out.acceleration[axis] = one.acceleration;
    }
    return out;
  }
  for (std::size_t k = 0; k < 4; ++k) {
    const int knot = phase.knot[k];
    const Point control =
        moved({t.at(knot, column), t.at(knot, column + 1), t.at(knot, column + 2)}, phase.wrap[k]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      out.value[axis] += phase.value[k] * control[axis];
      out.rate[axis] += phase.rate[k] * control[axis];
      out.acceleration[axis] += phase.acceleration[k] * control[axis];
    }
  }
  // The cycle's own points first, then all of them go on: no digits are lost far from the start.
  const auto turn = [&](Point& direction) {
    const auto ground = rotated(direction[0], direction[1], phase.cycle * t.turn);
    direction = {ground[0], ground[1], direction[2]};
  };
  out.value = moved(out.value, phase.cycle);
  turn(out.rate);
  turn(out.acceleration);
  return out;
}

Pose PlannedMotion::root(const SplinePhase& phase) const noexcept {
  const Trajectory& t = *trajectory_;
  Point rotation{};
  for (std::size_t k = 0; k < 4; ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      const double drift = axis == 2 ? t.turn * phase.wrap[k] : 0.0;
      rotation[static_cast<std::size_t>(axis)] +=
          phase.value[k] * (t.at(phase.knot[k], t.root_column(3 + axis)) + drift);
    }
  }
  const double half = phase.cycle * t.turn / 2.0;
  return {point(phase, t.root_column(0)).value,
          product({std::cos(half), 0.0, 0.0, std::sin(half)}, exponential(rotation))};
}

Point PlannedMotion::com(const SplinePhase& phase) const noexcept {
  return point(phase, trajectory_->com_column(0)).value;
}

Point PlannedMotion::foot(const SplinePhase& phase, int foot) const noexcept {
  return point(phase, trajectory_->foot_column(foot, 0)).value;
}

Point PlannedMotion::force(const SplinePhase& phase, int foot) const noexcept {
  const Trajectory& t = *trajectory_;
  Point force{};
  const std::array<double, 2> weight = {1.0 - phase.fraction, phase.fraction};
  for (std::size_t k = 0; k < 2; ++k) {
    const int knot = phase.knot[k + 1];
    const auto ground =
        rotated(t.at(knot, t.force_column(foot, 0)), t.at(knot, t.force_column(foot, 1)),
                t.turn * (phase.cycle + phase.wrap[k + 1]));
    force[0] += weight[k] * ground[0];
    force[1] += weight[k] * ground[1];
    force[2] += weight[k] * t.at(knot, t.force_column(foot, 2));
  }
  return force;
}

bool PlannedMotion::contact(const SplinePhase& phase, int foot) const noexcept {
  const int nearest = phase.fraction < 0.5 ? phase.knot[1] : phase.knot[2];
  return trajectory_->at(nearest, trajectory_->contact_column(foot)) != 0.0;
}

}  // namespace legwright
