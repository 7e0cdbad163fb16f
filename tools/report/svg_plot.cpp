// SPDX-License-Identifier: Apache-2.0
#include "tools/report/svg_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/files/clean_text.hpp"
#include "tools/report/html.hpp"

namespace legwright {
namespace {

constexpr double kRight = 12, kTop = 10;  // around the plot's area
constexpr double kBottom = 42;            // with a label below the ticks
constexpr int kSmall = 300;               // narrower drawings have less room on the left

double left_of(const PlotOptions& options) { return options.width < kSmall ? 40 : 52; }
double bottom_of(const PlotOptions& options) { return options.x_label.empty() ? 22 : kBottom; }

/// Where values fall on the paper.
struct Axis {
  double low, high, from, to;
  bool log = false;
  double at(double value) const {
    const double share =
        log ? (std::log10(value) - std::log10(low)) / (std::log10(high) - std::log10(low))
            : (value - low) / (high - low);
    return from + share * (to - from);
  }
};

bool drawable(double x, double y, bool log) {
  return std::isfinite(x) && std::isfinite(y) && (!log || y > 0.0);
}

std::string figure(const std::string& title, const std::string& content,
                   const std::string& unit = "", const char* style = "chart") {
  return fmt::format("<figure class=\"{}\"><figcaption>{}{}</figcaption>\n{}</figure>\n", style,
                     escape_text(title),
                     unit.empty() ? "" : " <small>" + escape_text(unit) + "</small>", content);
}

/// The area between low and high, a piece for each stretch without a gap.
std::string band_of(const PlotSeries& s, const Axis& x, const Axis& y) {
  const std::size_t count = std::min({s.x.size(), s.low.size(), s.high.size()});
  const auto ok = [&](std::size_t i) {
    return drawable(s.x[i], s.low[i], y.log) && drawable(s.x[i], s.high[i], y.log);
  };
  std::string path;
  for (std::size_t i = 0; i < count;) {
    if (!ok(i)) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < count && ok(end)) ++end;
    for (std::size_t k = i; k < end; ++k)
      path += fmt::format("{}{:.1f} {:.1f}", k == i ? "M" : "L", x.at(s.x[k]), y.at(s.high[k]));
    for (std::size_t k = end; k-- > i;)
      path += fmt::format("L{:.1f} {:.1f}", x.at(s.x[k]), y.at(s.low[k]));
    path += "Z";
    i = end;
  }
  if (path.empty()) return "";
  return fmt::format("<path class=\"band f{}\" d=\"{}\"/>", s.colour, path);
}

/// Crosses on the axis, dots and rings.
std::string marks_of(const PlotSeries& s, const Axis& x, const Axis& y) {
  std::string svg;
  for (const double at : s.crosses) {
    if (!std::isfinite(at)) continue;
    svg += fmt::format("<path class=\"line c{}\" d=\"M{:.1f} {:.1f}l9 9m0 -9l-9 9\"/>", s.colour,
                       x.at(at) - 4.5, y.from - 4.5);
  }
  if (!s.points && !s.mark) return svg;
  for (std::size_t i = 0; i < std::min(s.x.size(), s.y.size()); ++i) {
    if (!drawable(s.x[i], s.y[i], y.log)) continue;
    svg += fmt::format("<circle class=\"{}{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/>",
                       s.mark ? "line c" : "f", s.colour, x.at(s.x[i]), y.at(s.y[i]),
                       s.mark ? "6.5" : "2.6");
  }
  return svg;
}

std::string path_of(const PlotSeries& s, const Axis& x, const Axis& y) {
  std::string path;
  bool pen_down = false;
  double last_y = 0.0;
  for (std::size_t i = 0; i < std::min(s.x.size(), s.y.size()); ++i) {
    if (!drawable(s.x[i], s.y[i], y.log)) {
      pen_down = false;
      continue;
    }
    if (pen_down && s.steps) path += fmt::format("L{:.1f} {:.1f}", x.at(s.x[i]), last_y);
    last_y = y.at(s.y[i]);
    path += fmt::format("{}{:.1f} {:.1f}", pen_down ? "L" : "M", x.at(s.x[i]), last_y);
    pen_down = true;
  }
  return path;
}

std::string frame(const Axis& x, const Axis& y, const PlotOptions& options) {
  std::string out;
  const auto y_ticks = y.log ? log_ticks(y.low, y.high)
                             : linear_ticks(y.low, y.high, std::max(3, options.height / 54));
  for (const double tick : y_ticks) {
    out += fmt::format(
        "<path class=\"grid\" d=\"M{:.1f} {:.1f}H{:.1f}\"/><text x=\"{:.1f}\" y=\"{:.1f}\" "
        "text-anchor=\"end\">{}</text>",
        x.from, y.at(tick), x.to, x.from - 6, y.at(tick) + 4, tick_label(tick));
  }
  for (const double tick : linear_ticks(
           x.low, x.high, options.width < kSmall ? 2 : options.width / 76, options.whole_x)) {
    out += fmt::format(
        "<path class=\"tick\" d=\"M{0:.1f} {1:.1f}v4\"/><text x=\"{0:.1f}\" y=\"{2:.1f}\" "
        "text-anchor=\"middle\">{3}</text>",
        x.at(tick), y.from, y.from + 17, tick_label(tick));
  }
  out += fmt::format("<path class=\"axis\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>", x.from, y.from, x.to);
  if (options.x_label.empty()) return out;
  out +=
      fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>",
                  x.to, y.from + 35, escape_text(options.x_label));
  return out;
}

struct Extent {
  double low = INFINITY, high = -INFINITY;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  /// Never empty: at least `least` wide.
  void widen(double share, double least) {
    const double by = std::max(share * (high - low), high - low < least ? least : 0.0);
    low -= by;
    high += by;
  }
  /// At least `span` wide, about the same middle.
  void reach(double span) {
    const double by = std::max(0.0, 0.5 * (span - (high - low)));
    low -= by;
    high += by;
  }
};

}  // namespace

std::vector<double> linear_ticks(double low, double high, int count, bool whole) {
  if (!(high > low) || !std::isfinite(low) || !std::isfinite(high)) return {low};
  const double rough = (high - low) / std::max(count, 1);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough * (1 - 1e-9)) {
      step = factor * power;
      break;
    }
  }
  if (whole) step = std::max(1.0, std::round(step));
  std::vector<double> ticks;
  const double first = std::ceil(low / step - 1e-9), last = std::floor(high / step + 1e-9);
  for (double k = first; k <= last; ++k) ticks.push_back(k * step == 0.0 ? 0.0 : k * step);
  if (ticks.empty()) ticks.push_back(low);
  return ticks;
}

std::vector<double> log_ticks(double low, double high) {
  if (!(low > 0.0) || !(high > low)) return {low > 0.0 ? low : 1.0};
  const int first = static_cast<int>(std::ceil(std::log10(low) - 1e-9));
  const int last = static_cast<int>(std::floor(std::log10(high) + 1e-9));
  std::vector<double> ticks;
  if (last - first + 1 >= 3) {
    const int step = (last - first) / 6 + 1;
    for (int k = first; k <= last; k += step) ticks.push_back(std::pow(10.0, k));
    return ticks;
  }
  for (int k = first - 1; k <= last; ++k) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double value = factor * std::pow(10.0, k);
      if (value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9)) ticks.push_back(value);
    }
  }
  return ticks.size() >= 2 ? ticks : linear_ticks(low, high, 4);
}

std::string tick_label(double value) {
  if (value == 0.0) return "0";
  const double size = std::abs(value);
  if (size >= 1e-3 && size < 1e5) {
    std::string text = fmt::format("{:.{}f}", value, size >= 1000 ? 0 : size >= 1 ? 2 : 4);
    if (text.find('.') != std::string::npos) {
      text.erase(text.find_last_not_of('0') + 1);
      if (text.back() == '.') text.pop_back();
    }
    return text.front() == '-' ? "−" + text.substr(1) : text;
  }
  return fmt::format("{:.2g}", value);
}

std::string plot_legend(const std::vector<PlotSeries>& series) {
  if (series.size() < 2) return "";
  std::string out = "<p class=\"legend\">";
  for (const PlotSeries& s : series) {
    if (s.name.empty()) continue;
    const bool band = s.y.empty() && !s.low.empty();
    out += fmt::format("<span><i class=\"key b{}{}\"></i>{}</span> ", s.colour,
                       band       ? " area"
                       : s.mark   ? " ring"
                       : s.dashed ? " dash"
                                  : "",
                       escape_text(s.name));
  }
  return out + "</p>\n";
}

std::optional<PlotRange> plot_range(const std::vector<PlotSeries>& series,
                                    const PlotOptions& options) {
  Extent x, y;
  for (const PlotSeries& s : series) {
    for (const std::vector<double>* values : {&s.y, &s.low, &s.high}) {
      for (std::size_t i = 0; i < std::min(s.x.size(), values->size()); ++i) {
        if (!drawable(s.x[i], (*values)[i], options.log_y)) continue;
        x.add(s.x[i]);
        y.add((*values)[i]);
      }
    }
    for (const double at : s.crosses)
      if (std::isfinite(at)) x.add(at);
  }
  if (!(y.high >= y.low)) return std::nullopt;
  const bool marks =
      std::any_of(series.begin(), series.end(), [](const PlotSeries& s) { return s.mark; });
  if (options.x_span) x = {options.x_span->first, options.x_span->second};
  x.widen(marks ? 0.05 : 0.0, 1e-9);  // rings would be cut off
  if (options.log_y) {
    const double ratio = std::max(std::pow(y.high / y.low, 0.05), 1.05);
    y = {y.low / ratio, y.high * ratio};
  } else {
    if (options.y_from_zero) y.add(0.0);
    const bool floor_at_zero = options.y_from_zero && y.low == 0.0;
    y.widen(0.06, 1e-9);
    if (floor_at_zero) y.low = 0.0;
    y.reach(options.least_height);
  }
  if (options.equal_axes) {  // the axis that has room to spare spans more
    const double wide = options.width - left_of(options) - kRight,
                 high = options.height - kTop - bottom_of(options);
    const double unit = std::max((x.high - x.low) / wide, (y.high - y.low) / high);
    x.reach(unit * wide);
    y.reach(unit * high);
  }
  return PlotRange{x.low, x.high, y.low, y.high};
}

std::string plot_svg(const std::vector<PlotSeries>& series, const PlotOptions& options,
                     const PlotRange& range) {
  const Axis x{range.x_low, range.x_high, left_of(options), options.width - kRight};
  const Axis y{range.y_low, range.y_high, options.height - bottom_of(options), kTop, options.log_y};
  std::string svg = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">",
                                options.width, options.height, escape_attribute(options.title));
  for (const PlotSeries& s : series) svg += band_of(s, x, y);
  svg += frame(x, y, options);
  for (const PlotSeries& s : series) {
    if (!s.mark && !s.y.empty())
      svg += fmt::format("<path class=\"line c{}{}{}\" d=\"{}\"/>", s.colour,
                         s.dashed ? " dash" : "", s.thin ? " fine" : "", path_of(s, x, y));
    svg += marks_of(s, x, y);
  }
  return svg + "</svg>\n";
}

std::string line_plot(const std::vector<PlotSeries>& series, const PlotOptions& options) {
  const auto range = plot_range(series, options);
  if (!range) return figure(options.title, "<p class=\"note\">Nothing to draw.</p>\n");
  return figure(options.title, plot_legend(series) + plot_svg(series, options, *range),
                options.y_label);
}

std::string cost_plot(const std::vector<PlotSeries>& series, const std::string& title,
                      const std::string& iteration) {
  return line_plot(series, {.title = title,
                            .x_label = iteration,
                            .y_label = "log scale",
                            .log_y = true,
                            .whole_x = true});
}

std::string small_multiples(const std::vector<PlotPanel>& panels, const PlotOptions& options) {
  std::vector<PlotSeries> all;
  const PlotPanel* first = nullptr;
  for (const PlotPanel& panel : panels) {
    if (!plot_range(panel.series, options)) continue;
    if (first == nullptr) first = &panel;
    all.insert(all.end(), panel.series.begin(), panel.series.end());
  }
  const auto range = plot_range(all, options);
  if (!range) return figure(options.title, "<p class=\"note\">Nothing to draw.</p>\n");
  std::string out = plot_legend(first->series) + "<div class=\"multiples\">\n";
  PlotOptions one = options;
  for (const PlotPanel& panel : panels) {
    if (!plot_range(panel.series, options)) continue;
    one.title = options.title + ", " + panel.title;
    out += "<div><h4>" + escape_text(panel.title) + "</h4>" + plot_svg(panel.series, one, *range) +
           "</div>\n";
  }
  return figure(options.title, out + "</div>\n", options.y_label, "chart wide");
}

namespace {

/// Code points of a text.
std::size_t letters_of(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

/// Without its end, where it has more than `most` code points.
std::string shortened(const std::string& text, std::size_t most) {
  if (letters_of(text) <= most) return text;
  std::size_t end = 0;
  for (std::size_t letters = 0; letters < most; ++end)
    letters += (static_cast<unsigned char>(text[end]) & 0xC0) != 0x80 ? 1 : 0;
  return clean_utf8(text.substr(0, end - 1)) + "…";
}

}  // namespace

std::string footfall_plot(const std::vector<FootfallRow>& rows, double end,
                          const std::string& title) {
  constexpr double kWidth = 460, kRow = 30, kLetter = 6.8;  // a letter's mean width
  constexpr std::size_t kLongestName = 24;
  std::vector<std::string> names;
  std::size_t longest = 0;
  for (const FootfallRow& row : rows) {
    names.push_back(shortened(clean_utf8(row.name), kLongestName));
    longest = std::max(longest, letters_of(names.back()));
  }
  const double name_width = std::max(62.0, 12.0 + kLetter * static_cast<double>(longest));
  const double height = kRow * static_cast<double>(rows.size()) + kBottom + 4;
  const double bottom = kRow * static_cast<double>(rows.size()) + 4;
  const Axis x{0.0, std::max(end, 1e-6), name_width, kWidth - kRight};
  std::string svg = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">",
                                kWidth, height, escape_attribute(title));
  const auto bars = [&](const std::vector<std::pair<double, double>>& spans, double y, double thick,
                        const char* style) {
    for (const auto& [from, to] : spans) {
      const double left = x.at(std::clamp(from, 0.0, end)), right = x.at(std::clamp(to, 0.0, end));
      if (!(right > left)) continue;  // also NaN
      svg += fmt::format(
          "<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
          "rx=\"2\"/>",
          style, left, y, right - left, thick);
    }
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double y = 4 + kRow * static_cast<double>(i);
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>",
                       name_width - 8, y + 18, escape_text(names[i]));
    bars(rows[i].planned, y + 3, 22, "planned");
    bars(rows[i].measured, y + 10, 8, "measured");
  }
  for (const double tick : linear_ticks(0.0, end, 6)) {
    svg += fmt::format(
        "<path class=\"tick\" d=\"M{0:.1f} {1:.1f}v4\"/><text x=\"{0:.1f}\" y=\"{2:.1f}\" "
        "text-anchor=\"middle\">{3}</text>",
        x.at(tick), bottom, bottom + 17, tick_label(tick));
  }
  svg += fmt::format(
      "<path class=\"axis\" d=\"M{:.1f} {:.1f}H{:.1f}\"/><text class=\"label\" x=\"{:.1f}\" "
      "y=\"{:.1f}\" text-anchor=\"end\">time [s]</text></svg>\n",
      x.from, bottom, x.to, x.to, bottom + 35);
  const std::string keys =
      "<p class=\"legend\"><span><i class=\"key wide\"></i>planned stance</span> "
      "<span><i class=\"key thin\"></i>measured contact</span></p>\n";
  return figure(title, keys + svg);
}

}  // namespace legwright
