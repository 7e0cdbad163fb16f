// SPDX-License-Identifier: Apache-2.0
#include "tools/choose/physics_trial.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "optimizer/base/parallel.hpp"
#include "tools/simulate/scene.hpp"
#include "tools/validate/limits.hpp"
#include "tools/validate/measure.hpp"
#include "tools/validate/numerics.hpp"
#include "tools/validate/verdict.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

constexpr std::array<double, kTrialRollouts - 1> kTrialGains = {0.5, 1.0, 2.0};
constexpr const char* kAskedNumerics = "pyramidal";
// What fails within the first cycles need not be played to the end.
constexpr int kFirstCycles = 6, kTrialCycles = 20;
// What adds to the distance from passing: a limit that is missed, or not measured; a fall.
constexpr double kMissedLimit = 0.5, kUnknownDistance = 5.0, kFallDistance = 10.0;
// What counts as one unit of a residual: the verdict's own tolerances, and less than them where
// every bit of tilt or saturation should go.
constexpr double kRatioUnit = 0.05, kTiltUnit = 0.3, kSaturationUnit = 0.01, kFallUnit = 0.05;

/// What physics says at one gain, in tolerances. A robot that fell early has no speed: then the
/// share of the time that is missing pulls it up.
void add_residuals(const Measurements& run, const WantedMotion& wanted, double planned_seconds,
                   std::vector<double>& residual) {
  residual.push_back((1.0 - run.seconds / planned_seconds) / kFallUnit);
  if (wanted.travels())
    residual.push_back((run.speed_ratio.value_or(0.0) - 1.0) / kRatioUnit);
  else
    residual.push_back(run.velocity
                           ? run.velocity->norm() / *default_limits().at("standing_speed").high
                           : 1.0 / kRatioUnit);
  if (wanted.turns()) residual.push_back((run.turn_ratio.value_or(0.0) - 1.0) / kRatioUnit);
  residual.push_back(run.tilt_max / kTiltUnit);
  residual.push_back(run.saturated_share / kSaturationUnit);
}

/// What a limit that is not kept adds to the distance.
double distance_of(const JudgedLimit& limit) {
  if (limit.pass) return 0.0;
  if (!limit.value) return kUnknownDistance;
  double size =
      std::max(std::abs(limit.bounds.high.value_or(0.0)), std::abs(limit.bounds.low.value_or(0.0)));
  if (limit.bounds.low && limit.bounds.high) size = 0.5 * (*limit.bounds.high - *limit.bounds.low);
  double excess = 0.0;
  if (limit.bounds.high) excess = std::max(excess, *limit.value - *limit.bounds.high);
  if (limit.bounds.low) excess = std::max(excess, *limit.bounds.low - *limit.value);
  return kMissedLimit + (size > 0.0 ? std::log1p(excess / size) : excess > 0.0);
}

/// Of one roll-out from passing by itself.
double distance_of(const Measurements& run, const WantedMotion& wanted, const Limits& limits,
                   double planned_seconds) {
  if (run.fall || run.diverged)
    return kUnknownDistance + kFallDistance * (1.0 - run.seconds / planned_seconds);
  double sum = 0.0;
  for (const JudgedLimit& limit : judge_limits({run}, wanted, limits)) sum += distance_of(limit);
  return sum;
}

/// The middle between the least and the most of what is known.
double middle(const std::vector<double>& values, double unknown) {
  if (values.empty()) return unknown;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return 0.5 * (*least + *most);
}

std::vector<Scene> scenes_at_gains(const RobotModel& robot, const DesignTexts& texts) {
  std::vector<Scene> scenes;
  for (const double gain : kTrialGains)
    scenes.push_back(parse_scene(texts.scene_xml, "scene.xml", gain, robot.files.folder()));
  return scenes;
}

GaitTrial play_cycles(const std::vector<Scene>& scenes, const TaskFile& wanted,
                      const DesignTexts& texts, int cycles, int threads) {
  const WantedMotion motion{wanted.velocity, wanted.turn_rate};
  std::vector<Measurements> at_gains(scenes.size());
  parallel_for(static_cast<int>(scenes.size()), threads, [&](int k) {
    const auto i = static_cast<std::size_t>(k);
    RolloutOptions options;
    options.cycles = cycles;
    at_gains[i] = measure(scenes[i], motion, texts.quality.planned_velocity, options);
  });
  const Limits limits = with_step_over(default_limits(), wanted.margins.step_over);
  GaitTrial trial;
  std::vector<double> residual, speed_ratios, drifts;
  const double planned_seconds = cycles * scenes.front().trajectory.period;
  for (const Measurements& run : at_gains) {
    add_residuals(run, motion, planned_seconds, residual);
    trial.distance += distance_of(run, motion, limits, planned_seconds);
    if (run.fall || run.diverged) continue;
    if (run.speed_ratio) speed_ratios.push_back(*run.speed_ratio);
    if (run.cycles > 0) drifts.push_back(run.heading_drift / run.cycles);
  }
  const Verdict verdict = judge(at_gains, motion, wanted.gait, limits);
  trial.residual =
      Eigen::Map<const VectorXd>(residual.data(), static_cast<Eigen::Index>(residual.size()));
  trial.pass = verdict.pass;
  trial.line = verdict.line;
  trial.speed_ratio = middle(speed_ratios, 1.0);
  trial.heading_drift = middle(drifts, 0.0);
  return trial;
}

/// The same cycles once more at the highest gains with a pyramidal cone: of all numerics that
/// `validate` asks the one that fails most often (docs/findings/physics_in_the_search.md). A gait
/// that fails it alone is nearer to passing than any that misses a limit at its gains.
void ask_other_numerics(const std::vector<Scene>& scenes, const TaskFile& wanted,
                        const DesignTexts& texts, GaitTrial& trial) {
  const Scene& scene = scenes.back();
  for (const NumericalSetting& setting : other_numerics(scene.model->opt.timestep)) {
    if (setting.name != kAskedNumerics) continue;
    apply(setting, scene.model->opt);
    const WantedMotion motion{wanted.velocity, wanted.turn_rate};
    RolloutOptions options;
    options.cycles = kTrialCycles;
    const Measurements run = measure(scene, motion, texts.quality.planned_velocity, options);
    const Limits limits = with_step_over(default_limits(), wanted.margins.step_over);
    const Verdict verdict = judge({run}, motion, wanted.gait, limits);
    if (verdict.pass) continue;
    trial.pass = false;
    const double far = distance_of(run, motion, limits, kTrialCycles * scene.trajectory.period);
    trial.distance = kMissedLimit * far / (1.0 + far);
    trial.line = verdict.line + ", " + setting.words;
  }
}

}  // namespace

GaitTrial try_in_physics(const RobotModel& robot, const TaskFile& wanted, const DesignTexts& texts,
                         int threads, bool to_the_end) {
  const std::vector<Scene> scenes = scenes_at_gains(robot, texts);
  if (!to_the_end) {
    GaitTrial trial = play_cycles(scenes, wanted, texts, kFirstCycles, threads);
    if (!trial.pass) return trial;
  }
  GaitTrial trial = play_cycles(scenes, wanted, texts, kTrialCycles, threads);
  if (trial.pass) ask_other_numerics(scenes, wanted, texts, trial);
  return trial;
}

}  // namespace legwright
