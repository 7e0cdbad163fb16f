// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/rollout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace legwright {
namespace {

constexpr long long kStepsBetweenStops = 100;

// With all that is fixed to it. Feet may sit on it; they are there to touch the ground.
bool trunk_touches_world(const Scene& scene, const mjData& data) {
  const mjModel& model = *scene.model;
  const auto is_trunk = [&](int geom) {
    return model.body_weldid[model.geom_bodyid[geom]] == scene.joints.root_body &&
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

}  // namespace

double trunk_com_height(const mjModel& model, const mjData& data, int root_body) {
  double mass = 0.0, moment = 0.0;
  for (int body = root_body; body < static_cast<int>(model.nbody); ++body) {
    if (model.body_weldid[body] != root_body) continue;
    mass += model.body_mass[body];
    moment += model.body_mass[body] * data.xipos[3 * body + 2];
  }
  return mass > 0.0 ? moment / mass : data.xipos[3 * root_body + 2];
}

std::optional<Fall> find_fall(const Scene& scene, const mjData& data, double time,
                              double start_height, const FallLimits& limits) {
  const int body = scene.joints.root_body;
  if (trunk_touches_world(scene, data)) return Fall{time, "the trunk touches the ground"};
  const double up = std::clamp(data.xmat[9 * body + 8], -1.0, 1.0);
  if (std::acos(up) > limits.tilt)
    return Fall{time, fmt::format("tilted by more than {} rad", limits.tilt)};
  if (trunk_com_height(*scene.model, data, body) < limits.height_share * start_height) {
    return Fall{time, fmt::format("the trunk sank below {:.0f} % of its height",
                                  100 * limits.height_share)};
  }
  return std::nullopt;
}

ResumableRollout::ResumableRollout(const Scene& scene, RolloutOptions options)
    : scene_(scene), options_(std::move(options)), data_(make_data(*scene.model)) {
  mj_resetDataKeyframe(scene.model.get(), data_.get(), scene.start_key);
  if (options_.prepare) options_.prepare(*data_);
}

// @return whether to go on
bool ResumableRollout::play_step(const std::function<void(const RolloutSample&)>& observe) {
  const mjModel& model = *scene_.model;
  mjData& data = *data_;
  const double time = static_cast<double>(next_) * model.opt.timestep;  // no rounding adds up
  if (next_frame_ <= time + 1e-9 && time <= options_.frame_until + 1e-9 &&
      options_.frame_until > 0) {
    out_.frames.push_back({time, {data.qpos, data.qpos + model.nq}});
    next_frame_ = static_cast<double>(out_.frames.size()) * options_.frame_interval;
  }
  // One step beyond the end, whose only use is what it derives from the last state.
  if (options_.step)
    options_.step(data, time);
  else
    mj_step(&model, &data);
  health_.look(data, time);
  out_.seconds = time;
  out_.diverged = Health::diverged(data);
  if (out_.diverged) return false;
  if (observe) observe({model, data, time});
  if (next_ == 0) start_height_ = trunk_com_height(model, data, scene_.joints.root_body);
  out_.fall = find_fall(scene_, data, time, start_height_, options_.fall);
  return !out_.fall;
}

const Rollout& ResumableRollout::play_to(int cycles,
                                         const std::function<void(const RolloutSample&)>& observe) {
  const MujocoMessages messages;
  const auto last = std::llround(cycles * scene_.trajectory.period / scene_.model->opt.timestep);
  for (; !out_.fall && !out_.diverged && next_ <= last; ++next_) {
    if (options_.stop && next_ % kStepsBetweenStops == 0 && options_.stop()) throw RolloutStopped();
    if (!play_step(observe)) break;
  }
  out_.warnings = health_.warnings(*data_);
  return out_;
}

Rollout rollout(const Scene& scene, const RolloutOptions& options,
                const std::function<void(const RolloutSample&)>& observe) {
  return ResumableRollout(scene, options).play_to(options.cycles, observe);
}

}  // namespace legwright
