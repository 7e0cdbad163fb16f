// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/records.hpp"

#include <fmt/format.h>

#include "tools/files/checksum.hpp"

namespace legwright {
namespace {

std::optional<std::string> unless_empty(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

RobustnessFactor factor_record(const Margin& margin) {
  const DisturbanceFactor& factor = margin.factor;
  return {.name = factor.name,
          .label = factor.label,
          .unit = factor.unit,
          .nominal = margin.nominal,
          .low = margin.low,
          .high = margin.high,
          .low_fails = margin.low_fails,
          .high_fails = margin.high_fails,
          .tested_low = factor.tested_low,
          .tested_high = factor.tested_high,
          .low_cause = unless_empty(margin.low_cause),
          .high_cause = unless_empty(margin.high_cause),
          .rollouts = margin.rollouts};
}

MonteCarlo survival_record(const SurvivalShare& survival, const std::vector<Margin>& margins) {
  MonteCarlo out{.samples = survival.samples,
                 .survived = survival.survived,
                 .share = survival.share(),
                 .share_low = survival.low,
                 .share_high = survival.high,
                 .spread = {},
                 .causes = survival.causes,
                 .worst = {}};
  for (const Margin& margin : margins)
    out.spread.emplace_back(margin.factor.name, drawn_range(margin));
  for (const DrawnWalk& walk : survival.worst) {
    out.worst.push_back({walk.sample, *walk.cause, walk.seconds, {}});
    for (const Margin& margin : margins)
      out.worst.back().values.emplace_back(margin.factor.name, walk.values.*margin.factor.value);
  }
  return out;
}

}  // namespace

ByName<GainMetrics> metrics_by_gain(const SceneValidation& validation) {
  ByName<GainMetrics> out;
  for (const Measurements& run : validation.at_gains) {
    GainMetrics metrics{run, {}, {run.feet.begin(), run.feet.end()}};
    metrics.feet_summary = summary_of(metrics.feet);
    out.emplace_back(gain_name(run.gain_scale), std::move(metrics));
  }
  return out;
}

DesignVerdict verdict_record(const Verdict& verdict) {
  DesignVerdict out{verdict.pass, verdict.line, verdict.reasons, {}};
  for (const JudgedLimit& row : verdict.limits)
    out.limits.push_back({row.name, row.what, row.unit, row.bounds.low, row.bounds.high, row.value,
                          row.where, row.pass, row.strict, row.worst});
  return out;
}

std::map<std::string, LimitRange> limit_ranges(const Limits& limits) {
  std::map<std::string, LimitRange> out;
  for (const auto& [name, bounds] : limits) out[name] = {bounds.low, bounds.high};
  return out;
}

std::string limits_sum(const Limits& limits) {
  const auto words = [](const std::optional<double>& bound) {
    return bound ? fmt::format("{}", *bound) : "none";
  };
  std::string text;
  for (const auto& [name, bounds] : limits)
    text += fmt::format("{} {} {}\n", name, words(bounds.low), words(bounds.high));
  return sha256_hex(text);
}

NumericsRecord numerics_record(const SecondOpinion& opinion) {
  NumericsRecord out{{}, opinion.agree, opinion.reasons};
  std::size_t reference = 0;
  for (const NumericalRun& run : opinion.runs) {
    out.runs.push_back({run.name,
                        run.label,
                        gain_name(run.gain_scale),
                        run.timestep,
                        run.integrator,
                        run.cone,
                        run.verdict.pass,
                        run.verdict.line,
                        numbers_of(run.measured),
                        {}});
    if (run.name == "reference")
      reference = out.runs.size() - 1;
    else
      out.runs.back().difference = out.runs.back().numbers - out.runs[reference].numbers;
  }
  return out;
}

RobustnessRecord robustness_record(const Robustness& robustness) {
  RobustnessRecord out{.cycles = robustness.cycles,
                       .seed = robustness.seed,
                       .seconds = {},
                       .undisturbed_cause = robustness.nominal_cause,
                       .factors = {},
                       .monte_carlo = survival_record(robustness.survival, robustness.margins)};
  for (const Margin& margin : robustness.margins) out.factors.push_back(factor_record(margin));
  return out;
}

ComparisonRecord comparison_record(const std::optional<Comparison>& initial,
                                   const std::optional<Comparison>& result) {
  ComparisonRecord out;
  if (initial) out.initial = rounded_curves(*initial);
  if (result) out.result = rounded_curves(*result);
  return out;
}

}  // namespace legwright
