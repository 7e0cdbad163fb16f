// SPDX-License-Identifier: Apache-2.0

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <vector>

#include "mjcf/text/input_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/report/pair_report.hpp"
#include "tools/report/report.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/run/run_lock.hpp"
#include "tools/run/run_reach.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

struct ReportOptions : ReadingOptions {
  std::string run, other, output;
  bool json = false;
};

/// Two runs side by side.
int report_pair(const ReportOptions& options) {
  const fs::path page =
      options.output.empty() ? pair_file(options.run, options.other) : fs::path(options.output);
  // Of the folder that it lies in: a link in its place may lead out of the run.
  const auto around = run_around(page.has_parent_path() ? page.parent_path() : fs::path("."));
  std::optional<RunLock> lock;
  if (around) {
    lock.emplace(*around);
    check_no_links(*around);
  }
  options.check_run(options.run);
  options.check_run(options.other);
  const fs::path file = write_pair_report(options.run, options.other, options.output);
  if (options.json) {
    fmt::print("{}", to_text(Json{{"schema", "legwright/report-pair"},
                                  {"version", 1},
                                  {"report", file.string()},
                                  {"bytes", std::filesystem::file_size(file)}}));
  } else {
    fmt::print("{}\n", file.string());
  }
  return kOk;
}

int report(const ReportOptions& options) {
  if (!options.other.empty()) return report_pair(options);
  if (!options.output.empty())
    throw InputError(
        "report: --output is for two runs side by side (legwright report A B -o FILE); the report "
        "of "
        "one run is RUN/report.html");
  const ResultFolder locked = ResultFolder::open_to_write(options.run);
  options.check_run(options.run);  // the page draws its scenes, with their meshes
  const std::vector<std::filesystem::path> pages = write_report(options.run);
  if (options.json) {
    Json document{
        {"schema", "legwright/report"},
        {"version", 1},
        {"report", pages.front().string()},
        {"summary", (std::filesystem::path(options.run) / "result" / "summary.md").string()},
        {"bytes", std::filesystem::file_size(pages.front())}};
    if (pages.size() > 1) {
      document["task_reports"] = Json::array();
      for (std::size_t k = 1; k < pages.size(); ++k)
        document["task_reports"].push_back(pages[k].string());
    }
    fmt::print("{}", to_text(document));
  } else {
    for (const std::filesystem::path& page : pages) fmt::print("{}\n", page.string());
  }
  return kOk;
}

}  // namespace

void add_report(CLI::App& program, Action& action) {
  const auto [verb, options] =
      add_verb(program, action, "report",
               "Write the report of a run, or of two side by side: one HTML file", report);
  verb->add_option("run", options->run, "Folder that legwright optimize wrote")->required();
  verb->add_option("other", options->other, "A second run: both side by side, on one page");
  verb->add_option("-o,--output", options->output,
                   "of two runs: the page; default: A/compare_NAME.html, NAME being B's folder");
  verb->add_flag("--json", options->json,
                 "One JSON document on stdout: the files that were written");
  verb->footer(
      "Writes RUN/report.html (self-contained, opens from disk) and RUN/result/summary.md.\n"
      "A joint run also gets a report of each task in RUN/tasks/.\n"
      "With two runs, A and B, one page shows both: verdicts, strips, bodies, limits, margins. Of "
      "a\n"
      "joint run name the folder of a task: legwright report RUN/tasks/pace RUN/tasks/sideways\n"
      "Run legwright validate and legwright render first; what is missing is named in the report.");
}

}  // namespace legwright
