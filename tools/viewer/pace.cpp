// SPDX-License-Identifier: Apache-2.0
#include "tools/viewer/pace.hpp"

#include <chrono>
#include <cmath>

namespace legwright {
namespace {

constexpr double kLostTrack = 0.1;   // as much apart and the two clocks are set equal again [s]
constexpr double kFrameShare = 0.7;  // of a frame for physics

double seconds(mujoco::Simulate::Clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace

void Pace::advance(mujoco::Simulate& viewer, const mjModel& model, mjData& data) {
  if (!viewer.run) {
    mj_forward(&model, &data);  // what the sliders moved
    viewer.speed_changed = true;
    return;
  }
  const auto begin = Clock::now();
  const double slowness = 100.0 / mujoco::Simulate::percentRealTime[viewer.real_time_index];
  const double due = seconds(begin - wall_start_) / slowness;
  const double done = data.time - simulated_start_;
  if (viewer.speed_changed || done < 0.0 || std::abs(due - done) > kLostTrack) {
    wall_start_ = begin;
    simulated_start_ = data.time;
    viewer.speed_changed = false;
    viewer.InjectNoise(viewer.key);
    mj_step(&model, &data);
    viewer.AddToHistory();
    return;
  }
  if (done > 0.0) viewer.measured_slowdown = static_cast<float>(due * slowness / done);
  const double budget = kFrameShare / viewer.refresh_rate;
  bool stepped = false;
  for (auto now = begin; seconds(now - begin) < budget; now = Clock::now()) {
    if ((data.time - simulated_start_) * slowness >= seconds(now - wall_start_)) break;
    const double before = data.time;
    viewer.InjectNoise(viewer.key);
    mj_step(&model, &data);
    stepped = true;
    if (data.time < before) break;  // MuJoCo reset it
  }
  if (stepped) viewer.AddToHistory();
}

}  // namespace legwright
