// SPDX-License-Identifier: Apache-2.0
#include "plugin/spline.hpp"

#include <algorithm>
#include <cmath>

namespace legwright {

SplinePhase phase_at(const Trajectory& t, double time) noexcept {
  if (!std::isfinite(time)) time = 0.0;
  // fmod is exact, so the same phase gives the same bits in each cycle that hits it exactly.
  double within = std::fmod(time, t.period);
  if (within < 0.0) within += t.period;
  if (within >= t.period) within = 0.0;  // −1e-300 + period rounds to period

  SplinePhase phase;
  phase.cycle = std::round((time - within) / t.period);
  const double position = within * t.knot_count / t.period;  // in knots
  const int knot = std::min(static_cast<int>(position), t.knot_count - 1);
  for (int k = 0; k < 4; ++k) {
    const int unwrapped = knot - 1 + k;
    const int wrap = unwrapped < 0 ? -1 : unwrapped >= t.knot_count ? 1 : 0;
    const auto slot = static_cast<std::size_t>(k);
    phase.wrap[slot] = wrap;
    phase.knot[slot] = unwrapped - wrap * t.knot_count;
  }

  const double u = position - knot, v = 1.0 - u;
  const double per_step = t.knot_count / t.period;  // 1/h
  const double per_step_squared = per_step * per_step;
  phase.fraction = u;
  phase.value = {v * v * v / 6.0, (u * u * (3.0 * u - 6.0) + 4.0) / 6.0,
                 (v * v * (3.0 * v - 6.0) + 4.0) / 6.0, u * u * u / 6.0};
  phase.rate = {-v * v / 2.0 * per_step, u * (3.0 * u - 4.0) / 2.0 * per_step,
                -v * (3.0 * v - 4.0) / 2.0 * per_step, u * u / 2.0 * per_step};
  phase.acceleration = {v * per_step_squared, (3.0 * u - 2.0) * per_step_squared,
                        (3.0 * v - 2.0) * per_step_squared, u * per_step_squared};
  return phase;
}

SplinePoint spline_point(const Trajectory& t, const SplinePhase& phase, int column,
                         double drift) noexcept {
  SplinePoint point;
  for (std::size_t k = 0; k < 4; ++k) {
    // Beyond the end of the table the control points go on as the next cycle's. A cubic B-spline
    // reproduces straight lines, so this is the line of drift plus the spline of the periodic rest.
    const double control = t.at(phase.knot[k], column) + drift * phase.wrap[k];
    point.value += phase.value[k] * control;
    point.rate += phase.rate[k] * control;
    point.acceleration += phase.acceleration[k] * control;
  }
  point.value += drift * phase.cycle;
  return point;
}

double linear_value(const Trajectory& t, const SplinePhase& phase, int column) noexcept {
  return (1.0 - phase.fraction) * t.at(phase.knot[1], column) +
         phase.fraction * t.at(phase.knot[2], column);
}

namespace {

void sample_joints(const Trajectory& t, const SplinePhase& phase, TrajectorySample& out) {
  const auto joints = static_cast<std::size_t>(t.joint_count());
  for (std::vector<double>* const list :
       {&out.target, &out.velocity, &out.acceleration, &out.torque}) {
    list->resize(joints);
  }
  for (std::size_t joint = 0; joint < joints; ++joint) {
    const int number = static_cast<int>(joint);
    const SplinePoint point = spline_point(t, phase, t.target_column(number));
    out.target[joint] = point.value;
    out.velocity[joint] = point.rate;
    out.acceleration[joint] = point.acceleration;
    out.torque[joint] = linear_value(t, phase, t.torque_column(number));
  }
}

void sample_feet(const Trajectory& t, const SplinePhase& phase, TrajectorySample& out) {
  const auto feet = static_cast<std::size_t>(t.foot_count());
  out.foot.resize(feet);
  out.foot_velocity.resize(feet);
  out.force.resize(feet);
  out.contact.resize(feet);
  const int nearest = phase.fraction < 0.5 ? phase.knot[1] : phase.knot[2];
  for (std::size_t foot = 0; foot < feet; ++foot) {
    const int number = static_cast<int>(foot);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int column = t.foot_column(number, static_cast<int>(axis));
      const SplinePoint point = spline_point(t, phase, column, t.travel[axis]);
      out.foot[foot][axis] = point.value;
      out.foot_velocity[foot][axis] = point.rate;
      const int force_column = t.force_column(number, static_cast<int>(axis));
      out.force[foot][axis] = linear_value(t, phase, force_column);
    }
    out.contact[foot] = t.at(nearest, t.contact_column(number)) != 0.0;
  }
}

}  // namespace

void sample(const Trajectory& t, double time, TrajectorySample& out) {
  const SplinePhase phase = phase_at(t, time);
  sample_joints(t, phase, out);
  const std::array<double, 6> root_drift = {t.travel[0], t.travel[1], t.travel[2],
                                            0.0,         0.0,         t.turn};
  for (std::size_t axis = 0; axis < 6; ++axis) {
    const int column = t.root_column(static_cast<int>(axis));
    const SplinePoint point = spline_point(t, phase, column, root_drift[axis]);
    out.root[axis] = point.value;
    out.root_rate[axis] = point.rate;
    out.root_acceleration[axis] = point.acceleration;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int column = t.com_column(static_cast<int>(axis));
    const SplinePoint point = spline_point(t, phase, column, t.travel[axis]);
    out.com[axis] = point.value;
    out.com_velocity[axis] = point.rate;
    out.com_acceleration[axis] = point.acceleration;
  }
  sample_feet(t, phase, out);
}

}  // namespace legwright
