// SPDX-License-Identifier: Apache-2.0
// How the optimisation went: cost and speed by iteration.
#include <fmt/format.h>

#include "tools/report/sections.hpp"
#include "tools/report/svg_plot.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

/// Values of a key by iteration.
PlotSeries by_iteration(const RunData& data, const char* key, const std::string& name, int colour) {
  PlotSeries series;
  series.name = name;
  series.colour = colour;
  series.points = data.iterations.size() <= 60;
  for (std::size_t i = 0; i < data.iterations.size(); ++i) {
    const auto value = number_at(data.iterations[i], {key});
    if (!value) continue;
    series.x.push_back(number_at(data.iterations[i], {"index"}).value_or(static_cast<double>(i)));
    series.y.push_back(*value);
  }
  return series;
}

PlotSeries level(const PlotSeries& over, double value, const std::string& name, int colour) {
  PlotSeries line;
  line.name = name;
  line.colour = colour;
  line.dashed = true;
  if (!over.x.empty()) line.x = {over.x.front(), over.x.back()};
  line.y.assign(line.x.size(), value);
  return line;
}

std::string cost_chart(const RunData& data) {
  const PlotSeries cost = by_iteration(data, "F", "body and gait co-designed", 1);
  std::vector<PlotSeries> lines{cost};
  auto motion_only = number_at(data.run, {"motion_only_F"});
  if (!motion_only && !cost.y.empty()) motion_only = cost.y.front();
  if (motion_only) lines.push_back(level(cost, *motion_only, "gait alone, initial body", 2));
  PlotOptions options;
  options.title = "Cost F by design iteration";
  options.x_label = "design iteration (0: gait alone)";
  options.y_label = "log scale";
  options.log_y = true;
  options.whole_x = true;
  return line_plot(lines, options);
}

std::string speed_chart(const RunData& data) {
  const PlotSeries speed = by_iteration(data, "speed_reached", "speed of the plan", 1);
  std::vector<PlotSeries> lines{speed};
  const auto wanted = number_at(data.run, {"speed_wanted"});
  if (wanted) lines.push_back(level(speed, *wanted, "wanted", 3));
  PlotOptions options;
  options.title = "Speed of the plan in the wanted direction";
  options.x_label = "design iteration";
  options.y_label = "m/s";
  options.y_from_zero = true;
  options.whole_x = true;
  return line_plot(lines, options);
}

std::string trace_chart(const Json& trace) {
  PlotSeries line;
  line.name = "gait alone";
  line.colour = 2;
  for (const Json& value : trace) {
    if (!value.is_number()) continue;
    line.x.push_back(static_cast<double>(line.x.size()));
    line.y.push_back(value.get<double>());
  }
  PlotOptions options;
  options.title = "Cost F of the gait alone";
  options.x_label = "Newton iteration";
  options.y_label = "log scale";
  options.log_y = true;
  options.whole_x = true;
  return line_plot({line}, options);
}

}  // namespace

void add_progress(Html& page, const RunData& data) {
  page.open("section").element("h2", "How it got there");
  if (data.iterations.empty()) {
    page.element("p", "events.jsonl has no finished iteration.", {{"class", "note"}}).close();
    return;
  }
  const auto before = number_at(data.iterations.front(), {"F"}),
             after = number_at(data.iterations.back(), {"F"});
  if (motion_only(data)) {
    page.element(
        "p", fmt::format("Only the gait was optimised; it ends at F = {}.", short_number(after)));
  } else if (before && after && *after > 0.0) {
    page.element(
        "p",
        fmt::format(
            "Optimising the gait alone ends at F = {}. Letting the body change brings it to {} in "
            "{} design iterations, {} times lower.",
            short_number(before), short_number(after), data.iterations.size() - 1,
            short_number(*before / *after)));
  }
  add_gap_note(page, data.run, "F and the planned speed are");
  page.open("div", {{"class", motion_only(data) ? "charts single" : "charts"}});
  if (!motion_only(data)) page.raw(cost_chart(data)).raw(speed_chart(data));
  const Json& trace = value_at(data.run, {"motion_only_trace"});
  if (trace.is_array() && trace.size() > 1) page.raw(trace_chart(trace));
  page.close().close();
}

}  // namespace legwright
