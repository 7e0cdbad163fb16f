// SPDX-License-Identifier: Apache-2.0
// How the optimisation went: cost and speed by iteration.
#include <fmt/format.h>

#include <cmath>

#include "tools/report/number_words.hpp"
#include "tools/report/sections.hpp"

namespace legwright {
namespace {

constexpr std::size_t kMostDots = 60;  // in a line; more run together

PlotSeries level(const PlotSeries& over, double value, const std::string& name, int colour) {
  PlotSeries line{.name = name, .colour = colour, .dashed = true};
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
  return cost_plot(lines, "Cost F by design iteration", "design iteration (0: gait alone)");
}

std::string speed_chart(const RunData& data) {
  const PlotSeries speed = by_iteration(data, &IterationEvent::speed_reached, "speed of the plan");
  std::vector<PlotSeries> lines{speed};
  if (data.run.speed_wanted) lines.push_back(level(speed, *data.run.speed_wanted, "wanted", 3));
  return line_plot(lines, {.title = "Speed of the plan in the wanted direction",
                           .x_label = "design iteration",
                           .y_label = "m/s",
                           .y_from_zero = true,
                           .whole_x = true});
}

std::string trace_chart(const std::vector<double>& trace) {
  PlotSeries line{.name = "gait alone", .y = trace, .colour = 2};
  for (std::size_t k = 0; k < trace.size(); ++k) line.x.push_back(static_cast<double>(k));
  return cost_plot({line}, "Cost F of the gait alone", "Newton iteration");
}

}  // namespace

PlotSeries by_iteration(const RunData& data, double IterationEvent::*value, const std::string& name,
                        int colour) {
  PlotSeries series{.name = name, .colour = colour};
  for (const IterationEvent& event : data.iterations) {
    if (!std::isfinite(event.*value)) continue;
    series.x.push_back(event.index);
    series.y.push_back(event.*value);
  }
  series.points = series.x.size() <= kMostDots;
  return series;
}

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
