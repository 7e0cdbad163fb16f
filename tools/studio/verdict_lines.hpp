// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tools/files/json_file.hpp"
#include "tools/run/metrics_record.hpp"
#include "tools/run/verdict_record.hpp"

namespace legwright {

/// The word where a verdict is of another result.
inline constexpr const char* kUnknownVerdict = "UNKNOWN";

/// A row of a verdict as a page tells it: {words, term, passed, marks, numbers,
/// moment}. @param task its number @param name of one of several tasks, else empty
Json verdict_line(const LimitRow& row, const std::optional<MetricsRecord>& metrics, int task,
                  const std::string& name);

/// What `legwright validate` says of a run, or of each task of a joint one: {verdict, lines}, each
/// line with the moment at which it happened, where that is known. The word is PASS, FAIL, or
/// UNKNOWN where a verdict is of another result, which then has no lines.
Json verdict_lines(const std::filesystem::path& run);

}  // namespace legwright
