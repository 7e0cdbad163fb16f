// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "tools/report/run_data.hpp"

namespace legwright {

/// The report as one self-contained HTML page (pictures inside, no script, no network), well-formed
/// as XML too.
std::string report_page(const RunData& data);

/// The same in a screen of Markdown: verdicts, speeds, cost, largest changes.
std::string report_summary(const RunData& data);

/// Writes RUN/report.html and RUN/result/summary.md; returns the page's path.
/// Throws IoError where there is no run, std::system_error where a file cannot be written.
std::filesystem::path write_report(const std::filesystem::path& run);

}  // namespace legwright
