// SPDX-License-Identifier: Apache-2.0
// How a joint run was searched: all starts, and the trade-off between two tasks.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "tools/report/number_words.hpp"
#include "tools/report/sections.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

constexpr double kOutside = 1.5;  // times the largest F of the front: it would flatten the curve
constexpr std::size_t kFewPoints = 3;  // of a front that has fewer between its ends all are drawn

/// Not a number where the task has none.
double cost_of(const ByName<double>& costs, const std::string& task) {
  const double* const cost = costs.find(task);
  return cost != nullptr ? *cost : NAN;
}

std::string start_words(const JointData& data, const std::string& start) {
  if (start == "initial") return "the initial body";
  for (const JointTaskData& task : data.tasks)
    if (task.name == start) return "the body for " + spaced(start) + " alone";
  return spaced(start);
}

void add_start_row(Html& page, const JointData& data, const StartRecord& start,
                   const std::string& name, bool best) {
  page.open("tr", {{"class", best ? "chosen" : ""}}).open("td").element("b", name);
  if (best) page.element("em", "the best: this is the result");
  page.close();
  for (const double cost : {start.start_F, start.F}) page.number(three_digits(cost));
  for (const JointTaskData& task : data.tasks)
    page.number(three_digits(cost_of(start.F_of_tasks, task.name)));
  page.element("td", spaced(start.status));
  page.number(fmt::format("{}", start.design_iterations));
  page.number(fmt::format("{}", start.newton_iterations));
  page.number(fmt::format("{:.1f} s", start.seconds)).close();
}

void add_starts_table(Html& page, const JointData& data) {
  const RunRecord& run = data.whole.run;
  std::vector<TableColumn> columns{{"from"}, {"F at first", "n"}, {"F at last", "n"}};
  for (const JointTaskData& task : data.tasks)
    columns.push_back({"F of " + spaced(task.name), "n"});
  columns.insert(columns.end(),
                 {{"ended"}, {"body steps", "n"}, {"Newton steps", "n"}, {"time", "n"}});
  page.open("div", {{"class", "scroll"}}).open_table("starts", columns);
  for (const StartRecord& start : *run.starts)
    add_start_row(page, data, start, start_words(data, start.start), start.start == run.best_start);
  if (run.alone)
    for (const StartRecord& one : *run.alone)
      add_start_row(page, data, one,
                    (one.tasks.empty() ? "a task" : spaced(one.tasks.front())) + " alone", false);
  page.close().close().close();
}

/// F by design iteration, a line for each start.
std::string starts_chart(const JointData& data) {
  std::vector<PlotSeries> lines;
  std::map<std::string, std::size_t> line_of;
  for (const JointIterationEvent& event : data.whole.joint_iterations) {
    if (event.alone || !std::isfinite(event.F)) continue;
    const auto [at, made] = line_of.try_emplace(event.start, lines.size());
    if (made) {
      PlotSeries line;
      line.name = "from " + start_words(data, event.start);
      line.colour = static_cast<int>(lines.size() % 6) + 1;
      line.points = true;
      lines.push_back(std::move(line));
    }
    lines[at->second].x.push_back(event.index);
    lines[at->second].y.push_back(event.F);
  }
  if (lines.empty()) return "";
  return cost_plot(lines, "Joint cost F by design iteration", "design iteration of the start");
}

double front_cost(const JointData& data, const FrontPointRecord& point, std::size_t task) {
  return cost_of(point.F_of_tasks, data.tasks[task].name);
}

struct FrontPlot {
  std::vector<PlotSeries> series;
  std::vector<std::string> outside;  // designs too far off to be drawn
};

/// The largest F of the points between the ends, of each task: at an end one task has no say at all
/// and may cost any amount. Of a short front, of all points.
std::array<double, 2> front_size(const JointData& data) {
  std::array<double, 2> between{0.0, 0.0}, all{0.0, 0.0};
  std::size_t count = 0;
  for (const FrontPointRecord& point : data.front()) {
    const bool inner = point.weight > 0.0 && point.weight < 1.0;
    count += inner ? 1 : 0;
    for (std::size_t t = 0; t < 2; ++t) {
      const double cost = front_cost(data, point, t);
      if (!std::isfinite(cost)) continue;
      all[t] = std::max(all[t], cost);
      if (inner) between[t] = std::max(between[t], cost);
    }
  }
  return count < kFewPoints ? all : between;
}

FrontPlot front_series(const JointData& data) {
  FrontPlot plot;
  const std::array<double, 2> most = front_size(data);
  const auto outside = [&](double x, double y, const std::string& name) {
    if (!(x > kOutside * most[0]) && !(y > kOutside * most[1])) return false;
    plot.outside.push_back(fmt::format("{} ({} and {})", name, short_number(x), short_number(y)));
    return true;
  };
  PlotSeries line;
  line.name = "trade-off";
  line.points = true;
  for (const FrontPointRecord& point : data.front()) {
    const double x = front_cost(data, point, 0), y = front_cost(data, point, 1);
    if (outside(x, y, "the point of weight " + short_number(point.weight))) continue;
    line.x.push_back(x);
    line.y.push_back(y);
  }
  plot.series.push_back(std::move(line));
  int colour = 1;
  for (const MatrixDesign& design : data.designs) {
    colour = colour % 6 + 1;
    const auto &x = design.cost[0], &y = design.cost[1];
    if (!x || !y || outside(*x, *y, spaced(design.name))) continue;
    PlotSeries mark;
    mark.name = spaced(design.name);
    mark.colour = colour;
    mark.mark = true;
    mark.x = {*x};
    mark.y = {*y};
    plot.series.push_back(std::move(mark));
  }
  return plot;
}

void add_front_table(Html& page, const JointData& data) {
  page.open("details").element("summary", "The points of the curve");
  std::vector<TableColumn> columns{{"weight of " + spaced(data.tasks[0].name), "n"}};
  for (const JointTaskData& task : data.tasks)
    columns.push_back({"F of " + spaced(task.name), "n"});
  columns.push_back({"ended"});
  page.open("div", {{"class", "scroll"}}).open_table("", columns);
  for (const FrontPointRecord& point : data.front()) {
    page.open("tr").number(short_number(point.weight));
    for (const JointTaskData& task : data.tasks)
      page.number(three_digits(cost_of(point.F_of_tasks, task.name)));
    page.element("td", spaced(point.status)).close();
  }
  page.close().close().close().close();
}

}  // namespace

void add_starts(Html& page, const JointData& data) {
  page.open("section").element("h2", "Where the search began");
  if (!data.whole.run.starts) {
    page.note("run.json tells of no starts: the run has not ended.").close();
    return;
  }
  page.note(
      "The joint cost has more than one valley, so the search began from several bodies; all are "
      "listed. Below them, the searches for one task alone, which the other starts came from.");
  add_starts_table(page, data);
  page.open("div", {{"class", "charts single"}}).raw(starts_chart(data)).close().close();
}

void add_front(Html& page, const JointData& data) {
  if (data.tasks.size() != 2) return;  // of two tasks only
  const std::string first = spaced(data.tasks[0].name), second = spaced(data.tasks[1].name);
  page.open("section").element("h2", "The trade-off");
  if (data.front().empty()) {
    page.open("p", {{"class", "hint"}})
        .text("The curve between the tasks was not asked for. ")
        .element("code", "legwright optimize … --front 7")
        .text(" walks it.")
        .close()
        .close();
    return;
  }
  page.note(
      fmt::format("Each point is the best body found for one weighting of {} against {}; "
                  "down and left is better.",
                  first, second));
  const FrontPlot plot = front_series(data);
  const PlotOptions options{
      .title = "F of " + second, .x_label = "F of " + first, .y_label = "against F of " + first};
  page.open("div", {{"class", "charts single"}}).raw(line_plot(plot.series, options)).close();
  if (!plot.outside.empty())
    page.note(fmt::format("Outside the picture: {}.", fmt::join(plot.outside, "; ")));
  add_front_table(page, data);
  page.close();
}

}  // namespace legwright
