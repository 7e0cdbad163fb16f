// SPDX-License-Identifier: Apache-2.0
// The mean measured cycle against the plan: contact forces foot by foot, trunk, path, joints,
// timing.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/report/judged_words.hpp"
#include "tools/report/number_words.hpp"
#include "tools/report/page_template.hpp"
#include "tools/report/sections.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

constexpr const char* kPhaseLabel = "share of the cycle";
constexpr const char* kOverCycle = "over the share of the cycle";
constexpr std::pair<double, double> kCycle{0.0, 1.0};
constexpr double kWorthTelling = 0.05;  // of the worst: closer to the mean it says nothing new

std::vector<double> list_of(const Eigen::VectorXd& values, double scale = 1.0) {
  const Eigen::VectorXd scaled = scale * values;
  return {scaled.begin(), scaled.end()};
}

/// Band, mean and plan as lines of a chart.
std::vector<PlotSeries> lines_of(const Eigen::VectorXd& phases, const Curve& curve, double scale,
                                 const char* planned_name = "planned") {
  const std::vector<double> x = list_of(phases);
  std::vector<PlotSeries> lines{
      {.name = "least … most measured",
       .x = x,
       .low = list_of(curve.low, scale),
       .high = list_of(curve.high, scale)},
      {.name = "measured, mean", .x = x, .y = list_of(curve.mean, scale)}};
  if (curve.planned)
    lines.push_back({.name = planned_name,
                     .x = x,
                     .y = list_of(*curve.planned, scale),
                     .colour = 2,
                     .dashed = true});
  return lines;
}

double largest(const Curve& curve) {
  double most = 0.0;
  const auto look = [&](const Eigen::VectorXd& values) {
    for (const double value : values)
      if (std::isfinite(value)) most = std::max(most, std::abs(value));
  };
  if (curve.planned) look(*curve.planned);
  for (const Eigen::VectorXd* values : {&curve.mean, &curve.low, &curve.high}) look(*values);
  return most;
}

/// One small chart for each foot.
std::string foot_panels(const Comparison& compared, Curve FootComparison::*quantity,
                        const std::string& title, const std::string& si_unit) {
  double most = 0.0;
  for (const FootComparison& foot : compared.feet) most = std::max(most, largest(foot.*quantity));
  const ShownUnit unit = shown_unit(si_unit, most);
  std::vector<PlotPanel> panels;
  for (const FootComparison& foot : compared.feet)
    panels.push_back({foot.name, lines_of(compared.phases, foot.*quantity, unit.scale)});
  return small_multiples(panels,
                         {.title = title,
                          .y_label = unit.name.empty() ? kOverCycle : unit.name + ", " + kOverCycle,
                          .y_from_zero = true,
                          .x_span = kCycle,
                          .width = 220,
                          .height = 150});
}

std::string joint_panels(const Comparison& compared) {
  std::vector<PlotPanel> panels;
  for (const JointComparison& joint : compared.joints) {
    std::vector<PlotSeries> lines = lines_of(compared.phases, joint.torque, 1.0, "feed-forward");
    for (const double sign : {1.0, -1.0}) {
      const double most = largest(joint.torque);
      const double limit = joint.torque_limit;
      if (!std::isfinite(limit) || limit <= 0.0 || most < 0.5 * limit) continue;  // far away
      PlotSeries level;
      level.name = sign > 0.0 ? "limit" : "";
      level.colour = 0;
      level.x = {compared.phases[0], compared.phases[compared.phases.size() - 1]};
      level.y.assign(2, sign * limit);
      lines.push_back(std::move(level));
    }
    std::string title = spaced(joint.name);
    if (std::isfinite(joint.torque_limit))
      title += fmt::format(" · {} of {} N·m", short_number(largest(joint.torque)),
                           short_number(joint.torque_limit));
    panels.push_back({title, std::move(lines)});
  }
  return small_multiples(panels, {.title = "Torque of each servo",
                                  .y_label = "N·m; largest and limit beside each name",
                                  .x_span = kCycle,
                                  .width = 220,
                                  .height = 140});
}

std::string curve_chart(const Comparison& compared, const NamedCurve& curve) {
  const ShownUnit unit = shown_unit(curve.unit, largest(curve.curve));
  std::string title = label_of(curve);
  if (!title.empty() && title.front() >= 'a' && title.front() <= 'z')
    title.front() = static_cast<char>(title.front() - 'a' + 'A');
  // What hardly moves is drawn as such: half a degree, two millimetres.
  const double least = curve.unit == "rad" ? 1.0 : curve.unit == "m" ? 0.004 * unit.scale : 0.01;
  return line_plot(lines_of(compared.phases, curve.curve, unit.scale), {.title = title,
                                                                        .x_label = kPhaseLabel,
                                                                        .y_label = unit.name,
                                                                        .least_height = least,
                                                                        .height = 220});
}

/// Whether a curve belongs to those that everybody wants to see.
bool for_everybody(const NamedCurve& curve) {
  static constexpr const char* kFirst[] = {"com_height", "speed", "heading", "roll", "pitch"};
  return std::any_of(std::begin(kFirst), std::end(kFirst), [&](const char* name) {
    return std::string_view(curve.name).starts_with(name);
  });
}

/// A path thinned out to what a chart can show.
PlotSeries path_line(const char* name, const std::vector<Eigen::Vector2d>& path) {
  constexpr std::size_t kMostDrawn = 400;
  PlotSeries line{.name = name};
  const auto add = [&](const Eigen::Vector2d& point) {
    line.x.push_back(point.x());
    line.y.push_back(point.y());
  };
  const std::size_t stride = path.size() / kMostDrawn + 1;
  for (std::size_t i = 0; i < path.size(); i += stride) add(path[i]);
  if (path.size() > 1 && (path.size() - 1) % stride != 0) add(path.back());
  return line;
}

std::string path_chart(const Comparison& compared) {
  PlotSeries planned = path_line("planned", compared.paths.planned),
             measured = path_line("measured", compared.paths.measured);
  planned.colour = 2;
  planned.dashed = true;
  return line_plot({measured, planned}, {.title = "Path of the robot from above",
                                         .x_label = "forward [m]",
                                         .y_label = "to the left [m]",
                                         .equal_axes = true});
}

struct FootColumn {
  const char* head;
  MeanAndWorst FootComparison::*value;
  const char* unit;
  bool timed = false;  // an error in time, whose worst has no direction
};
constexpr FootColumn kFootColumns[] = {{"touches down", &FootComparison::touchdown, "s", true},
                                       {"lifts off", &FootComparison::liftoff, "s", true},
                                       {"landing speed", &FootComparison::landing_speed, "m/s"},
                                       {"slip per stance", &FootComparison::slip, "m"},
                                       {"rolls by", &FootComparison::roll, "rad"}};

/// The mean, and the worst and the plan below it.
std::string mean_worst_html(const MeanAndWorst& value, const FootColumn& column) {
  const auto mean = finite(value.mean), worst = finite(value.worst);
  const double most = std::max(std::abs(mean.value_or(0.0)), std::abs(worst.value_or(0.0)));
  const ShownUnit shown = shown_unit(column.unit, most);
  const double apart = std::abs(std::abs(worst.value_or(0.0)) - std::abs(mean.value_or(0.0)));
  std::string more;
  if (worst && apart > kWorthTelling * most)
    more +=
        small_html(column.timed ? fmt::format("at worst off by {}", shown.words(std::abs(*worst)))
                                : "worst " + shown.words(worst));
  if (value.planned) more += small_html("planned " + shown.words(value.planned));
  return fill(R"(<td class="n" data-label="{head}">{mean}{more}</td>)",
              {{"head", column.head},
               {"mean", column.timed ? early_or_late(mean) : shown.words(mean)},
               Hole::markup("more", more)});
}

std::string foot_html(const FootComparison& foot) {
  return fill(
      "<tr><td class=\"head\"><b>{name}</b></td>\n{cells}</tr>\n",
      {{"name", foot.name}, Hole::markup("cells", each(kFootColumns, [&](const FootColumn& column) {
                                           return mean_worst_html(foot.*column.value, column);
                                         }))});
}

void add_timing(Html& page, const Comparison& compared) {
  if (compared.feet.empty()) return;
  page.raw(fill(
      R"(<h3>When the feet land and leave, and how</h3>
<table class="stack feet"><thead><tr><th>foot</th>{heads}</tr></thead><tbody>
{rows}</tbody></table>
<p class="note">Means over the strides, the worst stride and the plan below. A plan keeps its feet on the ground for
a while before they bear and after (<code>planted_margin</code> of the task), so that early and late
by less than that are as planned.</p>
)",
      {Hole::markup("heads",
                    each(kFootColumns,
                         [](const FootColumn& column) { return number_head_html(column.head); })),
       Hole::markup("rows", each(compared.feet, foot_html))}));
}

void add_trunk(Html& page, const Comparison& compared) {
  std::string first, more;
  for (const NamedCurve& curve : compared.curves)
    (for_everybody(curve) ? first : more) += curve_chart(compared, curve);
  if (!compared.paths.measured.empty()) first += path_chart(compared);
  if (!first.empty()) {
    page.element("h3", "The body over the cycle");
    page.open("div", {{"class", "charts"}}).raw(first).close();
  }
  if (!more.empty()) {
    page.open("details").element("summary", "More of the body: sway, power, servos at their limit");
    page.open("div", {{"class", "charts"}}).raw(more).close().close();
  }
}

void add_experts(Html& page, const Comparison& compared) {
  page.open("details").element("summary", "More of the feet: friction, height, slip");
  page.raw(foot_panels(compared, &FootComparison::friction,
                       "Friction used: tangential over normal force", "1"));
  page.raw(foot_panels(compared, &FootComparison::tangential, "Tangential force", "N"));
  page.raw(foot_panels(compared, &FootComparison::height, "Height of the foot", "m"));
  page.raw(
      foot_panels(compared, &FootComparison::slip_speed, "Speed of slip on the ground", "m/s"));
  page.close();
  if (compared.joints.empty()) return;
  page.open("details").element("summary", "Torque, servo by servo");
  page.raw(joint_panels(compared)).close();
}

std::string cycle_html(const CycleComparison& cycle) {
  return fill(
      R"(<tr><td class="n">{cycle}</td><td class="n">{speed}</td><td class="n">{heading}</td>
<td class="n">{tilt}</td><td class="n">{power}</td><td class="n">{transport}</td><td class="n">{limit}</td></tr>
)",
      {{"cycle", std::to_string(cycle.cycle)},
       {"speed", percent(cycle.speed_ratio)},
       {"heading", scaled(cycle.heading, kDegrees, "°")},
       {"tilt", scaled(cycle.tilt_max, kDegrees, "°")},
       {"power", scaled(cycle.power, 1, " W")},
       {"transport", scaled(cycle.cost_of_transport, 1, "")},
       {"limit", percent(finite(cycle.saturated_share))}});
}

void add_cycles(Html& page, const Comparison& compared) {
  constexpr std::size_t kMost = 60;
  std::vector<CycleComparison> rows = compared.cycle_table;
  if (rows.empty()) return;
  if (rows.size() > kMost) rows.resize(kMost);
  page.raw(fill(R"(<details><summary>Cycle by cycle</summary>
<div class="scroll"><table><thead><tr><th class="n">cycle</th><th class="n">of planned speed</th>
<th class="n">heading</th><th class="n">largest tilt</th><th class="n">power</th>
<th class="n">cost of transport</th><th class="n">servos at their limit</th></tr></thead><tbody>
{rows}</tbody></table></div></details>
)",
                {Hole::markup("rows", each(rows, cycle_html))}));
}

void add_forces(Html& page, const Comparison& compared) {
  page.element("h3", "Contact forces, foot by foot");
  page.note(
      "What the ground pushes up with over one cycle. Where the measured line leaves the "
      "planned one, a foot carries what it was not meant to, lands late, or bounces.");
  page.raw(foot_panels(compared, &FootComparison::normal, "Normal force", "N"));
}

}  // namespace

void add_comparison(Html& page, const RunData& data, PictureBudget& budget) {
  page.open("section").element("h2", "Plan against physics");
  if (!data.comparison) {
    add_hint(page, "The measured cycle has not been compared with the plan yet.", "validate", data);
    page.close();
    return;
  }
  const Comparison *result = data.comparison_of(Design::result),
                   *initial = data.comparison_of(Design::initial);
  if (result == nullptr) {
    page.note(
        "The gait fell before two cycles were complete: there is no mean cycle to compare "
        "with the plan.");
  } else {
    const Comparison& compared = *result;
    page.raw(fill("<p><b>Is the plan sound? </b>{words}</p>\n",
                  {{"words", inverse_dynamics_words(compared.inverse_dynamics)}}));
    add_strip_if(page, data, "result/overlay.png", "Simulation and plan in one picture.",
                 "One late cycle; the plan is the ghost.", budget);
    add_forces(page, compared);
    add_timing(page, compared);
    add_trunk(page, compared);
    add_experts(page, compared);
    add_cycles(page, compared);
  }
  if (initial != nullptr)
    page.raw(fill(R"(<details><summary>Contact forces before, with the initial body</summary>
<p>{words}</p>
{forces}</details>
)",
                  {{"words", inverse_dynamics_words(initial->inverse_dynamics)},
                   Hole::markup("forces", foot_panels(*initial, &FootComparison::normal,
                                                      "Normal force", "N"))}));
  page.close();
}

}  // namespace legwright
