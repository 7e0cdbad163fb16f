// SPDX-License-Identifier: Apache-2.0
#include "tools/report/readings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tools/report/run_data.hpp"

namespace legwright {
namespace {

constexpr std::size_t kMostPhases = 400, kMostCurves = 32, kMostFeet = 16, kMostJoints = 64,
                      kMostPath = 100'000, kMostDrawn = 400, kMostRows = 100;

/// What a list is read with: where it stands, for the notes.
struct Reader {
  std::string where;
  std::vector<std::string>& notes;

  void note(const std::string& what) const { notes.push_back(where + ": " + what); }

  /// The numbers of a list of the given length, null as NaN; nothing with a note for anything else.
  std::vector<double> numbers(const Json& json, std::initializer_list<const char*> path,
                              std::size_t length) const {
    const Json& list = value_at(json, path);
    if (list.is_null()) return {};
    if (!list.is_array() || list.size() != length) {
      note(fmt::format("\"{}\" should hold {} numbers; left out", *(path.end() - 1), length));
      return {};
    }
    std::vector<double> out;
    for (const Json& value : list) {
      const double number =
          value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
      out.push_back(std::isfinite(number) ? number : std::numeric_limits<double>::quiet_NaN());
    }
    return out;
  }

  /// The elements of a list, the first `most` of them with a note.
  std::vector<const Json*> elements(const Json& json, const char* key, std::size_t most) const {
    const Json& list = value_at(json, {key});
    std::vector<const Json*> out;
    if (list.is_null()) return out;
    if (!list.is_array()) {
      note(fmt::format("\"{}\" should be a list; left out", key));
      return out;
    }
    for (const Json& element : list) {
      if (out.size() == most) {
        note(fmt::format("all but the first {} of {} entries of \"{}\"", most, list.size(), key));
        break;
      }
      if (element.is_object()) {
        out.push_back(&element);
      } else {
        note(fmt::format("an entry of \"{}\" is no object; left out", key));
      }
    }
    return out;
  }
};

Band band_at(const Reader& reader, const Json& json, const char* key, std::size_t length) {
  const Json& at = key == nullptr ? json : value_at(json, {key});
  if (at.is_null()) return {};
  return {reader.numbers(at, {"planned"}, length), reader.numbers(at, {"mean"}, length),
          reader.numbers(at, {"low"}, length), reader.numbers(at, {"high"}, length)};
}

MeanWorst mean_worst_at(const Json& json, const char* key) {
  return {number_at(json, {key, "mean"}), number_at(json, {key, "worst"}),
          number_at(json, {key, "planned"})};
}

ComparedFoot foot_of(const Reader& reader, const Json& json, std::size_t length) {
  ComparedFoot foot;
  foot.name = text_at(json, {"name"});
  foot.force_normal = band_at(reader, json, "force_normal_N", length);
  foot.force_tangential = band_at(reader, json, "force_tangential_N", length);
  foot.height = band_at(reader, json, "height_m", length);
  foot.slip_speed = band_at(reader, json, "slip_speed_mps", length);
  foot.friction_used = band_at(reader, json, "friction_used", length);
  foot.touchdown = mean_worst_at(json, "touchdown_error_s");
  foot.liftoff = mean_worst_at(json, "liftoff_error_s");
  foot.landing_speed = mean_worst_at(json, "landing_speed_mps");
  foot.slip = mean_worst_at(json, "slip_m");
  foot.roll = mean_worst_at(json, "roll_rad");
  return foot;
}

/// A path thinned out to what a chart can show; a point without numbers breaks it.
void read_path(const Reader& reader, const Json& json, const char* key, std::vector<double>& x,
               std::vector<double>& y) {
  const Json& list = value_at(json, {"path_xy", key});
  if (list.is_null()) return;
  if (!list.is_array() || list.size() > kMostPath) {
    reader.note(
        fmt::format("\"path_xy.{}\" should be at most {} points; left out", key, kMostPath));
    return;
  }
  const auto add = [&](const Json& point) {
    const bool ok =
        point.is_array() && point.size() == 2 && point[0].is_number() && point[1].is_number();
    x.push_back(ok ? point[0].get<double>() : std::numeric_limits<double>::quiet_NaN());
    y.push_back(ok ? point[1].get<double>() : std::numeric_limits<double>::quiet_NaN());
  };
  const std::size_t stride = list.size() / kMostDrawn + 1;
  for (std::size_t i = 0; i < list.size(); i += stride) add(list[i]);
  if (list.size() > 1 && (list.size() - 1) % stride != 0) add(list.back());
}

std::optional<double> element_at(const Json& list, std::size_t index) {
  if (!list.is_array() || list.size() <= index || !list[index].is_number()) return std::nullopt;
  return list[index].get<double>();
}

}  // namespace

std::optional<ComparisonView> comparison_of(const Json& document, const char* side,
                                            std::vector<std::string>& notes) {
  const Json& json = value_at(document, {side});
  if (json.is_null()) return std::nullopt;
  const Reader reader{fmt::format("result/comparison.json, {}", side), notes};
  const Json& phases = value_at(json, {"phases"});
  if (!phases.is_array() || phases.size() < 2 || phases.size() > kMostPhases) {
    reader.note(fmt::format("\"phases\" should hold 2 to {} numbers; left out", kMostPhases));
    return std::nullopt;
  }
  const std::size_t length = phases.size();
  ComparisonView out;
  out.phases = reader.numbers(json, {"phases"}, length);
  out.first_cycle = element_at(value_at(json, {"cycles"}), 0);
  out.last_cycle = element_at(value_at(json, {"cycles"}), 1);
  out.period = number_at(json, {"period_s"});
  for (const Json* curve : reader.elements(json, "curves", kMostCurves))
    out.curves.push_back({text_at(*curve, {"name"}), text_at(*curve, {"label"}),
                          text_at(*curve, {"unit"}), band_at(reader, *curve, nullptr, length)});
  for (const Json* foot : reader.elements(json, "feet", kMostFeet))
    out.feet.push_back(foot_of(reader, *foot, length));
  for (const Json* joint : reader.elements(json, "joints", kMostJoints))
    out.joints.push_back({text_at(*joint, {"name"}), band_at(reader, *joint, "angle_rad", length),
                          band_at(reader, *joint, "torque_Nm", length),
                          number_at(*joint, {"limit_Nm"})});
  read_path(reader, json, "planned", out.planned_x, out.planned_y);
  read_path(reader, json, "measured", out.measured_x, out.measured_y);
  out.cycle_table = value_at(json, {"cycle_table"});
  out.inverse_dynamics = value_at(json, {"inverse_dynamics"});
  return out;
}

std::vector<RobustnessFactor> factors_of(const Json& robustness, std::vector<std::string>& notes) {
  std::vector<RobustnessFactor> out;
  const Reader reader{"result/robustness.json", notes};
  for (const Json* json : reader.elements(robustness, "factors", kMostCurves)) {
    RobustnessFactor factor{.name = text_at(*json, {"name"}),
                            .label = text_at(*json, {"label"}),
                            .unit = text_at(*json, {"unit"}),
                            .nominal = number_at(*json, {"nominal"}),
                            .low = number_at(*json, {"low"}),
                            .high = number_at(*json, {"high"}),
                            .low_fails = number_at(*json, {"low_fails"}),
                            .high_fails = number_at(*json, {"high_fails"}),
                            .low_cause = text_at(*json, {"low_cause"}),
                            .high_cause = text_at(*json, {"high_cause"})};
    const auto low = number_at(*json, {"tested_low"}), high = number_at(*json, {"tested_high"});
    if (!low || !high || !(*high > *low)) {
      reader.note(fmt::format("factor \"{}\" has no tested range; left out", factor.name));
      continue;
    }
    factor.tested_low = *low;
    factor.tested_high = *high;
    out.push_back(std::move(factor));
  }
  return out;
}

std::vector<LimitRow> limits_of(const Json& verdict, const char* side,
                                std::vector<std::string>& notes) {
  std::vector<LimitRow> out;
  const Reader reader{fmt::format("result/verdict.json, {}", side), notes};
  for (const Json* json : reader.elements(value_at(verdict, {side}), "limits", kMostRows)) {
    const Json& pass = value_at(*json, {"pass"});
    if (!pass.is_boolean()) {
      reader.note("a limit does not say whether it is kept; left out");
      continue;
    }
    out.push_back({text_at(*json, {"name"}), text_at(*json, {"what"}), text_at(*json, {"unit"}),
                   text_at(*json, {"where"}), number_at(*json, {"low"}), number_at(*json, {"high"}),
                   number_at(*json, {"value"}), pass.get<bool>(),
                   value_at(*json, {"strict"}) == true});
  }
  std::stable_partition(out.begin(), out.end(), [](const LimitRow& row) { return !row.pass; });
  return out;
}

}  // namespace legwright
