// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/verdict_marks.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "tools/run/worst_words.hpp"
#include "tools/studio/plain_words.hpp"

namespace legwright {
namespace {

/// What is said of one part, its value between the words.
struct PartWords {
  std::string_view row, before, after;
  bool percent = false;
};

constexpr std::array<PartWords, 10> kPartWords{{
    {"saturated_share", "servo at its limit for ", " of the time", true},
    {"slip", "slips by ", " m"},
    {"touchdown_error", "touches down ", " s off its time"},
    {"liftoff_error", "lifts off ", " s off its time"},
    {"landing_speed", "lands at ", " m/s"},
    {"foot_clearance", "steps over no more than ", " m"},
    {"missed_stances", "misses stances: ", ""},
    {"tracking", "off its targets by ", " rad"},
    {"torque_peak_share", "needs ", " of its torque limit", true},
    {"torque_rms", "needs ", " N m"},
}};

std::string number_words(double value, bool percent) {
  return percent ? fmt::format("{:.3g} %", 100 * value) : fmt::format("{:.3g}", value);
}

const PartWords* words_for(const LimitRow& row) {
  for (const PartWords& words : kPartWords)
    if (words.row == row.name) return &words;
  return nullptr;
}

std::string said_of(const WorstPart& part, const LimitRow& row) {
  const PartWords* words = words_for(row);
  if (!part.value || words == nullptr) return part.name + ": " + row.what;
  return fmt::format("{}: {}{}{}", part.name, words->before,
                     number_words(*part.value, words->percent), words->after);
}

/// Why it fell, or what MuJoCo warned of first, at the first of the gains at which it did.
std::string said_of_trunk(const LimitRow& row, const MetricsRecord& metrics) {
  for (const auto& [gain, measured] : metrics.result) {
    if (row.where.find(gain) == std::string::npos) continue;
    if (row.name == "falls" && measured.fall) return measured.fall->cause;
    if (row.name == "warnings" && !measured.warnings.empty()) return measured.warnings.front().text;
  }
  return {};
}

}  // namespace

std::string failing_parts(const LimitRow& row) {
  if (row.pass) return {};
  const PartWords* words = words_for(row);
  return worst_words(row.worst, [&](const WorstPart& part) {
    return part.value && words != nullptr ? number_words(*part.value, words->percent) : "";
  });
}

Json marks_of(const LimitRow& row, const std::optional<MetricsRecord>& metrics) {
  Json out = Json::array();
  if (row.worst.size() == 2 && row.worst.front().kind == "body") {
    for (int i : {0, 1}) {
      const std::string& other = row.worst[static_cast<std::size_t>(1 - i)].name;
      const WorstPart& part = row.worst[static_cast<std::size_t>(i)];
      out.push_back(
          {{"kind", "body"}, {"name", part.name}, {"words", part.name + " touches " + other}});
    }
    return out;
  }
  for (const WorstPart& part : row.worst)
    out.push_back({{"kind", part.kind}, {"name", part.name}, {"words", said_of(part, row)}});
  if (!out.empty() || row.pass || !metrics) return out;
  std::string words = said_of_trunk(row, *metrics);
  if (words.empty() && row.value) words = plain_value_of(row);
  if (!words.empty()) out.push_back({{"kind", "trunk"}, {"name", ""}, {"words", words}});
  return out;
}

}  // namespace legwright
