// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/report/joint_data.hpp"
#include "tools/report/run_data.hpp"

namespace legwright {

/// The report as one self-contained HTML page (pictures inside, no script, no network), well-formed
/// as XML too.
std::string report_page(const RunData& data);

/// The same in a screen of Markdown: verdicts, speeds, cost, largest changes.
std::string report_summary(const RunData& data);

/// What a summary is of: the scenes of the results, by their sums. Empty where there is none.
std::string told_sums(const RunData& data);

/// The page and the summary of a joint run: all bodies in all tasks, with links to the pages of the
/// tasks beside it.
std::string joint_report_page(const JointData& data);
std::string joint_report_summary(const JointData& data);

/// Writes RUN/report.html and RUN/result/summary.md; of a joint run also those of each of its
/// tasks. Returns the pages, the one of RUN first.
/// Throws IoError where there is no run, or it was replaced meanwhile, std::system_error where a
/// file cannot be written.
std::vector<std::filesystem::path> write_report(const std::filesystem::path& run);

}  // namespace legwright
