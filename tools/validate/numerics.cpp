// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/numerics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "optimizer/base/parallel.hpp"
#include "tools/run/joined_by_and.hpp"

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
  std::size_t run = 0;
  double gain_scale = 1.0;
  NumericalSetting setting;
};

/// Default gains first: they are what the others are compared with by eye.
std::vector<double> default_first(std::vector<double> gains) {
  std::stable_partition(gains.begin(), gains.end(), [](double gain) { return gain == 1.0; });
  return gains;
}

const Measurements* at_gain(const std::vector<Measurements>& references, double gain) {
  for (const Measurements& run : references)
    if (run.gain_scale == gain) return &run;
  return nullptr;
}

void name_run(const NumericalSetting& setting, const mjOption& options, NumericalRun& run) {
  run.name = setting.name;
  run.words = setting.words;
  run.timestep = options.timestep;
  run.integrator = integrator_name(options.integrator);
  run.cone = cone_name(options.cone);
  run.label = fmt::format("{:g} ms, {}, {} cone", 1000 * run.timestep, run.integrator, run.cone);
}

void play(const NumericalRunJob& job, const SceneToValidate& what, const WantedMotion& wanted,
          const ValidationOptions& options, NumericalRun& run) {
  const Scene scene = load_scene(what.scene, job.gain_scale);
  apply(job.setting, scene.model->opt);
  name_run(job.setting, scene.model->opt, run);
  RolloutOptions rollout;
  rollout.cycles = options.cycles;
  run.measured =
      measure(scene, wanted, what.plan_velocity, rollout, {.contacts_until = options.frames_until});
}

/// The references of the gains: where the runs of each of them begin.
std::vector<std::size_t> blocks_of(const SecondOpinion& opinion) {
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < opinion.runs.size(); ++k)
    if (opinion.runs[k].name == "reference") out.push_back(k);
  return out;
}

/// How a run judges otherwise than the scene as it is.
std::string disagreement(const NumericalRun& run, const NumericalRun& reference) {
  const std::string& line = reference.verdict.line;
  return fmt::format("{} at {} gains ({}): {}; the reference: {}", run.words,
                     gain_name(run.gain_scale), run.label, run.verdict.line,
                     reference.verdict.pass ? "PASS" : line);
}

}  // namespace

std::vector<NumericalSetting> other_numerics(double timestep) {
  return {{"half_step", fmt::format("at {:g} ms", 500 * timestep), timestep / 2, {}, {}, {}},
          {"quarter_step", fmt::format("at {:g} ms", 250 * timestep), timestep / 4, {}, {}, {}},
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
                             const std::vector<Measurements>& references,
                             std::vector<NumericalSetting> settings) {
  const Scene as_it_is = load_scene(scene.scene, 1.0);
  if (settings.empty()) settings = other_numerics(as_it_is.model->opt.timestep);
  settings.insert(settings.begin(), NumericalSetting{"reference", "", {}, {}, {}, {}});
  SecondOpinion out;
  std::vector<NumericalRunJob> jobs;
  for (const double gain : default_first(options.gain_scales))
    for (const NumericalSetting& setting : settings) {
      NumericalRun& run = out.runs.emplace_back();
      run.gain_scale = gain;
      const Measurements* known = at_gain(references, gain);
      if (setting.name == "reference" && known != nullptr) {
        name_run(setting, as_it_is.model->opt, run);
        run.measured = *known;
      } else {
        jobs.push_back({out.runs.size() - 1, gain, setting});
      }
    }
  // The smallest steps take longest and come first, so that no thread is left with one at the end.
  std::stable_sort(jobs.begin(), jobs.end(), [](const auto& a, const auto& b) {
    return a.setting.timestep.value_or(1.0) < b.setting.timestep.value_or(1.0);
  });
  StageProgress progress(options.progress, "other numerics", static_cast<int>(jobs.size()));
  parallel_for(static_cast<int>(jobs.size()), options.threads, [&](int k) {
    const NumericalRunJob& job = jobs[static_cast<std::size_t>(k)];
    play(job, scene, wanted, options, out.runs[job.run]);
    progress.one_more();
  });
  const NumericalRun* reference = nullptr;
  for (NumericalRun& run : out.runs) {
    run.verdict = judge({run.measured}, wanted, gait, options.limits);
    if (run.name == "reference") reference = &run;
    if (run.verdict.pass == reference->verdict.pass) continue;
    out.agree = false;
    out.reasons.push_back(disagreement(run, *reference));
  }
  return out;
}

std::string describe(const SecondOpinion& opinion) {
  const std::vector<std::size_t> blocks = blocks_of(opinion);
  std::string settings, other;
  std::vector<std::string> gains;
  std::size_t others = 0, reference = 0;
  NumericsNumbers worst{0.0, 0.0, 0.0, {}, {}};
  for (std::size_t k = 0; k < opinion.runs.size(); ++k) {
    const NumericalRun& run = opinion.runs[k];
    if (run.name == "reference") {
      reference = k;
      gains.push_back(gain_name(run.gain_scale));
      continue;
    }
    if (reference == blocks.front()) settings += (settings.empty() ? "" : ", ") + run.words;
    if (run.verdict.pass != opinion.runs[reference].verdict.pass) {
      other += fmt::format("{}{} at {} gains", other.empty() ? "" : ", ", run.words,
                           gain_name(run.gain_scale));
      ++others;
    }
    const NumericsNumbers change =
        numbers_of(run.measured) - numbers_of(opinion.runs[reference].measured);
    const auto grow = [](std::optional<double>& most, const std::optional<double>& by) {
      most = std::max(*most, std::abs(by.value_or(0.0)));
    };
    grow(worst.speed_ratio, change.speed_ratio);
    grow(worst.turn_ratio, change.turn_ratio);
    grow(worst.tilt_max, change.tilt_max);
  }
  const std::size_t played = opinion.runs.size() - blocks.size();
  std::string out = "numerics: ";
  if (others == 0)
    out += fmt::format("same verdict {}, at {} gains", settings, joined_by_and(gains));
  else
    out +=
        fmt::format("ANOTHER verdict {}{}", other,
                    others < played ? fmt::format("; the same in {} others", played - others) : "");
  out += " (";
  const NumericsNumbers first = numbers_of(opinion.runs.front().measured);
  if (first.speed_ratio) out += fmt::format("speed within {:.1f} %, ", 100 * *worst.speed_ratio);
  if (first.turn_ratio) out += fmt::format("turn rate within {:.1f} %, ", 100 * *worst.turn_ratio);
  return out + fmt::format("tilt within {:.1f} mrad)", 1000 * *worst.tilt_max);
}

}  // namespace legwright
