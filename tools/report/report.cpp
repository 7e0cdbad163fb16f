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

std::string verdict_line(const RunData& data, const char* key) {
  const std::string line = text_at(data.verdict, {key, "line"});
  return line.empty() ? "not validated" : line;
}

}  // namespace

std::string report_page(const RunData& data) {
  Html page;
  open_page(page, title_of(data), task_words(data.run));
  if (text_at(data.run, {"joint_run"}) == "../..") {
    page.open("p", {{"class", "note"}}).text("One task of a joint run: ");
    page.element("a", "report of the whole", {{"href", "../../report.html"}}).text(".").close();
  }
  add_verdicts(page, data);
  add_pictures(page, data);
  add_design_change(page, data);
  add_progress(page, data);
  add_gallery(page, data);
  add_terms(page, data);
  add_physics(page, data);
  add_plan(page, data);
  add_certificate(page, data);
  add_origin(page, data);
  Json island = island_of(data);
  island["verdict"] = data.verdict;
  close_page(page, island);
  return page.take();
}

std::string report_summary(const RunData& data) {
  std::string out = "# " + escape_markdown(title_of(data)) + "\n\n" +
                    escape_markdown(task_words(data.run)) + "\n\n";
  out += "| | verdict |\n|---|---|\n";
  out += "| before (initial body, its gait optimised) | " +
         escape_markdown(verdict_line(data, "initial")) + " |\n";
  out += std::string(motion_only(data) ? "| after (the same body, its gait optimised) | "
                                       : "| after (body and gait co-designed) | ") +
         escape_markdown(verdict_line(data, "result")) + " |\n\n";
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

std::vector<std::filesystem::path> write_report(const std::filesystem::path& run) {
  const auto write = [](const std::filesystem::path& folder, const std::string& page,
                        const std::string& summary) {
    write_file(folder / "report.html", page);
    std::filesystem::create_directories(folder / "result");
    write_file(folder / "result" / "summary.md", summary);
    return folder / "report.html";
  };
  const RunData data = read_run(run);
  if (!is_joint(data.run)) return {write(run, report_page(data), report_summary(data))};
  const JointData joint = read_joint_run(run);
  std::vector<std::filesystem::path> pages{
      write(run, joint_report_page(joint), joint_report_summary(joint))};
  for (const JointTaskData& task : joint.tasks) {
    if (task.run)
      pages.push_back(
          write(run / task.relative, report_page(*task.run), report_summary(*task.run)));
  }
  return pages;
}

}  // namespace legwright
