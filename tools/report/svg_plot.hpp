// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace legwright {

/// A line of a chart. Colours are numbers 1 … 6 of the page's palette, 0 is pale, so that they
/// follow light and dark.
struct PlotSeries {
  std::string name{};  // for the legend; without one it is left out there
  std::vector<double> x{}, y{};
  int colour = 1;
  bool dashed = false;
  bool steps = false;   // holds its value until the next x
  bool points = false;  // a dot at each value
  bool mark = false;    // a ring at each value and no line
  bool thin = false;
  std::vector<double> crosses{};  // x of marks on the axis: there was no value there
  /// Where given, as long as x: a band of the line's colour from low to high. With an empty y there
  /// is a band and no line.
  std::vector<double> low{}, high{};
};

/// What a chart's axes span.
struct PlotRange {
  double x_low = 0.0, x_high = 1.0, y_low = 0.0, y_high = 1.0;
};

struct PlotOptions {
  std::string title{}, x_label{}, y_label{};  // of the axes, with units
  bool log_y = false;                         // values ≤ 0 are left out
  bool y_from_zero = false;
  bool whole_x = false;                               // ticks at whole numbers only
  bool equal_axes = false;                            // one unit is as long along x as along y
  std::optional<std::pair<double, double>> x_span{};  // instead of what the lines span
  double least_height = 0.0;  // of what y spans, so that noise is not blown up; not on a log scale
  int width = 460, height = 270;  // of the drawing; it scales to the page
};

/// Round numbers about `count` apart that cover low … high from inside; at least one.
std::vector<double> linear_ticks(double low, double high, int count, bool whole = false);
/// Powers of ten within low … high, thinned out; with 2 and 5 between them where there are fewer
/// than three.
std::vector<double> log_ticks(double low, double high);
/// A tick's number as people write it: at most four digits, no exponent between 0.001 and 99999.
std::string tick_label(double value);

/// A chart as markup: figure with title, legend and SVG. Points that are not finite break the line.
/// With nothing to draw it says so.
std::string line_plot(const std::vector<PlotSeries>& series, const PlotOptions& options);

/// The same of costs by the number of an iteration, on a log scale.
std::string cost_plot(const std::vector<PlotSeries>& series, const std::string& title,
                      const std::string& iteration);

/// What the axes of a chart of these lines span; nothing where nothing can be drawn.
std::optional<PlotRange> plot_range(const std::vector<PlotSeries>& series,
                                    const PlotOptions& options);
/// The drawing of a chart alone, without title and legend. Points out of the range are not cut.
std::string plot_svg(const std::vector<PlotSeries>& series, const PlotOptions& options,
                     const PlotRange& range);
/// The names of lines beside their colours; empty for fewer than two lines.
std::string plot_legend(const std::vector<PlotSeries>& series);

/// One drawing of several with the same axes.
struct PlotPanel {
  std::string title;
  std::vector<PlotSeries> series;  // the same lines in each
};
/// Small charts side by side with one range for all, one legend and one title; panels without
/// anything to draw are left out.
std::string small_multiples(const std::vector<PlotPanel>& panels, const PlotOptions& options);

/// One foot's stances, planned and measured: pairs of touchdown and lift-off [s].
struct FootfallRow {
  std::string name;
  std::vector<std::pair<double, double>> planned, measured;
};

/// Footfall chart over 0 … end [s]: planned stances as broad bars, measured contacts as narrow dark
/// ones in them.
std::string footfall_plot(const std::vector<FootfallRow>& rows, double end,
                          const std::string& title);

}  // namespace legwright
