// SPDX-License-Identifier: Apache-2.0
#include "tools/choose/physics_trial.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "optimizer/base/parallel.hpp"
#include "optimizer/motion/faced_frame.hpp"
#include "tools/validate/floquet.hpp"
#include "tools/validate/limits.hpp"
#include "tools/validate/measure.hpp"
#include "tools/validate/numerics.hpp"
#include "tools/validate/verdict.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

/// A gain and what MuJoCo computes with there (other_numerics).
struct AskedNumerics {
  double gain_scale = 1.0;
  const char* name = nullptr;
};
constexpr std::array<AskedNumerics, 3> kAskedNumerics = {
    {{2.0, "half_step"}, {2.0, "pyramidal"}, {1.0, "pyramidal"}}};
// And of a gait that wanders, whose feet slip on the way to their places: the one in which they
// slip otherwise where legs are softest. To wander is to take up so much of what may be strayed.
constexpr AskedNumerics kAskedOfWanderers = {0.5, "pyramidal"};
constexpr double kWanders = 1.0 / 3.0;
// What fails within the first cycles need not be played to the end.
constexpr int kFirstCycles = 6, kTrialCycles = 20;
// A glance says what twenty cycles at three gains say of 117 of 122 designs beside a result (so do
// six cycles): of these all that fail do so at double or half gains.
constexpr int kGlanceCycles = 4;
constexpr std::array<double, 2> kGlanceGains = {2.0, 0.5};
// What adds to the distance from passing besides: a limit that is not measured; a fall.
constexpr double kUnknownDistance = 5.0, kFallDistance = 10.0;
// What counts as one unit of a residual: the verdict's own tolerances, and less than them where
// every bit of tilt or saturation should go.
constexpr double kRatioUnit = 0.05, kTiltUnit = 0.3, kSaturationUnit = 0.01, kFallUnit = 0.05;

WantedMotion motion_of(const TaskFile& wanted) {
  return {from_facing(wanted.velocity, wanted.forward), wanted.turn_rate, wanted.forward};
}

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

/// Whether the trunk turns or strays, at any gain, by a good part of what passes.
bool wanders(const std::vector<Measurements>& runs, const WantedMotion& wanted,
             const Limits& limits) {
  const std::vector<JudgedLimit> judged = judge_limits(runs, wanted, limits);
  return std::any_of(judged.begin(), judged.end(), [](const JudgedLimit& limit) {
    const bool is_way = limit.name == "heading_drift_per_cycle" || limit.name == "path_deviation";
    return is_way && limit.value.value_or(0.0) > kWanders * limit.bounds.high.value();
  });
}

/// The middle between the least and the most of what is known.
double middle(const std::vector<double>& values, double unknown) {
  if (values.empty()) return unknown;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return 0.5 * (*least + *most);
}

NumericalSetting setting_called(const std::string& name, double timestep) {
  for (NumericalSetting& setting : other_numerics(timestep))
    if (setting.name == name) return setting;
  throw std::logic_error("no numerics called " + name);
}

/// "falls after 1.1 s at half gains (and 2 more)"; empty where it passes.
std::string brief_words(const Verdict& verdict) {
  if (verdict.reasons.empty()) return "";
  const std::size_t more = verdict.reasons.size() - 1;
  return verdict.reasons.front() + (more > 0 ? " (and " + std::to_string(more) + " more)" : "");
}

/// What the next aim makes up for: the middle of what these roll-outs lose.
void tell_aim(const std::vector<Measurements>& runs, GaitTrial& trial) {
  std::vector<double> speed_ratios, drifts;
  for (const Measurements& run : runs) {
    if (run.fall || run.diverged) continue;
    if (run.speed_ratio) speed_ratios.push_back(*run.speed_ratio);
    if (run.cycles > 0) drifts.push_back(run.heading_drift / run.cycles);
  }
  trial.speed_ratio = middle(speed_ratios, 1.0);
  trial.heading_drift = middle(drifts, 0.0);
}

/// What roll-outs of a gait say together.
GaitTrial trial_of(const std::vector<Measurements>& runs, const TaskFile& wanted,
                   double planned_seconds) {
  const WantedMotion motion = motion_of(wanted);
  const Limits limits = with_step_over(default_limits(), wanted.margins.step_over);
  GaitTrial trial;
  trial.rollouts = static_cast<int>(runs.size());
  std::vector<double> residual;
  for (const Measurements& run : runs) {
    add_residuals(run, motion, planned_seconds, residual);
    trial.at_gains.push_back(distance_of(run, motion, limits, planned_seconds));
    trial.distance += trial.at_gains.back();
  }
  tell_aim(runs, trial);
  const Verdict verdict = judge(runs, motion, wanted.gait, limits);
  trial.residual =
      Eigen::Map<const VectorXd>(residual.data(), static_cast<Eigen::Index>(residual.size()));
  trial.pass = verdict.pass;
  trial.line = verdict.line;
  trial.brief = brief_words(verdict);
  return trial;
}

}  // namespace

GaitOnTrial::GaitOnTrial(const RobotModel& robot, const TaskFile& wanted, DesignTexts texts,
                         std::function<bool()> stop)
    : folder_(robot.files.folder()),
      wanted_(wanted),
      texts_(std::move(texts)),
      stop_(std::move(stop)) {}

Scene GaitOnTrial::scene(double gain) const {
  return parse_scene(texts_.scene_xml, "scene.xml", gain, folder_);
}

Measurements GaitOnTrial::play(const Scene& scene, int cycles) const {
  RolloutOptions options;
  options.cycles = cycles;
  options.stop = stop_;
  return measure(scene, motion_of(wanted_), texts_.quality.planned_velocity, options);
}

// @return whether it had not begun yet
bool GaitOnTrial::begin(std::size_t gain) {
  if (played_[gain]) return false;
  scenes_[gain] = std::make_unique<const Scene>(scene(kTrialGains[gain]));
  RolloutOptions options;
  options.stop = stop_;
  played_[gain] = std::make_unique<GaitMeasurement>(*scenes_[gain], motion_of(wanted_),
                                                    texts_.quality.planned_velocity, options);
  return true;
}

GaitTrial GaitOnTrial::play(PlayedCycles cycles, int threads) {
  int begun = 0;
  for (std::size_t i = 0; i < kTrialGains.size(); ++i) begun += begin(i);
  const int count = cycles == PlayedCycles::first ? kFirstCycles : kTrialCycles;
  std::vector<Measurements> at_gains(kTrialGains.size());
  parallel_for(static_cast<int>(kTrialGains.size()), threads, [&](int k) {
    const auto i = static_cast<std::size_t>(k);
    at_gains[i] = played_[i]->play_to(count);
  });
  GaitTrial trial = trial_of(at_gains, wanted_, count * scenes_.front()->trajectory.period);
  trial.rollouts = begun;
  return trial;
}

FirstCycles GaitOnTrial::play_first(std::size_t gain, bool goes_on) {
  begin(gain);
  FirstCycles out;
  out.measured = played_[gain]->play_to(kFirstCycles);
  out.planned_seconds = kFirstCycles * scenes_[gain]->trajectory.period;
  out.distance =
      distance_of(out.measured, motion_of(wanted_),
                  with_step_over(default_limits(), wanted_.margins.step_over), out.planned_seconds);
  if (!goes_on || out.distance > 0.0) {
    played_[gain].reset();
    scenes_[gain].reset();
  }
  return out;
}

GaitTrial GaitOnTrial::trial_of_first(const std::vector<FirstCycles>& runs) const {
  std::vector<Measurements> measured;
  measured.reserve(runs.size());
  for (const FirstCycles& run : runs) measured.push_back(run.measured);
  return trial_of(measured, wanted_, runs.front().planned_seconds);
}

void GaitOnTrial::ask_other_numerics(int threads, GaitTrial& trial) const {
  const WantedMotion motion = motion_of(wanted_);
  const Limits limits = with_step_over(default_limits(), wanted_.margins.step_over);
  std::vector<Measurements> runs;  // those that passed first
  for (const auto& each : played_) runs.push_back(each->play_to(kTrialCycles));
  std::vector<AskedNumerics> asked(kAskedNumerics.begin(), kAskedNumerics.end());
  if (wanders(runs, motion, limits)) asked.push_back(kAskedOfWanderers);
  const std::size_t before = runs.size();
  runs.resize(before + asked.size());
  std::vector<double> far(asked.size());
  std::vector<std::string> lines(asked.size()), briefs(asked.size());
  parallel_for(static_cast<int>(asked.size()), threads, [&](int k) {
    const auto i = static_cast<std::size_t>(k);
    const Scene scene = this->scene(asked[i].gain_scale);
    const NumericalSetting setting = setting_called(asked[i].name, scene.model->opt.timestep);
    apply(setting, scene.model->opt);
    const Measurements& run = runs[before + i] = play(scene, kTrialCycles);
    const Verdict verdict = judge({run}, motion, wanted_.gait, limits);
    if (verdict.pass) return;
    far[i] = distance_of(run, motion, limits, kTrialCycles * scene.trajectory.period);
    lines[i] = verdict.line + ", " + setting.words;
    briefs[i] = brief_words(verdict) + ", " + setting.words;
  });
  double sum = 0.0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].empty()) continue;
    trial.line = trial.pass ? lines[i] : trial.line + "; " + lines[i];
    if (trial.brief.empty()) trial.brief = briefs[i];
    trial.pass = false;
    sum += far[i];
  }
  trial.distance += kMissedLimit * sum / (1.0 + sum);
  trial.rollouts += static_cast<int>(asked.size());
  tell_aim(runs, trial);
}

GaitTrial GaitOnTrial::glance() const {
  std::vector<Measurements> runs;
  GaitTrial trial;
  for (const double gain : kGlanceGains) {
    const Scene scene = this->scene(gain);
    runs.push_back(play(scene, kGlanceCycles));
    trial = trial_of(runs, wanted_, kGlanceCycles * scene.trajectory.period);
    if (!trial.pass) break;
  }
  return trial;
}

double GaitOnTrial::largest_multiplier(int threads) const {
  FloquetOptions options;
  options.threads = threads;
  options.stop = stop_;
  double largest = 0.0;
  for (const double gain : kTrialGains) {
    largest = std::max(largest, floquet_multiplier(this->scene(gain), options)
                                    .value_or(std::numeric_limits<double>::infinity()));
  }
  return largest;
}

GaitTrial try_in_physics(const RobotModel& robot, const TaskFile& wanted,
                         const DesignTexts& texts) {
  GaitOnTrial gait(robot, wanted, texts);
  GaitTrial first = gait.play(PlayedCycles::first);
  if (!first.pass) return first;
  GaitTrial trial = gait.play(PlayedCycles::all);
  trial.rollouts += first.rollouts;
  if (trial.pass) gait.ask_other_numerics(1, trial);
  return trial;
}

}  // namespace legwright
