// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/validate/disturbance.hpp"
#include "tools/validate/measure.hpp"
#include "tools/validate/stage_progress.hpp"

namespace legwright {

/// One thing that may be other than planned, and how far it is tried.
struct DisturbanceFactor {
  std::string name, label, unit;
  double Disturbance::*value = nullptr;
  double tested_low = 0.0,
         tested_high = 0.0;          // equal to the nominal value where a side makes no sense
  bool by_ratio = false;             // steps are equal in the logarithm
  std::pair<double, double> spread;  // drawn evenly for the survival share; relative to the nominal
                                     // value where that is not 0
  std::pair<double, double> valid;   // what a limit may ask for, ends included
};

/// The factors in the order in which they are told. @param nothing of the scene
std::vector<DisturbanceFactor> disturbance_factors(const Disturbance& nothing);

struct RobustnessOptions {
  int cycles = 6;
  int samples = 200;
  std::uint64_t seed = 1;
  int threads = 2;
  int bisections = 4;
  std::vector<std::string> only = {};  // names of the factors; empty: all
  /// By name, where a limit lies beyond what is tested by default: {low, high}. Tested only once
  /// all that is tested by default was survived, so that asking for more changes no margin found
  /// before.
  std::map<std::string, std::pair<double, double>> tested = {};
  ProgressListener progress = {};
};

/// How far one factor may go, all others as planned.
struct Margin {
  DisturbanceFactor factor;  // with what was tested
  double nominal = 0.0;
  std::optional<double> low, high;  // last value that walks; none: walks at all that was tested
  std::optional<double> low_fails, high_fails;  // first value that does not
  std::string low_cause, high_cause;
  int rollouts = 0;
};

/// Between which values the factor is drawn for the survival share.
std::pair<double, double> drawn_range(const Margin& margin);

/// One roll-out with all factors drawn together.
struct DrawnWalk {
  int sample = 0;
  Disturbance values;
  double seconds = 0.0;                   // simulated
  std::optional<std::string> cause = {};  // of failing
};

struct SurvivalShare {
  int samples = 0, survived = 0;
  double low = 0.0, high = 1.0;  // 95 % interval by Wilson
  std::map<std::string, int> causes;
  std::vector<DrawnWalk> worst;  // that failed, the shortest first; at most five

  double share() const { return samples > 0 ? static_cast<double>(survived) / samples : 0.0; }
};

struct Robustness {
  int cycles = 0;
  std::uint64_t seed = 0;
  std::optional<std::string> nominal_cause;  // where it fails undisturbed: then the rest is empty
  std::vector<Margin> margins;
  SurvivalShare survival;
};

/// Why a roll-out counts as failed, or nothing: it fell, it diverged, or once it is on its way it
/// goes or turns at less than half or more than twice what is wanted.
std::optional<std::string> failure(const Measurements& run, const WantedMotion& wanted);

/// 95 % interval of a share by Wilson's score. @param samples at least 1
std::pair<double, double> wilson_interval(int survived, int samples);

/// Plays the scene under disturbances at default gains: margins, then the survival share. The same
/// bits for any number of threads. Throws as load_scene.
Robustness measure_robustness(const std::filesystem::path& scene, const WantedMotion& wanted,
                              const RobustnessOptions& options = {});

}  // namespace legwright
