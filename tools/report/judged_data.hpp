// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/run/comparison_record.hpp"
#include "tools/run/engine_record.hpp"
#include "tools/run/metrics_record.hpp"
#include "tools/run/numerics_record.hpp"
#include "tools/run/robustness_record.hpp"
#include "tools/run/verdict_record.hpp"

namespace legwright {

/// Which of the two designs that a run of one task has validated.
enum class Design { initial, result };

/// What `validate` wrote into result/; nothing where it has not run. Lists are cut to what a page
/// can show.
struct JudgedData {
  std::optional<MetricsRecord> metrics;
  std::optional<VerdictRecord> verdict;
  std::optional<ComparisonRecord> comparison;
  std::optional<NumericsRecord> numerics;
  std::optional<RobustnessRecord> robustness;
  std::optional<EngineRecord> second_engine;  // that of `validate --engine drake`
  JudgedSums sums;                            // of what stands in the folder, when it was read
  bool of_another = false;    // there is a verdict of another result, which is left out
  bool without_sums = false;  // the verdict does not say what it is of

  /// What was judged of a design; null without.
  const DesignVerdict* verdict_of(Design design) const;
  /// What was measured of it, by servo gains; empty without.
  const ByName<GainMetrics>& gains_of(Design design) const;
  /// The plan against physics; null where that is not known.
  const Comparison* comparison_of(Design design) const;
  /// The limits of a design, failing ones first, otherwise in the order of the file.
  std::vector<LimitRow> limits_of(Design design) const;
  /// The factors that were varied one at a time.
  const std::vector<RobustnessFactor>& factors() const;
};

/// A file that cannot be used becomes a note that names it and the key; so does one that is of
/// another result, or of another judgement than the verdict. @param run of one task
JudgedData read_judged(const std::filesystem::path& run, std::vector<std::string>& notes);

/// Throws IoError where a judgement is of another result. @param file that says so
/// @param here sums of what stands in the folder
void refuse_of_another(const std::filesystem::path& file, const std::optional<JudgedSums>& of,
                       const JudgedSums& here);

}  // namespace legwright
