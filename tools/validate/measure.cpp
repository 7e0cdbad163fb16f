// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/measure.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "optimizer/motion/path.hpp"
#include "plugin/spline.hpp"
#include "tools/validate/foot_touch.hpp"
#include "tools/validate/path_deviation.hpp"
#include "tools/validate/saturation.hpp"

namespace legwright {

class GaitMeasurement::Measurer {
 public:
  Measurer(const Scene& scene, const MeasureOptions& options)
      : scene_(scene),
        model_(*scene.model),
        weight_(robot_weight(*scene.model, scene.joints)),
        start_(scene.t0 - std::floor(scene.t0 / scene.trajectory.period) * scene.trajectory.period),
        self_contact_(*scene.model),
        sums_(scene.joints.joint.size()) {
    for (int j = 0; j < scene.trajectory.foot_count(); ++j) {
      feet_.emplace_back(scene.trajectory, j, options.contacts_until, start_);
    }
  }

  void observe(const RolloutSample& sample) {
    watch_trunk(sample);
    watch_contacts(sample);
    self_contact_.observe(sample.time, sample.data);
    watch_joints(sample);
  }

  void finish(const Rollout& played, const WantedMotion& wanted,
              const Eigen::Vector2d& plan_velocity, const MeasureOptions& options,
              Measurements& out);

 private:
  struct Mark {  // the robot at the start of a cycle
    Eigen::Vector2d
        position;  // of its COM: where a robot turns, its trunk's origin goes round that
    double yaw;    // of the trunk, unwrapped [rad]
    double work;   // of the servos so far [J]
  };
  struct JointSums {
    double torque_squared = 0.0, peak = 0.0, error_squared = 0.0;
    long long saturated = 0;
    std::optional<double> saturated_time = {};  // the first [s]
  };
  void watch_trunk(const RolloutSample& sample);
  void watch_contacts(const RolloutSample& sample);
  void watch_joints(const RolloutSample& sample);
  void finish_speeds(const WantedMotion& wanted, const Eigen::Vector2d& plan_velocity,
                     const MeasureOptions& options, Measurements& out) const;
  void finish_path(const WantedMotion& wanted, Measurements& out) const;

  const Scene& scene_;
  const mjModel& model_;
  double weight_;
  double start_;  // in the cycle, of what is played [s]
  SelfContactWatch self_contact_;
  std::vector<Mark> marks_;
  double yaw_ = 0.0, tilt_max_ = 0.0, work_ = 0.0, penetration_ = 0.0;
  std::vector<FootWatch> feet_;
  std::vector<FootTouch> touch_;
  std::vector<JointSums> sums_;
  long long samples_ = 0, settled_ = 0, saturated_ = 0;
};

void GaitMeasurement::Measurer::watch_trunk(const RolloutSample& sample) {
  const mjtNum* rotation =
      sample.data.xmat + static_cast<std::ptrdiff_t>(9) * scene_.joints.root_body;
  const double yaw = std::atan2(rotation[3], rotation[0]);
  yaw_ = samples_ == 0 ? yaw : yaw_ + std::remainder(yaw - yaw_, 2 * std::numbers::pi);
  tilt_max_ = std::max(tilt_max_, std::acos(std::clamp(rotation[8], -1.0, 1.0)));
  const double due = static_cast<double>(marks_.size()) * scene_.trajectory.period;
  if (sample.time >= due - model_.opt.timestep / 2) {
    const mjtNum* position =
        sample.data.subtree_com + static_cast<std::ptrdiff_t>(3) * scene_.joints.root_body;
    marks_.push_back({{position[0], position[1]}, yaw_, work_});
  }
  ++samples_;
}

void GaitMeasurement::Measurer::watch_contacts(const RolloutSample& sample) {
  penetration_ = std::max(penetration_, read_foot_touches(scene_, sample.data, touch_));
  for (std::size_t j = 0; j < feet_.size(); ++j) {
    const FootMotion motion = foot_motion(model_, sample.data, scene_.foot_geom[j]);
    feet_[j].observe(sample.time + start_, model_.opt.timestep,
                     {.in_contact = touch_[j].normal > kStandingShare * weight_,
                      .slip_speed = touch_[j].slip_speed,
                      .sink_speed = -motion.bottom_velocity.z(),
                      .roll_rate = motion.roll_rate,
                      .sole = motion.bottom});
  }
}

void GaitMeasurement::Measurer::watch_joints(const RolloutSample& sample) {
  const bool settled = sample.time >= scene_.trajectory.period;
  const SplinePhase phase = phase_at(scene_.trajectory, sample.time + scene_.t0);
  bool any = false;
  for (std::size_t joint = 0; joint < scene_.joints.joint.size(); ++joint) {
    const int dof = scene_.joints.dof[joint];
    const double torque = sample.data.qfrc_actuator[dof];
    work_ += std::max(0.0, torque * sample.data.qvel[dof]) * model_.opt.timestep;
    if (!settled) continue;
    JointSums& sums = sums_[joint];
    const double target = spline_point(scene_.trajectory, phase,
                                       scene_.trajectory.target_column(static_cast<int>(joint)))
                              .value;
    const double error = target - sample.data.qpos[scene_.joints.qpos[joint]];
    const bool saturated = is_saturated(scene_, sample.data, joint);
    sums.torque_squared += torque * torque;
    sums.error_squared += error * error;
    sums.peak = std::max(sums.peak, std::abs(torque));
    sums.saturated += saturated;
    if (saturated && !sums.saturated_time) sums.saturated_time = sample.time;
    any = any || saturated;
  }
  settled_ += settled;
  saturated_ += any;
}

void GaitMeasurement::Measurer::finish_speeds(const WantedMotion& wanted,
                                              const Eigen::Vector2d& plan_velocity,
                                              const MeasureOptions& options,
                                              Measurements& out) const {
  const auto first = static_cast<std::size_t>(options.settle_cycles);
  if (marks_.size() < first + 2) return;
  const double period = scene_.trajectory.period;
  const auto count = static_cast<double>(marks_.size() - 1 - first);
  const Eigen::Vector2d direction = wanted.velocity.normalized();
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (std::size_t n = first; n + 1 < marks_.size(); ++n) {
    // Where its own nose points, not where the plan's world has +x: a puppy that cannot walk
    // sideways plans to turn by a quarter and walk ahead, which is not what was asked for. And
    // along the arc on which it went, not the chord, which is shorter.
    const Eigen::Rotation2Dd heading(marks_[n].yaw);
    const Eigen::Vector2d step = heading.inverse() * (marks_[n + 1].position - marks_[n].position);
    const Eigen::Vector2d velocity =
        WantedPath::velocity_along_arc(step, marks_[n + 1].yaw - marks_[n].yaw, period);
    sum += velocity;
    if (!wanted.travels()) continue;
    const double ratio = velocity.dot(direction) / wanted.velocity.norm();
    out.speed_ratio_min = std::min(out.speed_ratio_min.value_or(ratio), ratio);
    out.speed_ratio_max = std::max(out.speed_ratio_max.value_or(ratio), ratio);
  }
  const Eigen::Vector2d velocity = sum / count;
  out.velocity = velocity;
  out.turn_rate = (marks_.back().yaw - marks_[first].yaw) / (count * period);
  if (wanted.turns()) out.turn_ratio = *out.turn_rate / wanted.turn_rate;
  out.power_mean = (marks_.back().work - marks_[first].work) / (count * period);
  if (!wanted.travels()) return;
  out.speed_ratio = velocity.dot(direction) / wanted.velocity.norm();
  out.lateral_drift = direction.x() * velocity.y() - direction.y() * velocity.x();
  if (const double reached = plan_velocity.dot(direction); std::abs(reached) > 1e-6) {
    out.plan_speed_ratio = velocity.dot(direction) / reached;
  }
  if (const double speed = velocity.norm(); speed > 1e-6)
    out.cost_of_transport = *out.power_mean / (weight_ * speed);
}

// The path that is wanted sets off where the robot does, in the heading of the plan: what turns it
// in its first steps leads it astray as well.
void GaitMeasurement::Measurer::finish_path(const WantedMotion& wanted, Measurements& out) const {
  if (!wanted.travels() || marks_.size() < 2) return;
  std::vector<Eigen::Vector2d> way;
  for (const Mark& mark : marks_) way.push_back(mark.position);
  const double length = wanted.velocity.norm() * scene_.trajectory.period * out.cycles;
  out.path_deviation =
      distance_from_path(way, wanted.velocity, wanted.turn_rate, wanted.turn_rate * start_) /
      length;
}

void GaitMeasurement::Measurer::finish(const Rollout& played, const WantedMotion& wanted,
                                       const Eigen::Vector2d& plan_velocity,
                                       const MeasureOptions& options, Measurements& out) {
  out.cycles = std::max(0, static_cast<int>(marks_.size()) - 1);
  out.tilt_max = tilt_max_;
  out.penetration_max = penetration_;
  if (!marks_.empty()) {
    out.heading_at_start = marks_.front().yaw;
    out.heading_drift = yaw_ - marks_.front().yaw - wanted.turn_rate * played.seconds;
  }
  finish_speeds(wanted, plan_velocity, options, out);
  finish_path(wanted, out);
  for (auto& foot : feet_) out.feet.push_back(foot.finish(played.seconds + start_));
  const double count = static_cast<double>(std::max(1LL, settled_));
  double torque = 0.0, error = 0.0;
  for (std::size_t a = 0; a < sums_.size(); ++a) {
    const JointSums& sums = sums_[a];
    torque += sums.torque_squared / count;
    error += sums.error_squared / count;
    out.joints.push_back({scene_.trajectory.joint_names[a], std::sqrt(sums.torque_squared / count),
                          sums.peak, scene_.torque_limit[a],
                          static_cast<double>(sums.saturated) / count,
                          std::sqrt(sums.error_squared / count), sums.saturated_time});
  }
  const double joints = static_cast<double>(sums_.size());
  out.torque_rms = std::sqrt(torque / joints);
  out.tracking_rms = std::sqrt(error / joints);
  out.saturated_share = static_cast<double>(saturated_) / count;
  out.self_contact = self_contact_.finish();
}

struct GaitMeasurement::Parts {
  const Scene& scene;
  WantedMotion wanted;
  Eigen::Vector2d plan_velocity;
  MeasureOptions options;
  ResumableRollout rollout;
  Measurer measurer;
  Rollout played = {};
};

GaitMeasurement::GaitMeasurement(const Scene& scene, const WantedMotion& wanted,
                                 const Eigen::Vector2d& plan_velocity,
                                 const RolloutOptions& rollout_options,
                                 const MeasureOptions& options)
    : parts_(new Parts{scene, wanted, plan_velocity, options,
                       ResumableRollout(scene, rollout_options), Measurer(scene, options)}) {}

GaitMeasurement::~GaitMeasurement() = default;
GaitMeasurement::GaitMeasurement(GaitMeasurement&&) noexcept = default;

Measurements GaitMeasurement::play_to(int cycles,
                                      const std::function<void(const RolloutSample&)>& also) {
  Parts& parts = *parts_;
  parts.played = parts.rollout.play_to(cycles, [&](const RolloutSample& sample) {
    parts.measurer.observe(sample);
    if (also) also(sample);
  });
  Measurements out;
  out.gain_scale = parts.scene.gain_scale;
  out.seconds = parts.played.seconds;
  out.fall = parts.played.fall;
  out.warnings = parts.played.warnings;
  out.diverged = parts.played.diverged;
  Measurer so_far = parts.measurer;  // finishing ends stances that may go on
  so_far.finish(parts.played, parts.wanted, parts.plan_velocity, parts.options, out);
  return out;
}

const Rollout& GaitMeasurement::played() const { return parts_->played; }

Measurements measure(const Scene& scene, const WantedMotion& wanted,
                     const Eigen::Vector2d& plan_velocity, const RolloutOptions& rollout_options,
                     const MeasureOptions& options, Rollout* played,
                     const std::function<void(const RolloutSample&)>& also) {
  GaitMeasurement measurement(scene, wanted, plan_velocity, rollout_options, options);
  Measurements out = measurement.play_to(rollout_options.cycles, also);
  if (played != nullptr) *played = measurement.played();
  return out;
}

}  // namespace legwright
