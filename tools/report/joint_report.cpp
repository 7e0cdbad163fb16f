// SPDX-License-Identifier: Apache-2.0
// The page of a joint run, and its summary.
#include <fmt/format.h>

#include "tools/report/number_words.hpp"
#include "tools/report/page_viewer.hpp"
#include "tools/report/parameter_view.hpp"
#include "tools/report/report.hpp"
#include "tools/report/sections.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

std::string tasks_line(const JointData& data) {
  std::string out = fmt::format("One body for {} tasks", data.tasks.size());
  const char* separator = ": ";
  for (const JointTaskData& task : data.tasks) {
    out += separator + spaced(task.name);
    if (task.task.weight) out += fmt::format(" (weight {})", short_number(task.task.weight));
    separator = ", ";
  }
  return out;
}

std::string cell_words(const MatrixDesign& design, std::size_t task) {
  const auto& cell = design.cells[task];
  return short_number(design.cost[task]) + (!cell ? "" : cell->pass ? ", PASS" : ", FAIL");
}

std::string row_of(const std::string& first, const std::vector<std::string>& cells) {
  std::string out = fmt::format("| {} |", escape_markdown(first));
  for (const std::string& cell : cells) out += fmt::format(" {} |", cell);
  return out + "\n";
}

std::string rule(std::size_t columns) {
  std::string out = "|---|";
  for (std::size_t k = 0; k < columns; ++k) out += "---:|";
  return out + "\n";
}

}  // namespace

std::string joint_report_page(const JointData& data) {
  PageFrame frame = frame_of(data.whole, tasks_line(data));
  frame.island["tasks"] = json_of(*data.whole.run.tasks);
  frame.island["verdict"] = Json::object();
  for (const JointTaskData& task : data.tasks)
    frame.island["verdict"][task.name] =
        task.run && task.run->verdict ? json_of(*task.run->verdict) : Json();
  const PageViewer viewer = viewer_of(data);
  frame.scenes = viewer.scenes;
  return framed_page(frame, [&](Html& page) {
    add_notes(page, data.whole);  // and once more at the end
    add_task_cards(page, data);
    add_viewer(page, viewer);
    add_matrix(page, data);
    add_task_pictures(page, data);
    add_bodies(page, data);
    add_task_attributions(page, data);
    add_front(page, data);
    add_strength(page, data.whole);
    add_starts(page, data);
    add_choice(page, data.whole.run);
    add_other_starts(page, data.whole.run);
    add_certificate(page, data.whole);
    add_origin(page, data.whole);
  });
}

std::string joint_report_summary(const JointData& data) {
  std::string out = fmt::format("# {}\n\n{}\n\n", escape_markdown(data.whole.title),
                                escape_markdown(tasks_line(data)));
  std::vector<std::string> heads;
  for (const JointTaskData& task : data.tasks) heads.push_back(escape_markdown(spaced(task.name)));
  out += row_of("F and verdict at three gains, of the body", heads) + rule(heads.size());
  for (const MatrixDesign& design : data.designs) {
    std::vector<std::string> cells;
    for (std::size_t t = 0; t < data.tasks.size(); ++t) cells.push_back(cell_words(design, t));
    out += row_of(spaced(design.name), cells);
  }
  heads.clear();
  for (const MatrixDesign& design : data.designs)
    heads.push_back(escape_markdown(spaced(design.name)));
  out += '\n';
  out += row_of("parameter", heads) + rule(heads.size());
  for (const ParameterView& p : parameters_of(data.whole.run)) {
    std::vector<std::string> cells;
    for (const MatrixDesign& design : data.designs) {
      const double* const value = design.s.find(p.name);
      cells.push_back(value ? p.with_unit(*value) : "–");
    }
    out += row_of(spaced(p.name), cells);
  }
  if (const std::string words = stepped_words(data); !words.empty())
    out += fmt::format("\n{}\n", escape_markdown(words));
  if (data.whole.strength)
    out += fmt::format("\n**Printed parts.** {}\n",
                       escape_markdown(strength_words(*data.whole.strength)));
  return out + "\n" + told_sums(data.whole) +
         "Pictures, charts and measurements: report.html in the folder above.\n";
}

}  // namespace legwright
