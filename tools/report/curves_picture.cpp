// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "tools/report/curves.hpp"
#include "tools/report/html.hpp"
#include "tools/report/svg_plot.hpp"

namespace legwright {
namespace {

constexpr int kWidth = 640, kPlotHeight = 340, kLegendRow = 20, kLegendTop = 66;

// The light palette of the pages, on white paper: a file of its own follows no page.
constexpr const char* kPictureStyle =
    "text { font: 12px system-ui, sans-serif; fill: #59636e; } .title { font-size: 15px; "
    "font-weight: 600; fill: #1f2328; } .grid { stroke: #d8dee4; fill: none; } .axis, .tick { "
    "stroke: #59636e; fill: none; } .line { fill: none; stroke-width: 2; } "
    ".c1 { stroke: #1f6feb; } .c2 { stroke: #bc4c00; } .c3 { stroke: #1a7f37; } "
    ".c4 { stroke: #8250df; } .c5 { stroke: #0e8a9c; } .c6 { stroke: #a8326e; } "
    ".f1 { fill: #1f6feb; } .f2 { fill: #bc4c00; } .f3 { fill: #1a7f37; } "
    ".f4 { fill: #8250df; } .f5 { fill: #0e8a9c; } .f6 { fill: #a8326e; }";

/// A variant's line, dots where MuJoCo passes what was handed back, rings where it fails it.
void add_variant(std::vector<PlotSeries>& all, const CurveVariant& variant, int colour) {
  PlotSeries line{.colour = colour}, passes{.colour = colour, .points = true};
  PlotSeries fails{.colour = colour, .mark = true};
  for (const CurvePoint& point : variant.points) {
    for (PlotSeries* series : {&line, &passes, &fails}) series->x.push_back(point.wanted);
    line.y.push_back(point.optimum);
    passes.y.push_back(point.pass ? point.optimum : NAN);
    fails.y.push_back(point.pass ? NAN : point.optimum);
  }
  all.insert(all.end(), {line, passes, fails});
}

std::string legend_row(const std::string& name, int colour, int y) {
  return fmt::format(
      "<path class=\"line c{}\" d=\"M14 {}h28\"/><text x=\"50\" y=\"{}\">{}</text>\n", colour,
      y - 4, y, escape_text(name));
}

}  // namespace

std::string curves_picture(const Curves& curves) {
  const PlotOptions options{.title = "Cost F against wanted speed",
                            .x_label = "wanted speed [m/s]",
                            .log_y = true,
                            .width = kWidth,
                            .height = kPlotHeight};
  std::vector<PlotSeries> lines;
  std::string legend;
  int y = kLegendTop;
  for (std::size_t v = 0; v < curves.variants.size(); ++v, y += kLegendRow) {
    const int colour = static_cast<int>(v % 6) + 1;
    add_variant(lines, curves.variants[v], colour);
    legend += legend_row(curves.variants[v].name, colour, y);
  }
  const auto range = plot_range(lines, options);
  if (!range) return "";
  std::string plot = plot_svg(lines, options, *range);
  plot.insert(5, fmt::format("y=\"{}\" width=\"{}\" height=\"{}\" ", y, kWidth, kPlotHeight));
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\">\n<style>{2}</style>\n<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n"
      "<text class=\"title\" x=\"14\" y=\"22\">{3}</text>\n<text x=\"14\" y=\"42\">cost F of "
      "the optimum, log scale; dot: what is handed back passes in MuJoCo, ring: it "
      "fails</text>\n{4}{5}</svg>\n",
      kWidth, y + kPlotHeight, kPictureStyle, escape_text(curves.robot + ", " + curves.way), legend,
      plot);
}

}  // namespace legwright
