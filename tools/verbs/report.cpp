// SPDX-License-Identifier: Apache-2.0

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <vector>

#include "tools/io/json_file.hpp"
#include "tools/report/report.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

struct Options {
  std::string run;
  bool json = false;
};

int report(const Options& options) {
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
  auto options = std::make_shared<Options>();
  CLI::App* verb = program.add_subcommand("report", "Write the report of a run: one HTML file");
  verb->add_option("run", options->run, "Folder that legwright optimize wrote")->required();
  verb->add_flag("--json", options->json,
                 "One JSON document on stdout: the files that were written");
  verb->footer(
      "Writes RUN/report.html (self-contained, opens from disk) and RUN/result/summary.md.\n"
      "A joint run also gets a report of each task in RUN/tasks/.\n"
      "Run legwright validate and legwright render first; what is missing is named in the report.");
  verb->callback([options, &action] { action = [options] { return report(*options); }; });
}

}  // namespace legwright
