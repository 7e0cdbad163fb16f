// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/numerics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "optimizer/base/parallel.hpp"

namespace legwright {
namespace {

std::string integrator_name(int integrator) {
  switch (integrator) {
    case mjINT_EULER:
      return "Euler";
    case mjINT_RK4:
      return "RK4";
    case mjINT_IMPLICIT:
      return "implicit";
    case mjINT_IMPLICITFAST:
      return "implicitfast";
    default:
      return fmt::format("integrator {}", integrator);
  }
}

std::string cone_name(int cone) { return cone == mjCONE_ELLIPTIC ? "elliptic" : "pyramidal"; }

struct NumericalRunJob {
  Scene scene;
  NumericalRun* run = nullptr;
};

void name_run(const NumericalSetting& setting, const mjOption& options, NumericalRun& run) {
  run.name = setting.name;
  run.words = setting.words;
  run.timestep = options.timestep;
  run.integrator = integrator_name(options.integrator);
  run.cone = cone_name(options.cone);
  run.label = fmt::format("{:g} ms, {}, {} cone", 1000 * run.timestep, run.integrator, run.cone);
}

void play(NumericalRunJob& job, const SceneToValidate& what, const WantedMotion& wanted,
          const ValidationOptions& options) {
  RolloutOptions rollout;
  rollout.cycles = options.cycles;
  job.run->measured = measure(job.scene, wanted, what.plan_velocity, rollout,
                              {.contacts_until = options.frames_until});
}

/// A number of a run; null where it could not be measured.
using Number = std::optional<double>;

Number difference(const Number& a, const Number& b) {
  return a && b ? Number(*a - *b) : std::nullopt;
}

}  // namespace

std::vector<NumericalSetting> other_numerics(double timestep) {
  return {{"half_step", fmt::format("at {:g} ms", 500 * timestep), timestep / 2, {}, {}, {}},
          {"implicit", "with implicit", {}, mjINT_IMPLICIT, {}, {}},
          {"pyramidal", "with a pyramidal cone", {}, {}, mjCONE_PYRAMIDAL, 1.0}};
}

void apply(const NumericalSetting& setting, mjOption& options) {
  options.timestep = setting.timestep.value_or(options.timestep);
  options.integrator = setting.integrator.value_or(options.integrator);
  options.cone = setting.cone.value_or(options.cone);
  options.impratio = setting.impratio.value_or(options.impratio);
}

SecondOpinion second_opinion(const SceneToValidate& scene, const WantedMotion& wanted,
                             const std::string& gait, const ValidationOptions& options,
                             const std::optional<Measurements>& reference,
                             std::vector<NumericalSetting> settings) {
  std::vector<NumericalRunJob> jobs(1);
  jobs[0].scene = load_scene(scene.scene, 1.0);
  if (settings.empty()) settings = other_numerics(jobs[0].scene.model->opt.timestep);
  settings.insert(settings.begin(), NumericalSetting{"reference", "", {}, {}, {}, {}});
  SecondOpinion out;
  out.runs.resize(settings.size());
  for (std::size_t k = 0; k < settings.size(); ++k) {
    if (k > 0) jobs.push_back({load_scene(scene.scene, 1.0), nullptr});
    jobs[k].run = &out.runs[k];
    apply(settings[k], jobs[k].scene.model->opt);
    name_run(settings[k], jobs[k].scene.model->opt, out.runs[k]);
  }
  if (reference) out.runs[0].measured = *reference;
  const int played = reference ? 1 : 0;
  parallel_for(static_cast<int>(jobs.size()) - played, options.threads, [&](int k) {
    play(jobs[static_cast<std::size_t>(k + played)], scene, wanted, options);
  });
  for (NumericalRun& run : out.runs) {
    run.verdict = judge({run.measured}, wanted, gait, options.limits);
    if (run.verdict.pass == out.runs.front().verdict.pass) continue;
    out.agree = false;
    out.reasons.push_back(fmt::format("{} ({}): {}; the reference: {}", run.words, run.label,
                                      run.verdict.line, out.runs.front().verdict.line));
  }
  return out;
}

std::string describe(const SecondOpinion& opinion) {
  const NumericsNumbers reference = numbers_of(opinion.runs.front().measured);
  std::string same, other;
  double speed = 0.0, turn = 0.0, tilt = 0.0;
  for (std::size_t k = 1; k < opinion.runs.size(); ++k) {
    const NumericalRun& run = opinion.runs[k];
    std::string& list = run.verdict.pass == opinion.runs.front().verdict.pass ? same : other;
    list += (list.empty() ? "" : ", ") + run.words;
    const NumericsNumbers change = numbers_of(run.measured) - reference;
    speed = std::max(speed, std::abs(change.speed_ratio.value_or(0.0)));
    turn = std::max(turn, std::abs(change.turn_ratio.value_or(0.0)));
    tilt = std::max(tilt, std::abs(change.tilt_max.value_or(0.0)));
  }
  std::string out = "numerics: ";
  if (!other.empty()) out += "ANOTHER verdict " + other + (same.empty() ? "" : "; ");
  if (!same.empty()) out += "same verdict " + same;
  out += " (";
  if (reference.speed_ratio) out += fmt::format("speed within {:.1f} %, ", 100 * speed);
  if (reference.turn_ratio) out += fmt::format("turn rate within {:.1f} %, ", 100 * turn);
  return out + fmt::format("tilt within {:.1f} mrad)", 1000 * tilt);
}

NumericsNumbers numbers_of(const Measurements& m) {
  return {m.speed_ratio, m.turn_ratio, m.tilt_max, m.heading_drift, m.torque_rms};
}

NumericsNumbers operator-(const NumericsNumbers& a, const NumericsNumbers& b) {
  return {difference(a.speed_ratio, b.speed_ratio), difference(a.turn_ratio, b.turn_ratio),
          difference(a.tilt_max, b.tilt_max), difference(a.heading_drift, b.heading_drift),
          difference(a.torque_rms, b.torque_rms)};
}

}  // namespace legwright
