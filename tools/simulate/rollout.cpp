// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/rollout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace legwright {
namespace {

// Feet may sit on the trunk itself; they are there to touch the ground.
bool trunk_touches_world(const Scene& scene, const mjData& data) {
  const mjModel& model = *scene.model;
  const auto is_trunk = [&](int geom) {
    return model.geom_bodyid[geom] == scene.joints.root_body &&
           std::find(scene.foot_geom.begin(), scene.foot_geom.end(), geom) == scene.foot_geom.end();
  };
  for (int c = 0; c < data.ncon; ++c) {
    const int a = data.contact[c].geom[0], b = data.contact[c].geom[1];
    if (a < 0 || b < 0 || data.contact[c].dist > 0) continue;
    if ((model.geom_bodyid[a] == 0 && is_trunk(b)) || (model.geom_bodyid[b] == 0 && is_trunk(a)))
      return true;
  }
  return false;
}

std::optional<Fall> find_fall(const Scene& scene, const mjData& data, double time,
                              double start_height, const FallLimits& limits) {
  const int body = scene.joints.root_body;
  if (trunk_touches_world(scene, data)) return Fall{time, "the trunk touches the ground"};
  const double up = std::clamp(data.xmat[9 * body + 8], -1.0, 1.0);
  if (std::acos(up) > limits.tilt)
    return Fall{time, fmt::format("tilted by more than {} rad", limits.tilt)};
  if (data.xpos[3 * body + 2] < limits.height_share * start_height) {
    return Fall{time, fmt::format("the trunk sank below {:.0f} % of its height",
                                  100 * limits.height_share)};
  }
  return std::nullopt;
}

}  // namespace

Rollout rollout(const Scene& scene, const RolloutOptions& options,
                const std::function<void(const RolloutSample&)>& observe) {
  const MujocoMessages messages;
  const mjModel& model = *scene.model;
  const DataPointer data = make_data(model);
  mj_resetDataKeyframe(&model, data.get(), scene.start_key);
  if (options.prepare) options.prepare(*data);
  const auto steps = std::llround(options.cycles * scene.trajectory.period / model.opt.timestep);
  Rollout out;
  Health health;
  double start_height = 0.0, next_frame = 0.0;
  for (long long n = 0; n <= steps; ++n) {
    const double time = static_cast<double>(n) * model.opt.timestep;  // no rounding adds up
    if (next_frame <= time + 1e-9 && time <= options.frame_until + 1e-9 &&
        options.frame_until > 0) {
      out.frames.push_back({time, {data->qpos, data->qpos + model.nq}});
      next_frame = static_cast<double>(out.frames.size()) * options.frame_interval;
    }
    // One step beyond the end, whose only use is what it derives from the last state.
    if (options.step)
      options.step(*data, time);
    else
      mj_step(&model, data.get());
    health.look(*data, time);
    out.seconds = time;
    if (Health::diverged(*data)) {
      out.diverged = true;
      break;
    }
    if (observe) observe({model, *data, time});
    if (n == 0) start_height = data->xpos[3 * scene.joints.root_body + 2];
    out.fall = find_fall(scene, *data, time, start_height, options.fall);
    if (out.fall) break;
  }
  out.warnings = health.warnings(*data);
  return out;
}

}  // namespace legwright
