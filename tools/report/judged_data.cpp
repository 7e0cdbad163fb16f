// SPDX-License-Identifier: Apache-2.0
#include "tools/report/judged_data.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tools/files/io_error.hpp"
#include "tools/report/if_present.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostPhases = 400, kMostCurves = 32, kMostFeet = 16, kMostJoints = 64,
                      kMostRows = 100, kMostGains = 6;

template <class T>
void cut(std::vector<T>& list, std::size_t most, const char* key, const std::string& where,
         std::vector<std::string>& notes) {
  if (list.size() <= most) return;
  notes.push_back(fmt::format("{}: all but the first {} of {} entries of \"{}\"", where, most,
                              list.size(), key));
  list.resize(most);
}

void cut_comparison(std::optional<Comparison>& side, const std::string& where,
                    std::vector<std::string>& notes) {
  if (!side) return;
  if (side->phases.size() < 2 || side->phases.size() > Eigen::Index{kMostPhases}) {
    notes.push_back(
        fmt::format("{}: \"phases\" should hold 2 to {} numbers; left out", where, kMostPhases));
    return side.reset();
  }
  cut(side->curves, kMostCurves, "curves", where, notes);
  cut(side->feet, kMostFeet, "feet", where, notes);
  cut(side->joints, kMostJoints, "joints", where, notes);
}

}  // namespace

const DesignVerdict* JudgedData::verdict_of(Design design) const {
  if (!verdict) return nullptr;
  return design == Design::initial ? &verdict->initial : &verdict->result;
}

const ByName<GainMetrics>& JudgedData::gains_of(Design design) const {
  static const ByName<GainMetrics> none;
  if (!metrics) return none;
  return design == Design::initial ? metrics->initial : metrics->result;
}

const Comparison* JudgedData::comparison_of(Design design) const {
  if (!comparison) return nullptr;
  const auto& side = design == Design::initial ? comparison->initial : comparison->result;
  return side ? &*side : nullptr;
}

std::vector<LimitRow> JudgedData::limits_of(Design design) const {
  const DesignVerdict* judged = verdict_of(design);
  std::vector<LimitRow> rows = judged != nullptr ? judged->limits : std::vector<LimitRow>();
  std::stable_partition(rows.begin(), rows.end(), [](const LimitRow& row) { return !row.pass; });
  return rows;
}

const std::vector<RobustnessFactor>& JudgedData::factors() const {
  static const std::vector<RobustnessFactor> none;
  return robustness ? robustness->factors : none;
}

void refuse_of_another(const fs::path& file, const std::optional<JudgedSums>& of,
                       const JudgedSums& here) {
  if (standing_of(of, here) == Standing::of_another)
    throw IoError(file.string() + ": " + kOfAnother);
}

JudgedData read_judged(const fs::path& run, std::vector<std::string>& notes) {
  JudgedData data;
  data.sums = sums_of_run(run);
  const fs::path result = run / "result";
  std::optional<JudgedSums> with;
  if_present(result / "verdict.json", notes, [&](const fs::path& file) {
    VerdictRecord verdict = read_record_file<VerdictRecord>(file);
    data.of_another = standing_of(verdict.of, data.sums) == Standing::of_another;
    refuse_of_another(file, verdict.of, data.sums);
    data.without_sums = !verdict.of;
    with = verdict.with;
    cut(verdict.initial.limits, kMostRows, "limits", "result/verdict.json, initial", notes);
    cut(verdict.result.limits, kMostRows, "limits", "result/verdict.json, result", notes);
    data.verdict = std::move(verdict);
  });
  const auto checked = [&](const fs::path& file, auto record) {
    refuse_of_another(file, record.of, data.sums);
    if (with && !names_bytes(*with, file.filename().string(), file))
      throw IoError(file.string() + ": not of the verdict beside it: judge again");
    return record;
  };
  if_present(result / "metrics.json", notes, [&](const fs::path& file) {
    if (auto metrics = read_metrics(file)) data.metrics = checked(file, *std::move(metrics));
  });
  if_present(result / "comparison.json", notes, [&](const fs::path& file) {
    ComparisonRecord comparison = checked(file, read_comparison(file));
    cut_comparison(comparison.initial, "result/comparison.json, initial", notes);
    cut_comparison(comparison.result, "result/comparison.json, result", notes);
    data.comparison = std::move(comparison);
  });
  if_present(result / "numerics.json", notes, [&](const fs::path& file) {
    data.numerics = checked(file, read_record_file<NumericsRecord>(file));
  });
  if_present(result / "robustness.json", notes, [&](const fs::path& file) {
    RobustnessRecord robustness = checked(file, read_record_file<RobustnessRecord>(file));
    cut(robustness.factors, kMostCurves, "factors", "result/robustness.json", notes);
    data.robustness = std::move(robustness);
  });
  if_present(result / engine_file(kDrake), notes, [&](const fs::path& file) {
    EngineRecord record = read_record_file<EngineRecord>(file);
    refuse_of_another(file, record.of, sums_of_result(run));
    if (record.result.size() > kMostGains) record.result.resize(kMostGains);
    data.second_engine = std::move(record);
  });
  return data;
}

}  // namespace legwright
