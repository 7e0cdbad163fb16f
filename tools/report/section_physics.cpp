// SPDX-License-Identifier: Apache-2.0
// Plan against simulation: speeds at all gains, foot contacts, heights and forces.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tools/report/number_words.hpp"
#include "tools/report/page_template.hpp"
#include "tools/report/sections.hpp"

namespace legwright {
namespace {

struct Quantity {
  const char* name;
  std::function<std::string(const GainMetrics&)> show;
  bool after_first_cycle = false;  // measured from the second cycle on
};

std::string speed(const GainMetrics& measured, int axis) {
  if (!measured.velocity) return "–";
  const double value = (*measured.velocity)[axis];
  return fmt::format("{}{:.4f}", value < -5e-5 ? "−" : "", std::abs(value));
}

const std::vector<Quantity>& quantities() {
  using M = GainMetrics;
  static const std::vector<Quantity> list = {
      {"speed forward [m/s]", [](const M& m) { return speed(m, 0); }},
      {"speed to the left [m/s]", [](const M& m) { return speed(m, 1); }},
      {"of the planned speed", [](const M& m) { return percent(m.speed_ratio); }},
      {"of the speed that the plan reached",
       [](const M& m) { return percent(m.plan_speed_ratio); }},
      {"falls",
       [](const M& m) {
         return m.fall ? fmt::format("after {} s", short_number(m.fall->time)) : "no";
       }},
      {"largest tilt", [](const M& m) { return scaled(m.tilt_max, kDegrees, "°"); }},
      {"heading drift", [](const M& m) { return scaled(m.heading_drift, kDegrees, "°"); }},
      {"slip per stance, mean",
       [](const M& m) { return scaled(m.feet_summary.slip_mean, 1e3, " mm"); }, true},
      {"touchdown, mean",
       [](const M& m) { return early_or_late(finite(m.feet_summary.touchdown_mean)); }, true},
      {"joint tracking, RMS", [](const M& m) { return scaled(m.tracking_rms, kDegrees, "°"); },
       true},
      {"servo torque, RMS", [](const M& m) { return scaled(m.torque_rms, 1, " N·m"); }, true},
      {"servos at their limit", [](const M& m) { return percent(finite(m.saturated_share)); },
       true},
      {"strays from its way",
       [](const M& m) { return m.path_deviation ? percent(m.path_deviation) : "–"; }},
      {"a cycle multiplies a disturbance by",
       [](const M& m) { return m.floquet_multiplier ? short_number(*m.floquet_multiplier) : "–"; }},
      {"MuJoCo warnings", [](const M& m) { return std::to_string(m.warnings.size()); }},
  };
  return list;
}

std::string quantity_html(const Quantity& quantity, const ByName<GainMetrics>& gains) {
  bool any = false;
  const std::string cells = each(gains, [&](const auto& gain) {
    const GainMetrics& measured = gain.second;
    const bool too_short = quantity.after_first_cycle && measured.cycles < 2;
    const std::string text = too_short ? "–" : quantity.show(measured);
    any = any || text != "–";
    return fill(R"(<td class="n">{text}</td>)", {{"text", text}});
  });
  if (!any) return "";  // it fell before there was anything to measure
  return fill("<tr><td>{name}</td>{cells}</tr>\n",
              {{"name", quantity.name}, Hole::markup("cells", cells)});
}

/// What was measured of one body, a column for each gain.
std::string gain_table(const ByName<GainMetrics>& gains, const char* title) {
  return fill(
      R"(<div><h3>{title}</h3><table class="gains"><thead><tr><th>servo gains</th>{gains}</tr></thead><tbody>
{rows}</tbody></table></div>
)",
      {{"title", title},
       Hole::markup("gains",
                    each(gains, [](const auto& gain) { return number_head_html(gain.first); })),
       Hole::markup("rows", each(quantities(), [&](const Quantity& quantity) {
                      return quantity_html(quantity, gains);
                    }))});
}

/// Planned stances of a foot as intervals over 0 … end [s].
std::vector<std::pair<double, double>> planned_stances(const Trajectory& plan, int foot,
                                                       double end) {
  std::vector<std::pair<double, double>> out;
  const double step = plan.period / plan.knot_count;
  const int knots = static_cast<int>(end / step) + 1;
  for (int k = 0; k <= knots; ++k) {
    if (plan.at(k % plan.knot_count, plan.contact_column(foot)) < 0.5) continue;
    const double from = (k - 0.5) * step,
                 to = (k + 0.5) * step;  // a knot stands for the time about it
    if (!out.empty() && out.back().second >= from - 1e-9) {
      out.back().second = to;
    } else {
      out.emplace_back(from, to);
    }
  }
  return out;
}

std::vector<std::pair<double, double>> measured_contacts(const RunData& data, Design design,
                                                         const std::string& name) {
  const GainMetrics* measured = data.gains_of(design).find("default");
  if (measured == nullptr) return {};
  for (const FootMetrics& foot : measured->feet)
    if (foot.name == name) return foot.contacts;
  return {};
}

std::string footfalls(const RunData& data, const Trajectory& plan, Design design,
                      const std::string& title) {
  const double end = std::min(4.0, 3.0 * plan.period);
  std::vector<FootfallRow> rows;
  for (int f = 0; f < plan.foot_count(); ++f) {
    const std::string& name = plan.foot_names[static_cast<std::size_t>(f)];
    rows.push_back({name, planned_stances(plan, f, end), measured_contacts(data, design, name)});
  }
  return footfall_plot(rows, end, title);
}

/// One line per foot over a cycle; `value` of (knot, foot).
std::string foot_chart(const Trajectory& plan, const PlotOptions& options,
                       const std::function<double(int, int)>& value) {
  std::vector<PlotSeries> lines;
  for (int f = 0; f < plan.foot_count(); ++f) {
    PlotSeries line;
    line.name = plan.foot_names[static_cast<std::size_t>(f)];
    line.colour = f % 6 + 1;
    for (int k = 0; k <= plan.knot_count; ++k) {
      line.x.push_back(plan.period * k / plan.knot_count);
      line.y.push_back(value(k % plan.knot_count, f));
    }
    lines.push_back(std::move(line));
  }
  return line_plot(lines, options);
}

}  // namespace

void add_physics(Html& page, const RunData& data) {
  page.open("section").element("h2", "What was measured");
  const auto& gains = data.gains_of(Design::result);
  if (gains.empty()) {
    add_hint(page, "The gaits have not been played in MuJoCo yet.", "validate", data);
    page.close();
    return;
  }
  std::string tables = gain_table(gains, motion_only(data) ? "Measured" : "After");
  if (!motion_only(data)) tables += gain_table(data.gains_of(Design::initial), "Before");
  page.raw(fill(
      R"(<p class="note">{cycles} cycles in MuJoCo. Servo gains say how hard the joints hold on to their
planned angles: a sound gait does not depend on them.</p>
<div class="charts tables">
{tables}</div>
)",
      {{"cycles", std::to_string(data.metrics->cycles)}, Hole::markup("tables", tables)}));
  page.close();
}

void add_plan(Html& page, const RunData& data) {
  page.open("section").element("h2", "Footfalls");
  if (!data.result_plan) {
    page.note("result/motion.csv is not there: the run has not ended, or its plan cannot be read.")
        .close();
    return;
  }
  const Trajectory& plan = *data.result_plan;
  page.open("div", {{"class", "charts"}});
  if (data.initial_plan && !motion_only(data))
    page.raw(footfalls(data, *data.initial_plan, Design::initial, "Footfalls before"));
  page.raw(
      footfalls(data, plan, Design::result, motion_only(data) ? "Footfalls" : "Footfalls after"));
  if (data.comparison_of(
          Design::result)) {  // its charts show heights and forces, with what was measured
    page.close().close();
    return;
  }
  const PlotOptions heights{.title = "Planned height of the feet, after",
                            .x_label = "time [s]",
                            .y_label = "mm",
                            .y_from_zero = true};
  page.raw(foot_chart(plan, heights,
                      [&](int k, int f) { return 1e3 * plan.at(k, plan.foot_column(f, 2)); }));
  const PlotOptions forces{.title = "Planned normal forces, after",
                           .x_label = "time [s]",
                           .y_label = "N",
                           .y_from_zero = true};
  page.raw(
      foot_chart(plan, forces, [&](int k, int f) { return plan.at(k, plan.force_column(f, 2)); }));
  page.close().close();
}

}  // namespace legwright
