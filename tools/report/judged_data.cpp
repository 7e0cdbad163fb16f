// SPDX-License-Identifier: Apache-2.0
#include "tools/report/judged_data.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostPhases = 400, kMostCurves = 32, kMostFeet = 16, kMostJoints = 64,
                      kMostRows = 100;

/// Runs `read` if the file is there; what it throws becomes a note.
template <class Read>
void if_present(const fs::path& file, std::vector<std::string>& notes, const Read& read) {
  if (!fs::exists(file)) return;
  try {
    read();
  } catch (const std::exception& error) {
    notes.push_back(error.what());
  }
}

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

JudgedData read_judged(const fs::path& result, std::vector<std::string>& notes) {
  JudgedData data;
  const auto note_of = [&](const char* file, const auto& read) {
    if_present(result / file, notes, [&] { read(result / file, std::string("result/") + file); });
  };
  note_of("metrics.json",
          [&](const fs::path& file, const std::string&) { data.metrics = read_metrics(file); });
  note_of("verdict.json", [&](const fs::path& file, const std::string& name) {
    VerdictRecord verdict = read_record_file<VerdictRecord>(file);
    cut(verdict.initial.limits, kMostRows, "limits", name + ", initial", notes);
    cut(verdict.result.limits, kMostRows, "limits", name + ", result", notes);
    data.verdict = std::move(verdict);
  });
  note_of("comparison.json", [&](const fs::path& file, const std::string& name) {
    ComparisonRecord comparison = read_comparison(file);
    cut_comparison(comparison.initial, name + ", initial", notes);
    cut_comparison(comparison.result, name + ", result", notes);
    data.comparison = std::move(comparison);
  });
  note_of("numerics.json", [&](const fs::path& file, const std::string&) {
    data.numerics = read_record_file<NumericsRecord>(file);
  });
  note_of("robustness.json", [&](const fs::path& file, const std::string& name) {
    RobustnessRecord robustness = read_record_file<RobustnessRecord>(file);
    cut(robustness.factors, kMostCurves, "factors", name, notes);
    data.robustness = std::move(robustness);
  });
  return data;
}

}  // namespace legwright
