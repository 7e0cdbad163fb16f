// SPDX-License-Identifier: Apache-2.0
#include "tools/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tools/io/atomic_file.hpp"
#include "tools/report/page.hpp"
#include "tools/report/sections.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

std::string title_of(const RunData& data) {
  const std::string robot = text_at(data.run, {"robot"}),
                    task = text_at(data.run, {"task", "name"});
  const std::string title = robot.empty()  ? task
                            : task.empty() ? robot
                                           : robot + " · " + spaced(task);
  return title.empty() ? "Legwright run" : title;
}

/// The main numbers once more, for programs that read the page.
Json island_of(const RunData& data) {
  Json island{{"schema", "legwright/report"}, {"version", 1}};
  for (const char* key : {"robot", "task", "status", "motion_only_F", "final_F", "parameters"}) {
    island[key] = value_at(data.run, {key});
  }
  island["verdict"] = data.verdict;
  return island;
}

std::string verdict_line(const RunData& data, const char* key) {
  const std::string line = text_at(data.verdict, {key, "line"});
  return line.empty() ? "not validated" : line;
}

}  // namespace

std::string report_page(const RunData& data) {
  Html page;
  open_page(page, title_of(data), task_words(data.run));
  add_verdicts(page, data);
  add_pictures(page, data);
  add_design_change(page, data);
  add_progress(page, data);
  add_gallery(page, data);
  add_terms(page, data);
  add_physics(page, data);
  add_plan(page, data);
  add_origin(page, data);
  close_page(
      page,
      "Made by legwright report from the files of this run; nothing is fetched from elsewhere.",
      "legwright-report", to_text(island_of(data)));
  return page.take();
}

std::string report_summary(const RunData& data) {
  std::string out = "# " + escape_markdown(title_of(data)) + "\n\n" +
                    escape_markdown(task_words(data.run)) + "\n\n";
  out += "| | verdict |\n|---|---|\n";
  out += "| before (initial body, its gait optimised) | " +
         escape_markdown(verdict_line(data, "initial")) + " |\n";
  out += "| after (body and gait co-designed) | " + escape_markdown(verdict_line(data, "result")) +
         " |\n\n";
  out += fmt::format("Cost F: {} with the gait alone, {} co-designed, {} design iterations.\n\n",
                     short_number(number_at(data.run, {"motion_only_F"})),
                     short_number(number_at(data.run, {"final_F"})),
                     short_number(number_at(data.run, {"design_iterations"})));
  auto parameters = parameters_of(data.run);
  std::stable_sort(parameters.begin(), parameters.end(), [](const auto& a, const auto& b) {
    return a.share_of_range() > b.share_of_range();
  });
  out += "| parameter | before | after | bounds |\n|---|---:|---:|---|\n";
  for (const ParameterView& p : parameters) {
    out += fmt::format("| {} | {} | {} | {} … {}{} |\n", escape_markdown(spaced(p.name)),
                       p.with_unit(p.initial), p.with_unit(p.final), p.with_unit(p.lower),
                       p.with_unit(p.upper), p.at_bound().empty() ? "" : ", at " + p.at_bound());
  }
  out += "\nPictures, charts and measurements: report.html in the folder above.\n";
  return out;
}

std::filesystem::path write_report(const std::filesystem::path& run) {
  const RunData data = read_run(run);
  const std::filesystem::path page = run / "report.html";
  write_file(page, report_page(data));
  std::filesystem::create_directories(run / "result");
  write_file(run / "result" / "summary.md", report_summary(data));
  return page;
}

}  // namespace legwright
