// SPDX-License-Identifier: Apache-2.0
// The mean measured cycle against the plan: contact forces foot by foot, trunk, path, joints, timing.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/report/sections.hpp"
#include "tools/report/svg_plot.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

constexpr const char* kPhaseLabel = "share of the cycle";
constexpr const char* kOverCycle = "over the share of the cycle";
constexpr std::pair<double, double> kCycle{0.0, 1.0};
constexpr double kWorthTelling = 0.05;  // of the worst: closer to the mean it says nothing new

std::vector<double> scaled(std::vector<double> values, double by) {
  for (double& value : values) value *= by;
  return values;
}

/// Band, mean and plan as lines of a chart. @param feet with a plan that is zero elsewhere: none
std::vector<PlotSeries> lines_of(const std::vector<double>& phases, const Band& band, double scale,
                                 const char* planned_name = "planned") {
  std::vector<PlotSeries> lines;
  if (!band.low.empty() && !band.high.empty()) {
    PlotSeries area;
    area.name = "least … most measured";
    area.x = phases;
    area.low = scaled(band.low, scale);
    area.high = scaled(band.high, scale);
    lines.push_back(std::move(area));
  }
  if (!band.mean.empty()) {
    PlotSeries mean;
    mean.name = "measured, mean";
    mean.x = phases;
    mean.y = scaled(band.mean, scale);
    lines.push_back(std::move(mean));
  }
  if (!band.planned.empty()) {
    PlotSeries plan;
    plan.name = planned_name;
    plan.colour = 2;
    plan.dashed = true;
    plan.x = phases;
    plan.y = scaled(band.planned, scale);
    lines.push_back(std::move(plan));
  }
  return lines;
}

double largest(const Band& band) {
  double most = 0.0;
  for (const std::vector<double>* values : {&band.planned, &band.mean, &band.low, &band.high})
    for (const double value : *values)
      if (std::isfinite(value)) most = std::max(most, std::abs(value));
  return most;
}

/// One small chart for each foot.
std::string foot_panels(const ComparisonView& compared, Band ComparedFoot::*quantity,
                        const std::string& title, const std::string& si_unit) {
  double most = 0.0;
  for (const ComparedFoot& foot : compared.feet) most = std::max(most, largest(foot.*quantity));
  const ShownUnit unit = shown_unit(si_unit, most);
  std::vector<PlotPanel> panels;
  for (const ComparedFoot& foot : compared.feet)
    panels.push_back({foot.name, lines_of(compared.phases, foot.*quantity, unit.scale)});
  return small_multiples(panels,
                         {.title = title,
                          .y_label = unit.name.empty() ? kOverCycle : unit.name + ", " + kOverCycle,
                          .y_from_zero = true,
                          .x_span = kCycle,
                          .width = 220,
                          .height = 150});
}

std::string joint_panels(const ComparisonView& compared) {
  std::vector<PlotPanel> panels;
  for (const ComparedJoint& joint : compared.joints) {
    std::vector<PlotSeries> lines = lines_of(compared.phases, joint.torque, 1.0, "feed-forward");
    for (const double sign : {1.0, -1.0}) {
      const double most = largest(joint.torque);
      if (!joint.limit || *joint.limit <= 0.0 || most < 0.5 * *joint.limit) continue;  // far away
      PlotSeries level;
      level.name = sign > 0.0 ? "limit" : "";
      level.colour = 0;
      level.x = {compared.phases.front(), compared.phases.back()};
      level.y.assign(2, sign * *joint.limit);
      lines.push_back(std::move(level));
    }
    std::string title = spaced(joint.name);
    if (joint.limit)
      title += fmt::format(" · {} of {} N·m", short_number(largest(joint.torque)),
                           short_number(joint.limit));
    panels.push_back({title, std::move(lines)});
  }
  return small_multiples(panels, {.title = "Torque of each servo",
                                  .y_label = "N·m; largest and limit beside each name",
                                  .x_span = kCycle,
                                  .width = 220,
                                  .height = 140});
}

std::string curve_chart(const ComparisonView& compared, const ComparedCurve& curve) {
  const ShownUnit unit = shown_unit(curve.unit, largest(curve.band));
  std::string title = curve.label.empty() ? spaced(curve.name) : curve.label;
  if (!title.empty() && title.front() >= 'a' && title.front() <= 'z')
    title.front() = static_cast<char>(title.front() - 'a' + 'A');
  // What hardly moves is drawn as such: half a degree, two millimetres.
  const double least = curve.unit == "rad" ? 1.0 : curve.unit == "m" ? 0.004 * unit.scale : 0.01;
  return line_plot(lines_of(compared.phases, curve.band, unit.scale), {.title = title,
                                                                       .x_label = kPhaseLabel,
                                                                       .y_label = unit.name,
                                                                       .least_height = least,
                                                                       .height = 220});
}

/// Whether a curve belongs to those that everybody wants to see.
bool for_everybody(const ComparedCurve& curve) {
  static constexpr const char* kFirst[] = {"com_height", "speed", "heading", "roll", "pitch"};
  return std::any_of(std::begin(kFirst), std::end(kFirst), [&](const char* name) {
    return std::string_view(curve.name).starts_with(name);
  });
}

std::string path_chart(const ComparisonView& compared) {
  PlotSeries planned, measured;
  planned.name = "planned";
  planned.colour = 2;
  planned.dashed = true;
  planned.x = compared.planned_x;
  planned.y = compared.planned_y;
  measured.name = "measured";
  measured.x = compared.measured_x;
  measured.y = compared.measured_y;
  return line_plot({measured, planned}, {.title = "Path of the robot from above",
                                         .x_label = "forward [m]",
                                         .y_label = "to the left [m]",
                                         .equal_axes = true});
}

/// The mean, and the worst below it. @param timed whether it is an error in time, whose worst has no direction
void add_mean_worst(Html& page, const MeanWorst& value, const char* unit, const char* head,
                    bool timed) {
  const double most =
      std::max(std::abs(value.mean.value_or(0.0)), std::abs(value.worst.value_or(0.0)));
  const ShownUnit shown = shown_unit(unit, most);
  page.open("td", {{"class", "n"}, {"data-label", head}})
      .text(timed ? early_or_late(value.mean) : shown.words(value.mean));
  const double apart =
      std::abs(std::abs(value.worst.value_or(0.0)) - std::abs(value.mean.value_or(0.0)));
  if (value.worst && apart > kWorthTelling * most)
    page.element("small",
                 timed ? fmt::format("at worst off by {}", shown.words(std::abs(*value.worst)))
                       : "worst " + shown.words(value.worst));
  if (value.planned) page.element("small", "planned " + shown.words(value.planned));
  page.close();
}

void add_timing(Html& page, const ComparisonView& compared) {
  struct Column {
    const char* head;
    MeanWorst ComparedFoot::*value;
    const char* unit;
    bool timed = false;
  };
  static constexpr Column kColumns[] = {{"touches down", &ComparedFoot::touchdown, "s", true},
                                        {"lifts off", &ComparedFoot::liftoff, "s", true},
                                        {"landing speed", &ComparedFoot::landing_speed, "m/s"},
                                        {"slip per stance", &ComparedFoot::slip, "m"},
                                        {"rolls by", &ComparedFoot::roll, "rad"}};
  if (compared.feet.empty()) return;
  page.element("h3", "When the feet land and leave, and how");
  page.open("table", {{"class", "stack feet"}}).open("thead").open("tr").element("th", "foot");
  for (const Column& column : kColumns) page.element("th", column.head, {{"class", "n"}});
  page.close().close().open("tbody");
  for (const ComparedFoot& foot : compared.feet) {
    page.open("tr").open("td", {{"class", "head"}}).element("b", foot.name).close();
    for (const Column& column : kColumns)
      add_mean_worst(page, foot.*column.value, column.unit, column.head, column.timed);
    page.close();
  }
  page.close().close();
  page.element("p",
               "Means over the strides, the worst stride and the plan below. A plan "
               "keeps its feet on the ground for a while before they bear and after, so that some "
               "30 ms early and late are as planned.",
               {{"class", "note"}});
}

void add_trunk(Html& page, const ComparisonView& compared) {
  std::string first, more;
  for (const ComparedCurve& curve : compared.curves)
    (for_everybody(curve) ? first : more) += curve_chart(compared, curve);
  if (!compared.measured_x.empty()) first += path_chart(compared);
  if (!first.empty()) {
    page.element("h3", "The body over the cycle");
    page.open("div", {{"class", "charts"}}).raw(first).close();
  }
  if (!more.empty()) {
    page.open("details").element("summary", "More of the body: sway, power, servos at their limit");
    page.open("div", {{"class", "charts"}}).raw(more).close().close();
  }
}

void add_experts(Html& page, const ComparisonView& compared) {
  page.open("details").element("summary", "More of the feet: friction, height, slip");
  page.raw(foot_panels(compared, &ComparedFoot::friction_used,
                       "Friction used: tangential over normal force", "1"));
  page.raw(foot_panels(compared, &ComparedFoot::force_tangential, "Tangential force", "N"));
  page.raw(foot_panels(compared, &ComparedFoot::height, "Height of the foot", "m"));
  page.raw(foot_panels(compared, &ComparedFoot::slip_speed, "Speed of slip on the ground", "m/s"));
  page.close();
  if (compared.joints.empty()) return;
  page.open("details").element("summary", "Torque, servo by servo");
  page.raw(joint_panels(compared)).close();
}

std::string cell(const Json& row, const char* key, double scale, const char* unit) {
  const auto value = number_at(row, {key});
  return value ? short_number(*value * scale) + unit : "–";
}

void add_cycles(Html& page, const ComparisonView& compared) {
  constexpr std::size_t kMost = 60;
  const Json& rows = compared.cycle_table;
  if (!rows.is_array() || rows.empty()) return;
  page.open("details").element("summary", "Cycle by cycle");
  page.open("div", {{"class", "scroll"}}).open("table").open("thead").open("tr");
  for (const char* head : {"cycle", "of planned speed", "heading", "largest tilt", "power",
                           "cost of transport", "servos at their limit"})
    page.element("th", head, {{"class", "n"}});
  page.close().close().open("tbody");
  for (std::size_t k = 0; k < std::min(rows.size(), kMost); ++k) {
    constexpr double kDegree = 57.29577951308232;
    const Json& row = rows[k];
    page.open("tr");
    for (const std::string& text :
         {cell(row, "cycle", 1, ""), percent(number_at(row, {"speed_ratio"})),
          cell(row, "heading_rad", kDegree, "°"), cell(row, "tilt_max_rad", kDegree, "°"),
          cell(row, "power_W", 1, " W"), cell(row, "cost_of_transport", 1, ""),
          percent(number_at(row, {"saturated_share"}))})
      page.element("td", text, {{"class", "n"}});
    page.close();
  }
  page.close().close().close().close();
}

void add_forces(Html& page, const ComparisonView& compared) {
  page.element("h3", "Contact forces, foot by foot");
  page.element("p",
               "What the ground pushes up with over one cycle. Where the measured line leaves the "
               "planned one, a foot carries what it was not meant to, lands late, or bounces.",
               {{"class", "note"}});
  page.raw(foot_panels(compared, &ComparedFoot::force_normal, "Normal force", "N"));
}

}  // namespace

std::string inverse_dynamics_words(const Json& plan) {
  const auto worst = number_at(plan, {"residual_force_share_max"}),
             rms = number_at(plan, {"residual_force_share_rms"}),
             turn = number_at(plan, {"residual_torque_share_max"}),
             used = number_at(plan, {"friction_used_max"}),
             friction = number_at(plan, {"friction_coefficient"}),
             least = number_at(plan, {"normal_force_min_N"}),
             share = number_at(plan, {"normal_force_min_share"});
  const auto at = [&](const char* foot, const char* phase) {
    const std::string name = text_at(plan, {foot});
    const auto when = number_at(plan, {phase});
    return (name.empty() ? "" : " at " + spaced(name)) +
           (when ? fmt::format(", at {} of the cycle", percent_whole(when)) : "");
  };
  std::string out;
  if (worst) {
    out += fmt::format("The planned forces and the planned motion agree to {} of the weight",
                       percent(worst));
    if (rms) out += fmt::format(" at worst, {} in the mean", percent(rms));
    if (turn)
      out += fmt::format(", and about the body’s axes to {} of weight × height", percent(turn));
    out += ". ";
  }
  if (used) {
    out += fmt::format("The plan uses {} of friction", short_number(used));
    if (friction) out += fmt::format(", where the floor gives {}", short_number(friction));
    out += " (most" + at("friction_worst_foot", "friction_worst_phase") + "). ";
  }
  if (least) {
    out += fmt::format("The least load of a foot that is meant to bear is {}",
                       amount_words(least, "N"));
    if (share) out += fmt::format(", {} of the weight", percent(share));
    out += at("normal_force_min_foot", "normal_force_min_phase") + ".";
  }
  return out;
}

void add_comparison(Html& page, const RunData& data, PictureBudget& budget) {
  page.open("section").element("h2", "Plan against physics");
  if (data.comparison.is_null()) {
    add_hint(page, "The measured cycle has not been compared with the plan yet.", "validate", data);
    page.close();
    return;
  }
  if (!data.compared_result) {
    page.element("p",
                 "The gait fell before two cycles were complete: there is no mean cycle to compare "
                 "with the plan.",
                 {{"class", "note"}});
  } else {
    const ComparisonView& compared = *data.compared_result;
    const std::string sound = inverse_dynamics_words(compared.inverse_dynamics);
    if (!sound.empty()) page.open("p").element("b", "Is the plan sound? ").text(sound).close();
    add_strip_if(page, data.root / "result" / "overlay.png", "Simulation and plan in one picture.",
                 "One late cycle; the plan is the ghost.", budget);
    add_forces(page, compared);
    add_timing(page, compared);
    add_trunk(page, compared);
    add_experts(page, compared);
    add_cycles(page, compared);
  }
  if (data.compared_initial) {
    page.open("details").element("summary", "Contact forces before, with the initial body");
    const std::string sound = inverse_dynamics_words(data.compared_initial->inverse_dynamics);
    if (!sound.empty()) page.element("p", sound);
    page.raw(foot_panels(*data.compared_initial, &ComparedFoot::force_normal, "Normal force", "N"));
    page.close();
  }
  page.close();
}

}  // namespace legwright
