// SPDX-License-Identifier: Apache-2.0
#include "tools/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tools/files/atomic_file.hpp"
#include "tools/report/page.hpp"
#include "tools/report/sections.hpp"
#include "tools/report/words.hpp"

namespace legwright {
std::string report_page(const RunData& data) {
  Html page;
  open_page(page, title_of(data), task_words(data.run));
  if (data.run.joint_run == "../..") {
    page.open("p", {{"class", "note"}}).text("One task of a joint run: ");
    page.element("a", "report of the whole", {{"href", "../../report.html"}}).text(".").close();
  }
  add_notes(page, data);  // and once more at the end
  add_verdicts(page, data);
  PictureBudget budget;
  add_pictures(page, data, budget);
  add_design_effect(page, data);
  add_limits(page, data);
  add_physics(page, data);
  add_comparison(page, data, budget);
  add_plan(page, data);
  add_robustness(page, data);
  add_numerics(page, data);
  add_choice(page, data.run);
  add_gap(page, data);
  add_other_starts(page, data.run);
  add_progress(page, data);
  add_gallery(page, data);
  add_terms(page, data);
  add_certificate(page, data);
  add_origin(page, data);
  Json island = island_of(data);
  island["verdict"] = data.verdict ? json_of(*data.verdict) : Json();
  close_page(page, island);
  return page.take();
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
  if (!data.run.joint()) return {write(run, report_page(data), report_summary(data))};
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
