// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/robustness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "optimizer/base/parallel.hpp"

namespace legwright {
namespace {

constexpr double kLeastShare = 0.5, kGreatestShare = 2.0;  // of the wanted speed and turn rate
constexpr int kSettleCycles = 3;                           // the push comes at the end of two
constexpr double kPushAfter = 2.0;                         // cycles
constexpr std::size_t kWorst = 5;

struct Outcome {
  std::optional<std::string> cause;
  double seconds = 0.0;
  std::optional<double> fell_at = {};

  std::string told() const {
    if (!cause) return "";
    return fell_at ? fmt::format("falls after {:.2f} s ({})", *fell_at, *cause) : *cause;
  }
};

class Player {
 public:
  Player(const std::filesystem::path& file, const WantedMotion& wanted, int cycles)
      : scene_(file, wanted.velocity, wanted.forward), wanted_(wanted), cycles_(cycles) {}

  Outcome play(const Disturbance& disturbance, DelayStep delay_step = DelayStep::scene) const {
    Scene scene = scene_.with(disturbance, delay_step);
    const double push_time = kPushAfter * scene.trajectory.period;
    const RolloutOptions options =
        disturbed_rollout(scene, disturbance, cycles_, push_time, wanted_.forward);
    const Measurements run =
        measure(scene, wanted_, Eigen::Vector2d::Zero(), options, {.settle_cycles = kSettleCycles});
    Outcome out{failure(run, wanted_), run.seconds};
    if (run.fall) out.fell_at = run.fall->time;
    return out;
  }
  Disturbance nothing() const { return scene_.nothing(); }

 private:
  DisturbableScene scene_;
  WantedMotion wanted_;
  int cycles_;
};

/// One side of one factor: ever larger steps away from the nominal value until it fails, then
/// halving between the last good and the first bad value. So the margin is that of the first
/// failure on the way, not of an island of success behind one.
struct Side {
  double tested = 0.0;  // how far it was to go
  std::optional<double> last_good, first_bad;
  std::string cause;
  int rollouts = 0;
};

class SideExplorer {
 public:
  SideExplorer(const Player& player, const DisturbanceFactor& factor, int bisections)
      : player_(player), factor_(factor), bisections_(bisections), disturbance_(player.nothing()) {}

  /// @param limit of what is tested by default @param asked tried from there on, if that is further
  Side explore(double limit, double asked) {
    const double nominal = disturbance_.*factor_.value;
    side_.tested = limit;
    if (limit != nominal && !bracket(nominal, limit)) return side_;
    if (limit == nominal ? asked == nominal : (asked - limit) * (limit - nominal) <= 0.0)
      return side_;
    side_.tested = asked;
    bracket(limit, asked);
    return side_;
  }

 private:
  /// Brackets the first failure on the way. Whether there is none: it walks all the way.
  bool bracket(double from, double to) {
    const auto at_share = [&](double share) {
      if (share == 1.0) return to;
      return factor_.by_ratio ? from * std::pow(to / from, share) : from + share * (to - from);
    };
    double good = 0.0, bad = 0.0;
    const auto walks = [&](double share) {
      disturbance_.*factor_.value = at_share(share);
      const Outcome outcome = player_.play(disturbance_, DelayStep::fine);
      ++side_.rollouts;
      if (outcome.cause) side_.cause = outcome.told();
      (outcome.cause ? bad : good) = share;
      return !outcome.cause;
    };
    for (const double share : {0.125, 0.25, 0.5, 1.0})
      if (!walks(share)) break;
    if (bad == 0.0) return true;
    for (int k = 0; k < bisections_; ++k) walks((good + bad) / 2);
    side_.last_good = at_share(good);
    side_.first_bad = at_share(bad);
    return false;
  }

  const Player& player_;
  const DisturbanceFactor& factor_;
  int bisections_;
  Disturbance disturbance_;
  Side side_;
};

Side explore(const Player& player, const DisturbanceFactor& factor, bool low,
             const RobustnessOptions& options) {
  const double limit = low ? factor.tested_low : factor.tested_high;
  const auto wanted = options.tested.find(factor.name);
  double asked = limit;
  if (wanted != options.tested.end())
    asked = low ? std::min(limit, wanted->second.first) : std::max(limit, wanted->second.second);
  return SideExplorer(player, factor, options.bisections).explore(limit, asked);
}

// Uniform in [0, 1) from the generator's own bits: the distributions of the standard library differ
// from one implementation to the next.
double uniform(std::mt19937_64& generator) {
  return static_cast<double>(generator() >> 11U) * 0x1p-53;
}

std::vector<DrawnWalk> draw(const std::vector<Margin>& margins, const Disturbance& nothing,
                            const RobustnessOptions& options) {
  std::mt19937_64 generator(options.seed);
  std::vector<DrawnWalk> walks(static_cast<std::size_t>(options.samples));
  for (std::size_t k = 0; k < walks.size(); ++k) {
    walks[k].sample = static_cast<int>(k);
    walks[k].values = nothing;
    for (const auto& margin : margins) {
      const auto [low, high] = drawn_range(margin);
      const double u = uniform(generator);
      walks[k].values.*margin.factor.value =
          margin.factor.by_ratio ? low * std::pow(high / low, u) : low + u * (high - low);
    }
  }
  return walks;
}

SurvivalShare count(const std::vector<DrawnWalk>& walks) {
  SurvivalShare out;
  out.samples = static_cast<int>(walks.size());
  for (const auto& walk : walks) {
    if (!walk.cause) {
      ++out.survived;
      continue;
    }
    ++out.causes[*walk.cause];
    out.worst.push_back(walk);
  }
  std::stable_sort(out.worst.begin(), out.worst.end(),
                   [](const auto& a, const auto& b) { return a.seconds < b.seconds; });
  if (out.worst.size() > kWorst) out.worst.resize(kWorst);
  if (out.samples > 0) std::tie(out.low, out.high) = wilson_interval(out.survived, out.samples);
  return out;
}

std::vector<Margin> margins_to_find(const std::vector<DisturbanceFactor>& factors,
                                    const Disturbance& nothing, const RobustnessOptions& options) {
  std::vector<Margin> margins;
  const auto& only = options.only;
  for (const auto& factor : factors) {
    if (!only.empty() && std::find(only.begin(), only.end(), factor.name) == only.end()) continue;
    Margin& margin = margins.emplace_back();
    margin.factor = factor;
    margin.nominal = nothing.*factor.value;
  }
  return margins;
}

DisturbanceFactor angle(const char* name, const char* label, double Disturbance::*value,
                        double spread) {
  return {name, label, "rad", value, -0.5, 0.5, false, {-spread, spread}, {-1.5, 1.5}};
}

DisturbanceFactor push(const char* name, const char* label, double Disturbance::*value) {
  return {name, label, "m/s", value, -1.0, 1.0, false, {-0.1, 0.1}, {-100.0, 100.0}};
}

}  // namespace

std::vector<DisturbanceFactor> disturbance_factors(const Disturbance& nothing) {
  const double friction = nothing.floor_friction;
  using D = Disturbance;
  return {
      {"floor_friction",
       "friction of the floor",
       "1",
       &D::floor_friction,
       std::min(0.01, friction),
       std::max(2.0, friction),
       true,
       {0.8, 1.25},
       {1e-4, 100.0}},
      {"mass",
       "mass of the robot, times its own",
       "1",
       &D::mass_scale,
       0.25,
       4.0,
       true,
       {0.9, 1.1},
       {0.01, 100.0}},
      {"gains",
       "servo gains, times the default",
       "1",
       &D::gain_scale,
       0.125,
       8.0,
       true,
       {0.8, 1.25},
       {0.001, 1000.0}},
      {"delay", "delay of the servos", "s", &D::delay, 0.0, 0.04, false, {0.0, 0.002}, {0.0, 1.0}},
      angle("initial_roll", "set down askew, rolled to its right", &D::roll, 0.05),
      angle("initial_pitch", "set down askew, nose down", &D::pitch, 0.05),
      push("push_forward", "push forward", &D::push_forward),
      push("push_left", "push to its left", &D::push_left),
      angle("slope_along", "slope of the floor, uphill ahead on its way", &D::slope_along, 0.03),
      angle("slope_across", "slope of the floor, rising to the left", &D::slope_across, 0.03),
      {"ground_sink",
       "soft ground, by how much feet sink in",
       "m",
       &D::ground_sink,
       0.0,
       0.002,
       false,
       {0.0, 0.0005},
       {0.0, 0.02}},
  };
}

std::optional<std::string> failure(const Measurements& run, const WantedMotion& wanted) {
  if (run.diverged) return "the simulation diverges";
  if (run.fall) return run.fall->cause;
  const auto outcome = [](const std::optional<double>& ratio, const char* verb,
                          const char* what) -> std::optional<std::string> {
    if (ratio && *ratio >= kLeastShare && *ratio <= kGreatestShare) return std::nullopt;
    const bool slow = !ratio || !(*ratio > kGreatestShare);
    return fmt::format("{} at {} the wanted {}", verb, slow ? "less than half" : "more than twice",
                       what);
  };
  if (wanted.travels())
    if (auto cause = outcome(run.speed_ratio, "goes", "speed")) return cause;
  if (wanted.turns()) return outcome(run.turn_ratio, "turns", "rate");
  return std::nullopt;
}

std::pair<double, double> drawn_range(const Margin& margin) {
  const auto [low, high] = margin.factor.spread;
  if (margin.factor.by_ratio) return {margin.nominal * low, margin.nominal * high};
  return {margin.nominal + low, margin.nominal + high};
}

std::pair<double, double> wilson_interval(int survived, int samples) {
  constexpr double z = 1.959963984540054;
  const double n = samples, p = survived / n, z2 = z * z;
  const double centre = p + z2 / (2 * n), half = z * std::sqrt((p * (1 - p) + z2 / (4 * n)) / n);
  return {std::max(0.0, (centre - half) / (1 + z2 / n)),
          std::min(1.0, (centre + half) / (1 + z2 / n))};
}

Robustness measure_robustness(const std::filesystem::path& scene, const WantedMotion& wanted,
                              const RobustnessOptions& options) {
  const Player player(scene, wanted, options.cycles);
  Robustness out;
  out.cycles = options.cycles;
  out.seed = options.seed;
  if (const Outcome nominal = player.play(player.nothing()); nominal.cause) {
    out.nominal_cause = nominal.told();
    return out;
  }
  const auto factors = disturbance_factors(player.nothing());
  out.margins = margins_to_find(factors, player.nothing(), options);
  std::vector<Side> sides(2 * out.margins.size());
  std::vector<DrawnWalk> walks = draw(out.margins, player.nothing(), options);
  // Each job has its own place for its result, so that the order of execution leaves no trace.
  const int total = static_cast<int>(sides.size() + walks.size());
  StageProgress progress(options.progress, "disturbed walks", total);
  parallel_for(total, options.threads, [&](int job) {
    const auto k = static_cast<std::size_t>(job);
    if (k < sides.size()) {
      sides[k] = explore(player, out.margins[k / 2].factor, k % 2 == 0, options);
    } else {
      DrawnWalk& walk = walks[k - sides.size()];
      const Outcome outcome = player.play(walk.values);
      walk.cause = outcome.cause;
      walk.seconds = outcome.seconds;
    }
    progress.one_more();
  });
  for (std::size_t f = 0; f < out.margins.size(); ++f) {
    const Side &low = sides[2 * f], &high = sides[2 * f + 1];
    Margin& margin = out.margins[f];
    margin.factor.tested_low = low.tested;
    margin.factor.tested_high = high.tested;
    margin.low = low.last_good;
    margin.low_fails = low.first_bad;
    margin.low_cause = low.cause;
    margin.high = high.last_good;
    margin.high_fails = high.first_bad;
    margin.high_cause = high.cause;
    margin.rollouts = low.rollouts + high.rollouts;
  }
  out.survival = count(walks);
  return out;
}

}  // namespace legwright
