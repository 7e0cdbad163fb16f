// SPDX-License-Identifier: Apache-2.0
// How the optimisation went: cost and speed by iteration.
#include <fmt/format.h>

#include <cmath>

#include "tools/report/sections.hpp"
#include "tools/report/svg_plot.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

PlotSeries by_iteration(const RunData& data, double IterationEvent::*value,
                        const std::string& name) {
  PlotSeries series;
  series.name = name;
  series.colour = 1;
  series.points = data.iterations.size() <= 60;
  for (const IterationEvent& event : data.iterations) {
    if (!std::isfinite(event.*value)) continue;
    series.x.push_back(event.index);
    series.y.push_back(event.*value);
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
  const PlotSeries cost = by_iteration(data, &IterationEvent::F, "body and gait co-designed");
  std::vector<PlotSeries> lines{cost};
  auto motion_only = data.run.motion_only_F;
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
  const PlotSeries speed = by_iteration(data, &IterationEvent::speed_reached, "speed of the plan");
  std::vector<PlotSeries> lines{speed};
  if (data.run.speed_wanted) lines.push_back(level(speed, *data.run.speed_wanted, "wanted", 3));
  PlotOptions options;
  options.title = "Speed of the plan in the wanted direction";
  options.x_label = "design iteration";
  options.y_label = "m/s";
  options.y_from_zero = true;
  options.whole_x = true;
  return line_plot(lines, options);
}

std::string trace_chart(const std::vector<double>& trace) {
  PlotSeries line;
  line.name = "gait alone";
  line.colour = 2;
  for (const double value : trace) {
    line.x.push_back(static_cast<double>(line.x.size()));
    line.y.push_back(value);
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
    page.note("events.jsonl has no finished iteration.").close();
    return;
  }
  const double before = data.iterations.front().F, after = data.iterations.back().F;
  if (motion_only(data)) {
    page.element(
        "p", fmt::format("Only the gait was optimised; it ends at F = {}.", short_number(after)));
  } else if (std::isfinite(before) && after > 0.0) {
    page.element(
        "p",
        fmt::format(
            "Optimising the gait alone ends at F = {}. Letting the body change brings it to {} in "
            "{} design iterations, {} times lower.",
            short_number(before), short_number(after), data.iterations.size() - 1,
            short_number(before / after)));
  }
  add_gap_note(page, data.run, "F and the planned speed are");
  page.open("div", {{"class", motion_only(data) ? "charts single" : "charts"}});
  if (!motion_only(data)) page.raw(cost_chart(data)).raw(speed_chart(data));
  if (const auto& trace = data.run.motion_only_trace; trace && trace->size() > 1)
    page.raw(trace_chart(*trace));
  page.close().close();
}

}  // namespace legwright
