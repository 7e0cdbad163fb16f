// SPDX-License-Identifier: Apache-2.0
#include "tools/report/curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tools/report/number_words.hpp"
#include "tools/report/page.hpp"
#include "tools/report/parameter_view.hpp"
#include "tools/report/svg_plot.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

constexpr std::size_t kMostLines = 6;  // of one chart: as many colours as there are
constexpr double kLeastChange = 0.05;  // of a parameter's range; less is no main parameter

int colour_of(std::size_t variant) { return static_cast<int>(variant % 6) + 1; }

std::string metres_per_second(double speed) { return short_number(speed) + " m/s"; }

using CurveValue = std::function<std::optional<double>(const CurvePoint&, const CurveSample&)>;

PlotSeries series_of(const CurveVariant& variant, std::size_t gain, const CurveValue& value) {
  PlotSeries line;
  for (const CurvePoint& point : variant.points) {
    line.x.push_back(point.wanted);
    line.y.push_back(value(point, point.at_gains[gain]).value_or(NAN));
  }
  return line;
}

/// A line for each variant: default gains in full, half and double thin.
std::vector<PlotSeries> lines_of(const Curves& curves, const CurveValue& value, bool at_all_gains) {
  std::vector<PlotSeries> lines;
  for (std::size_t v = 0; v < curves.variants.size(); ++v) {
    const CurveVariant& variant = curves.variants[v];
    for (const std::size_t gain : {std::size_t{0}, std::size_t{2}}) {
      if (!at_all_gains) break;
      lines.push_back(series_of(variant, gain, value));
      lines.back().colour = colour_of(v);
      lines.back().thin = true;
      lines.back().dashed = gain == 0;
    }
    PlotSeries main = series_of(variant, 1, value);
    main.name = variant.name;
    main.colour = colour_of(v);
    main.points = true;
    lines.push_back(std::move(main));
  }
  return lines;
}

std::string speed_chart(const Curves& curves) {
  PlotSeries wanted{.name = "as wanted", .colour = 0, .dashed = true, .thin = true};
  std::vector<PlotSeries> lines = lines_of(
      curves, [](const CurvePoint&, const CurveSample& s) { return s.speed; }, true);
  for (std::size_t v = 0; v < curves.variants.size(); ++v) {
    PlotSeries& line = lines[3 * v + 2];
    for (const CurvePoint& point : curves.variants[v].points) {
      wanted.x.push_back(point.wanted);
      if (point.at_default().fall_time) line.crosses.push_back(point.wanted);
    }
  }
  std::sort(wanted.x.begin(), wanted.x.end());
  wanted.y = wanted.x;
  lines.insert(lines.begin(), std::move(wanted));
  return line_plot(lines, {.title = "Measured speed",
                           .x_label = "wanted speed [m/s]",
                           .y_label = "m/s; × falls",
                           .y_from_zero = true});
}

std::string chart(const Curves& curves, const std::string& title, const std::string& unit,
                  const CurveValue& value, bool log = false) {
  return line_plot(lines_of(curves, value, !log), {.title = title,
                                                   .x_label = "wanted speed [m/s]",
                                                   .y_label = unit,
                                                   .log_y = log,
                                                   .y_from_zero = !log});
}

std::optional<double> times(std::optional<double> value, double by) {
  return value ? std::optional(*value * by) : std::nullopt;
}

void add_charts(Html& page, const Curves& curves) {
  page.open("section").element("h2", "Against wanted speed");
  page.note(
      "Measured in MuJoCo. Broad lines: default servo gains; thin lines: double gains, "
      "dashed: half. Where the optimum of F fails there, another design may have been measured: "
      "the table tells its F.");
  page.open("div", {{"class", "charts"}});
  page.raw(speed_chart(curves));
  page.raw(chart(curves, "Limbs touch each other", "% of the time",
                 [](const CurvePoint&, const CurveSample& s) { return 100.0 * s.touch_share; }));
  page.raw(chart(curves, "Largest tilt of the trunk", "°; until it falls",
                 [](const CurvePoint&, const CurveSample& s) { return times(s.tilt, kDegrees); }));
  page.raw(chart(curves, "A servo at its limit", "% of the time",
                 [](const CurvePoint&, const CurveSample& s) {
                   return times(s.fall_time ? std::nullopt : s.saturated_share, 100.0);
                 }));
  page.raw(chart(
      curves, "Cost F of its optimum", "log scale; without a term F is not charged for it",
      [](const CurvePoint& p, const CurveSample&) { return p.optimum; }, true));
  page.close().close();
}

/// Of the parameters of one kind, those that moved most at any speed, at most as many as there are
/// colours.
std::vector<std::size_t> main_parameters(const CurveVariant& variant, bool angles) {
  const std::vector<ParameterView>& first = variant.points.front().parameters;
  std::vector<std::pair<double, std::size_t>> moved;
  for (std::size_t k = 0; k < first.size(); ++k) {
    if (first[k].angle != angles) continue;
    double most = 0.0;
    for (const CurvePoint& point : variant.points)
      if (k < point.parameters.size()) most = std::max(most, point.parameters[k].share_of_range());
    if (most >= kLeastChange) moved.emplace_back(-most, k);
  }
  std::sort(moved.begin(), moved.end());
  std::vector<std::size_t> chosen;
  for (std::size_t n = 0; n < std::min(moved.size(), kMostLines); ++n)
    chosen.push_back(moved[n].second);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

std::string parameter_chart(const CurveVariant& variant, bool angles) {
  std::vector<PlotSeries> lines;
  for (const std::size_t k : main_parameters(variant, angles)) {
    PlotSeries line;
    line.name = spaced(variant.points.front().parameters[k].name);
    line.colour = colour_of(lines.size());
    line.points = true;
    for (const CurvePoint& point : variant.points) {
      if (k >= point.parameters.size()) continue;
      const ParameterView& p = point.parameters[k];
      line.x.push_back(point.wanted);
      line.y.push_back(p.shown(p.final) - p.shown(p.initial));
    }
    lines.push_back(std::move(line));
  }
  std::string title = angles ? "Change of joint axes" : "Change of lengths";
  if (lines.size() == 1) title += ": " + lines.front().name;  // one line alone has no legend
  return line_plot(lines,
                   {.title = title,
                    .x_label = "wanted speed [m/s]",
                    .y_label = angles ? "° from the initial body" : "mm from the initial body",
                    .y_from_zero = true});
}

void add_designs(Html& page, const Curves& curves) {
  for (const CurveVariant& variant : curves.variants) {
    if (variant.motion_only) continue;
    page.open("section").element("h2", "The body that each speed wants: " + variant.name);
    page.note("The parameters that change most within their bounds.");
    page.open("div", {{"class", "charts"}});
    for (const bool angles : {false, true})
      if (!main_parameters(variant, angles).empty()) page.raw(parameter_chart(variant, angles));
    page.close().close();
  }
}

/// The lowest wanted speed of which `is` holds.
std::optional<double> first_where(const CurveVariant& variant,
                                  const std::function<bool(const CurvePoint&)>& is) {
  for (const CurvePoint& point : variant.points)
    if (is(point)) return point.wanted;
  return std::nullopt;
}

/// The highest wanted speed up to which every run passes.
std::optional<double> passes_up_to(const CurveVariant& variant) {
  std::optional<double> highest;
  for (const CurvePoint& point : variant.points) {
    if (!point.pass) break;
    highest = point.wanted;
  }
  return highest;
}

void add_cards(Html& page, const Curves& curves) {
  page.open("section", {{"class", "cards many"}});
  for (std::size_t v = 0; v < curves.variants.size(); ++v) {
    const CurveVariant& variant = curves.variants[v];
    page.open("div", {{"class", fmt::format("card t{}", colour_of(v))}});
    page.element("h2", variant.name);
    const auto highest = passes_up_to(variant);
    page.element("p", highest ? "up to " + metres_per_second(*highest) : "never passes",
                 {{"class", "verdict"}});
    page.open("ul");
    const auto touches = first_where(variant, [](const CurvePoint& p) { return p.touches(); });
    page.element("li", touches ? "limbs touch from " + metres_per_second(*touches) + " on"
                               : std::string("limbs never touch"));
    const auto slow = first_where(variant, [](const CurvePoint& p) {
      return !p.at_default().speed_ratio || *p.at_default().speed_ratio < 0.95;
    });
    page.element("li", slow ? "loses speed from " + metres_per_second(*slow) + " on"
                            : std::string("keeps its speed"));
    const auto falls = first_where(variant, [](const CurvePoint& p) { return p.falls(); });
    if (falls) page.element("li", "falls from " + metres_per_second(*falls) + " on");
    page.close().close();
  }
  page.note(
      "The highest speed up to which every run passes: no fall, 95 to 105 % of the wanted "
      "speed, level, no servo at its limit, at half, default and double gains.",
      "note wide");
  page.close();
}

void add_run_row(Html& page, const CurvePoint& point) {
  page.open("tr").number(tick_label(point.wanted));
  page.element("td", point.pass ? "PASS" : "FAIL", {{"class", point.pass ? "ok" : "no"}});
  for (const CurveSample& sample : point.at_gains)
    page.number(sample.fall_time ? "falls" : percent(sample.speed_ratio));
  const CurveSample& usual = point.at_default();
  page.number(percent(usual.touch_share));
  page.number(std::to_string(usual.touch_count));
  page.number(short_number(times(point.worst(&CurveSample::tilt), kDegrees)) + "°");
  page.number(short_number(point.cost));
  page.number(short_number(point.optimum));
  page.open("td")
      .open("small")
      .text(fmt::format("{}", fmt::join(point.reasons, "; ")))
      .close()
      .close()
      .close();
}

void add_runs(Html& page, const Curves& curves) {
  page.open("section").element("h2", "All runs");
  for (const CurveVariant& variant : curves.variants) {
    page.element("h3", variant.name);
    page.open("div", {{"class", "scroll"}, {"tabindex", "0"}})
        .open_table("runs", {{"wanted [m/s]", "n"},
                             {"verdict", ""},
                             {"half", "n"},
                             {"default", "n"},
                             {"double", "n"},
                             {"touches", "n"},
                             {"count", "n"},
                             {"tilt", "n"},
                             {"F", "n"},
                             {"optimum", "n"},
                             {"why not", ""}});
    for (const CurvePoint& point : variant.points) add_run_row(page, point);
    page.close().close().close();
  }
  page.note(
      "Half, default, double: share of the wanted speed at these servo gains. Touches, count: of "
      "limbs at default gains, share of the time and how often. Tilt: the largest at any gain. F: "
      "of what was measured; optimum: the least F that the search found.");
  page.close();
}

Json point_json(const CurvePoint& point) {
  Json gains = Json::object();
  for (std::size_t g = 0; g < kGains.size(); ++g) {
    const CurveSample& sample = point.at_gains[g];
    gains[kGains[g]] = {{"speed_mps", or_null(sample.speed)},
                        {"speed_ratio", or_null(sample.speed_ratio)},
                        {"fall_time_s", or_null(sample.fall_time)},
                        {"tilt_max_rad", or_null(sample.tilt)},
                        {"saturated_share", or_null(sample.saturated_share)},
                        {"self_contact_share", sample.touch_share},
                        {"self_contact_count", sample.touch_count}};
  }
  Json parameters = Json::object();
  for (const ParameterView& p : point.parameters) parameters[p.name] = p.final;
  return {{"run", point.run.generic_string()},
          {"wanted_mps", point.wanted},
          {"pass", point.pass},
          {"reasons", point.reasons},
          {"F", point.cost},
          {"optimum_F", point.optimum},
          {"gains", gains},
          {"parameters", parameters}};
}

}  // namespace

Json curves_json(const Curves& curves) {
  Json variants = Json::array();
  for (const CurveVariant& variant : curves.variants) {
    Json runs = Json::array();
    for (const CurvePoint& point : variant.points) runs.push_back(point_json(point));
    variants.push_back({{"name", variant.name},
                        {"motion_only", variant.motion_only},
                        {"passes_up_to_mps", or_null(passes_up_to(variant))},
                        {"runs", runs}});
  }
  return {{"schema", "legwright/curves"},
          {"version", 1},
          {"robot", curves.robot},
          {"task", curves.way},
          {"variants", variants}};
}

std::string curves_page(const Curves& curves) {
  return framed_page(
      {.title = curves.robot + " · how fast can it go?",
       .line = curves.way + ", every speed optimised for itself and played in MuJoCo",
       .footer = "Made by legwright curves from the files of these runs; nothing is fetched from "
                 "elsewhere.",
       .id = "legwright-curves",
       .island = curves_json(curves)},
      [&](Html& page) {
        add_cards(page, curves);
        add_charts(page, curves);
        add_designs(page, curves);
        add_runs(page, curves);
      });
}

}  // namespace legwright
