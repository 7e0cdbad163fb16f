// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/verdict_lines.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "tools/run/task_folders.hpp"
#include "tools/studio/plain_words.hpp"
#include "tools/studio/verdict_marks.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

struct Moment {
  double time = 0.0;   // [s]
  bool whole = false;  // of a whole walk, at its end
};

/// When it was: the fall, the hardest touch, the first warning of those gains, what the worst part
/// did first; the end of a walk that fails as a whole.
std::optional<Moment> moment_of(const LimitRow& row, const MetricsRecord& metrics) {
  if (!row.worst.empty() && row.worst.front().time) return Moment{*row.worst.front().time};
  for (const auto& [gain, measured] : metrics.result) {
    if (!row.where.empty() && row.where.find(gain) == std::string::npos) continue;
    if (measured.fall && !row.pass) return Moment{measured.fall->time};
    if (row.name.find("warning") != std::string::npos && !measured.warnings.empty())
      return Moment{measured.warnings.front().time};
    if (!row.pass && row.value && !row.where.empty()) return Moment{measured.seconds, true};
  }
  return std::nullopt;
}

/// @return whether the verdict is of what stands in the folder
bool add_lines(const fs::path& folder, int task, const std::string& name, Json& lines,
               std::string& words) {
  const auto verdict = read_record_file<VerdictRecord>(folder / "result" / "verdict.json");
  words += words.empty() ? "" : "\n";
  const Standing standing = standing_of(verdict.of, sums_of_run(folder));
  if (standing == Standing::of_another) {
    words += (name.empty() ? "" : name + ": ") + kOfAnother;
    return false;
  }
  const auto metrics = read_metrics(folder / "result" / "metrics.json");
  words += verdict.result.line;
  if (standing == Standing::without_sums) words += std::string(" (") + kWithoutSums + ")";
  for (const LimitRow& row : verdict.result.limits)
    lines.push_back(verdict_line(row, metrics, task, name));
  return true;
}

}  // namespace

Json verdict_line(const LimitRow& row, const std::optional<MetricsRecord>& metrics, int task,
                  const std::string& name) {
  const auto moment = metrics ? moment_of(row, *metrics) : std::nullopt;
  return {{"words", (name.empty() ? "" : name + ": ") + plain_words_of(row) + failing_parts(row)},
          {"term", term_of(row)},
          {"name", row.name},
          {"passed", row.pass},
          {"marks", marks_of(row, metrics)},
          {"numbers",
           {{"value", or_null(row.value)},
            {"low", or_null(row.low)},
            {"high", or_null(row.high)},
            {"unit", row.unit},
            {"gains", row.where}}},
          {"moment", moment ? Json{{"task", task}, {"time", moment->time}, {"whole", moment->whole}}
                            : Json(nullptr)}};
}

Json verdict_lines(const fs::path& run) {
  Json lines = Json::array();
  std::string words;
  const std::vector<TaskFolder> tasks = task_folders_of(run);
  bool known = true;
  if (tasks.empty()) known = add_lines(run, 0, "", lines, words);
  for (std::size_t k = 0; k < tasks.size(); ++k)
    known = add_lines(run / tasks[k].relative, static_cast<int>(k), tasks[k].name, lines, words) &&
            known;
  bool pass = true;
  for (const Json& line : lines) pass = pass && line["passed"].get<bool>();
  return {{"lines", lines},
          {"verdict",
           {{"word", !known ? kUnknownVerdict
                     : pass ? "PASS"
                            : "FAIL"},
            {"words", words}}}};
}

}  // namespace legwright
