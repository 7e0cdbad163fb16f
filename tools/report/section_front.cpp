// SPDX-License-Identifier: Apache-2.0
// How a joint run was searched: all starts, and the trade-off between two tasks.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "tools/report/sections.hpp"
#include "tools/report/svg_plot.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

constexpr double kOutside = 1.5;  // times the largest F of the front: it would flatten the curve
constexpr std::size_t kFewPoints = 3;  // of a front that has fewer between its ends all are drawn

std::string whole(const Json& json, const char* key) {
  const auto value = number_at(json, {key});
  return value ? fmt::format("{:.0f}", *value) : "–";
}

std::string start_words(const JointData& data, const std::string& start) {
  if (start == "initial") return "the initial body";
  for (const JointTaskData& task : data.tasks)
    if (task.name == start) return "the body for " + spaced(start) + " alone";
  return spaced(start);
}

void add_start_row(Html& page, const JointData& data, const Json& start, const std::string& name,
                   bool best) {
  page.open("tr", {{"class", best ? "chosen" : ""}}).open("td").element("b", name);
  if (best) page.element("em", "the best: this is the result");
  page.close();
  for (const char* key : {"F_start", "F"})
    page.element("td", three_digits(number_at(start, {key})), {{"class", "n"}});
  for (const JointTaskData& task : data.tasks)
    page.element("td", three_digits(number_at(start, {"F_tasks", task.name.c_str()})),
                 {{"class", "n"}});
  page.element("td", spaced(text_at(start, {"status"})));
  page.element("td", whole(start, "design_iterations"), {{"class", "n"}});
  page.element("td", whole(start, "newton_iterations"), {{"class", "n"}});
  const auto seconds = number_at(start, {"seconds"});
  page.element("td", seconds ? fmt::format("{:.1f} s", *seconds) : "–", {{"class", "n"}}).close();
}

void add_starts_table(Html& page, const JointData& data) {
  const Json& run = data.whole.run;
  page.open("div", {{"class", "scroll"}}).open("table", {{"class", "starts"}});
  page.open("thead").open("tr").element("th", "from");
  for (const char* head : {"F at first", "F at last"}) page.element("th", head, {{"class", "n"}});
  for (const JointTaskData& task : data.tasks)
    page.element("th", "F of " + spaced(task.name), {{"class", "n"}});
  page.element("th", "ended");
  for (const char* head : {"body steps", "Newton steps", "time"})
    page.element("th", head, {{"class", "n"}});
  page.close().close().open("tbody");
  const std::string best = text_at(run, {"best_start"});
  const Json &starts = value_at(run, {"starts"}), &alone = value_at(run, {"alone"});
  for (const Json& start : starts) {
    const std::string from = text_at(start, {"start"});
    add_start_row(page, data, start, start_words(data, from), from == best);
  }
  if (alone.is_array()) {
    for (const Json& one : alone) {
      const Json& tasks = value_at(one, {"tasks"});
      const bool named = tasks.is_array() && !tasks.empty() && tasks[0].is_string();
      add_start_row(page, data, one,
                    (named ? spaced(tasks[0].get<std::string>()) : "a task") + " alone", false);
    }
  }
  page.close().close().close();
}

/// F by design iteration, a line for each start.
std::string starts_chart(const JointData& data) {
  std::vector<PlotSeries> lines;
  std::map<std::string, std::size_t> line_of;
  for (const Json& event : data.whole.iterations) {
    const auto cost = number_at(event, {"F"}), index = number_at(event, {"index"});
    const Json& alone = value_at(event, {"alone"});
    if (!cost || !index || (alone.is_boolean() && alone.get<bool>())) continue;
    const std::string start = text_at(event, {"start"});
    const auto [at, made] = line_of.try_emplace(start, lines.size());
    if (made) {
      PlotSeries line;
      line.name = "from " + start_words(data, start);
      line.colour = static_cast<int>(lines.size() % 6) + 1;
      line.points = true;
      lines.push_back(std::move(line));
    }
    lines[at->second].x.push_back(*index);
    lines[at->second].y.push_back(*cost);
  }
  if (lines.empty()) return "";
  const PlotOptions options{.title = "Joint cost F by design iteration",
                            .x_label = "design iteration of the start",
                            .y_label = "log scale",
                            .log_y = true,
                            .whole_x = true};
  return line_plot(lines, options);
}

double front_cost(const JointData& data, const Json& costs, std::size_t task) {
  return number_at(costs, {data.tasks[task].name.c_str()}).value_or(NAN);
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
  for (const Json& point : data.front) {
    const double weight = number_at(point, {"weight"}).value_or(0.0);
    const bool inner = weight > 0.0 && weight < 1.0;
    count += inner ? 1 : 0;
    for (std::size_t t = 0; t < 2; ++t) {
      const double cost = front_cost(data, value_at(point, {"F_tasks"}), t);
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
  for (const Json& point : data.front) {
    const Json& costs = value_at(point, {"F_tasks"});
    const double x = front_cost(data, costs, 0), y = front_cost(data, costs, 1);
    const auto weight = number_at(point, {"weight"});
    if (outside(x, y, "the point of weight " + short_number(weight))) continue;
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
  page.open("div", {{"class", "scroll"}}).open("table").open("thead").open("tr");
  page.element("th", "weight of " + spaced(data.tasks[0].name), {{"class", "n"}});
  for (const JointTaskData& task : data.tasks)
    page.element("th", "F of " + spaced(task.name), {{"class", "n"}});
  page.element("th", "ended").close().close().open("tbody");
  for (const Json& point : data.front) {
    page.open("tr").element("td", short_number(number_at(point, {"weight"})), {{"class", "n"}});
    for (const JointTaskData& task : data.tasks)
      page.element("td", three_digits(number_at(point, {"F_tasks", task.name.c_str()})),
                   {{"class", "n"}});
    page.element("td", spaced(text_at(point, {"status"}))).close();
  }
  page.close().close().close().close();
}

}  // namespace

void add_starts(Html& page, const JointData& data) {
  page.open("section").element("h2", "Where the search began");
  if (!value_at(data.whole.run, {"starts"}).is_array()) {
    page.element("p", "run.json tells of no starts: the run has not ended.", {{"class", "note"}})
        .close();
    return;
  }
  page.element(
      "p",
      "The joint cost has more than one valley, so the search began from several bodies; all are "
      "listed. Below them, the searches for one task alone, which the other starts came from.",
      {{"class", "note"}});
  add_starts_table(page, data);
  page.open("div", {{"class", "charts single"}}).raw(starts_chart(data)).close().close();
}

void add_front(Html& page, const JointData& data) {
  if (data.tasks.size() != 2) return;  // of two tasks only
  const std::string first = spaced(data.tasks[0].name), second = spaced(data.tasks[1].name);
  page.open("section").element("h2", "The trade-off");
  if (!data.front.is_array() || data.front.empty()) {
    page.open("p", {{"class", "hint"}})
        .text("The curve between the tasks was not asked for. ")
        .element("code", "legwright optimize … --front 7")
        .text(" walks it.")
        .close()
        .close();
    return;
  }
  page.element("p",
               fmt::format("Each point is the best body found for one weighting of {} against {}; "
                           "down and left is better.",
                           first, second),
               {{"class", "note"}});
  const FrontPlot plot = front_series(data);
  const PlotOptions options{
      .title = "F of " + second, .x_label = "F of " + first, .y_label = "against F of " + first};
  page.open("div", {{"class", "charts single"}}).raw(line_plot(plot.series, options)).close();
  std::string outside;
  for (const std::string& one : plot.outside) outside += (outside.empty() ? "" : "; ") + one;
  if (!outside.empty())
    page.element("p", fmt::format("Outside the picture: {}.", outside), {{"class", "note"}});
  add_front_table(page, data);
  page.close();
}

}  // namespace legwright
