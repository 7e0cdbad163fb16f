// SPDX-License-Identifier: Apache-2.0
// Plan against simulation: speeds at all gains, foot contacts, heights and forces.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tools/report/sections.hpp"
#include "tools/report/svg_plot.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

/// The gains that were played, in the order of the file.
std::vector<std::string> gains_of(const RunData& data) {
  std::vector<std::string> gains;
  const Json& result = value_at(data.metrics, {"result"});
  if (!result.is_object()) return gains;
  for (const auto& [gain, measured] : result.items()) {
    if (measured.is_object()) gains.push_back(gain);
  }
  return gains;
}

struct Quantity {
  const char* name;
  std::function<std::string(const Json&)> show;
  bool after_first_cycle = false;  // measured from the second cycle on
};

std::string scaled(std::optional<double> value, double by, const char* unit) {
  return value ? fmt::format("{}{}", short_number(*value * by), unit) : std::string("–");
}

std::string speed(const Json& measured, std::size_t axis) {
  const Json& velocity = value_at(measured, {"velocity_mps"});
  if (!velocity.is_array() || velocity.size() != 2 || !velocity[axis].is_number()) return "–";
  const double value = velocity[axis].get<double>();
  return fmt::format("{}{:.4f}", value < -5e-5 ? "−" : "", std::abs(value));
}

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> list = {
      {"speed forward [m/s]", [](const Json& m) { return speed(m, 0); }},
      {"speed to the left [m/s]", [](const Json& m) { return speed(m, 1); }},
      {"of the planned speed",
       [](const Json& m) { return percent(number_at(m, {"speed_ratio"})); }},
      {"of the speed that the plan reached",
       [](const Json& m) { return percent(number_at(m, {"plan_speed_ratio"})); }},
      {"falls",
       [](const Json& m) {
         const auto time = number_at(m, {"fall", "time_s"});
         if (time) return fmt::format("after {} s", short_number(time));
         return std::string(value_at(m, {"cycles"}).is_null() ? "–" : "no");
       }},
      {"largest tilt",
       [](const Json& m) {
         return scaled(number_at(m, {"tilt_max_rad"}), 57.29577951308232, "°");
       }},
      {"heading drift",
       [](const Json& m) {
         return scaled(number_at(m, {"heading_drift_rad"}), 57.29577951308232, "°");
       }},
      {"slip per stance, mean",
       [](const Json& m) {
         return scaled(number_at(m, {"feet_summary", "slip_mean_m"}), 1e3, " mm");
       },
       true},
      {"touchdown, mean",
       [](const Json& m) {
         return early_or_late(number_at(m, {"feet_summary", "touchdown_error_mean_s"}));
       },
       true},
      {"joint tracking, RMS",
       [](const Json& m) {
         return scaled(number_at(m, {"tracking_rms_rad"}), 57.29577951308232, "°");
       },
       true},
      {"servo torque, RMS",
       [](const Json& m) { return scaled(number_at(m, {"torque_rms_Nm"}), 1, " N·m"); }, true},
      {"servos at their limit",
       [](const Json& m) { return percent(number_at(m, {"saturated_share"})); }, true},
      {"MuJoCo warnings",
       [](const Json& m) {
         const Json& warnings = value_at(m, {"warnings"});
         return warnings.is_array() ? std::to_string(warnings.size()) : std::string("–");
       }},
  };
  return list;
}

/// What was measured of one body, a column for each gain. @param robot key of metrics.json
void add_gain_table(Html& page, const RunData& data, const std::vector<std::string>& gains,
                    const char* robot, const char* title) {
  page.open("div").element("h3", title).open("table", {{"class", "gains"}});
  page.open("thead").open("tr").element("th", "servo gains");
  for (const std::string& gain : gains) page.element("th", gain, {{"class", "n"}});
  page.close().close().open("tbody");
  for (const Quantity& quantity : quantities()) {
    std::vector<std::string> cells;
    for (const std::string& gain : gains) {
      const Json& measured = value_at(data.metrics, {robot, gain.c_str()});
      const bool too_short =
          quantity.after_first_cycle && number_at(measured, {"cycles"}).value_or(0.0) < 2.0;
      cells.push_back(too_short ? "–" : quantity.show(measured));
    }
    if (std::all_of(cells.begin(), cells.end(), [](const auto& cell) { return cell == "–"; }))
      continue;  // it fell before there was anything to measure
    page.open("tr").element("td", quantity.name);
    for (const std::string& cell : cells) page.element("td", cell, {{"class", "n"}});
    page.close();
  }
  page.close().close().close();
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

std::vector<std::pair<double, double>> measured_contacts(const RunData& data, const char* robot,
                                                         const std::string& name) {
  std::vector<std::pair<double, double>> out;
  const Json& feet = value_at(data.metrics, {robot, "default", "feet"});
  if (!feet.is_array()) return out;
  for (const Json& foot : feet) {
    if (text_at(foot, {"name"}) != name) continue;
    const Json& contacts = value_at(foot, {"contacts_s"});
    if (!contacts.is_array()) continue;
    for (const Json& span : contacts) {
      if (span.is_array() && span.size() == 2 && span[0].is_number() && span[1].is_number()) {
        out.emplace_back(span[0].get<double>(), span[1].get<double>());
      }
    }
  }
  return out;
}

std::string footfalls(const RunData& data, const Trajectory& plan, const char* robot,
                      const std::string& title) {
  const double end = std::min(4.0, 3.0 * plan.period);
  std::vector<FootfallRow> rows;
  for (int f = 0; f < plan.foot_count(); ++f) {
    const std::string& name = plan.foot_names[static_cast<std::size_t>(f)];
    rows.push_back({name, planned_stances(plan, f, end), measured_contacts(data, robot, name)});
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
  const auto gains = gains_of(data);
  if (gains.empty()) {
    add_hint(page, "The gaits have not been played in MuJoCo yet.", "validate", data);
    page.close();
    return;
  }
  const auto cycles = number_at(data.metrics, {"cycles"});
  page.element("p",
               fmt::format("{} cycles in MuJoCo. Servo gains say how hard the joints hold on to "
                           "their planned angles: a sound gait does not depend on them.",
                           short_number(cycles)),
               {{"class", "note"}});
  page.open("div", {{"class", "charts"}});
  add_gain_table(page, data, gains, "result", motion_only(data) ? "Measured" : "After");
  if (!motion_only(data)) add_gain_table(page, data, gains, "initial", "Before");
  page.close().close();
}

void add_plan(Html& page, const RunData& data) {
  page.open("section").element("h2", "Footfalls");
  if (!data.result_plan) {
    page.element(
            "p",
            "result/motion.csv is not there: the run has not ended, or its plan cannot be read.",
            {{"class", "note"}})
        .close();
    return;
  }
  const Trajectory& plan = *data.result_plan;
  page.open("div", {{"class", "charts"}});
  if (data.initial_plan && !motion_only(data))
    page.raw(footfalls(data, *data.initial_plan, "initial", "Footfalls before"));
  page.raw(footfalls(data, plan, "result", motion_only(data) ? "Footfalls" : "Footfalls after"));
  if (data.compared_result) {  // its charts show heights and forces, with what was measured
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
