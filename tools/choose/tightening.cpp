// SPDX-License-Identifier: Apache-2.0
#include "tools/choose/tightening.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mjcf/text/input_error.hpp"
#include "optimizer/motion/initial_guess.hpp"
#include "optimizer/terms/registry.hpp"

namespace legwright {
namespace {

// What one pull does, found on the examples without their weights and margins.
constexpr double kMarginFactor = 1.5, kForceFactor = 14.0, kQuickFactor = 0.4, kSmoothFactor = 2.0,
                 kSwingFactor = 0.8, kWidthFactor = 0.85, kTetherFactor = 8.0;
constexpr double kLeastAim = 0.85;  // of the wanted speed, and over it by as much

constexpr std::array<const char*, kLeverCount> kWords = {
    "larger margins", "smoother forces", "quicker legs",         "smoother legs",
    "longer stance",  "shorter stance",  "lower steps",          "narrower stance",
    "wider stance",   "corrected aim",   "nearer the given body"};

int pulls_of(const Tightening& tightening, Lever lever) {
  return tightening.pulls.at(static_cast<std::size_t>(lever));
}

void multiply_weight(TaskFile& file, const std::string& term, double factor) {
  const auto given = file.weights.find(term);
  const double weight =
      given != file.weights.end() ? given->second : find_term(term)->default_weight;
  file.weights[term] = weight * factor;
}

/// Plans another speed and turn. What was turned by too little is known by itself: a plan that goes
/// faster does not turn faster for it. On a slope, where plans do not turn, the speed alone.
void aim(const Tightening& tightening, TaskFile& file) {
  const double before = file.aim_speed;
  file.aim_speed *= tightening.speed;
  if (file.slope_along != 0.0 || file.slope_across != 0.0) return;
  file.aim_turn_rate += tightening.turn / file.period - (file.aim_speed - before) * file.turn_rate;
}

void widen_margins(Task& task, double factor) {
  task.torque_margin = 1.0 - (1.0 - task.torque_margin) / std::sqrt(factor);
  task.min_normal *= factor;
  task.friction /= std::sqrt(factor);
}

}  // namespace

bool Tightening::any() const {
  return std::any_of(pulls.begin(), pulls.end(), [](int times) { return times > 0; });
}

Tightening Tightening::with(Lever lever, const GaitTrial& seen) const {
  Tightening out = *this;
  ++out.pulls.at(static_cast<std::size_t>(lever));
  if (lever == Lever::aim) {
    out.speed = std::clamp(speed / std::clamp(seen.speed_ratio, kLeastAim, 1.0 / kLeastAim),
                           kLeastAim, 1.0 / kLeastAim);
    out.turn = turn - seen.heading_drift;
  }
  return out;
}

std::string Tightening::words() const {
  std::string text;
  for (std::size_t i = 0; i < pulls.size(); ++i)
    if (pulls[i] > 0)
      text += fmt::format("{}{}{}", text.empty() ? "" : ", ", kWords[i],
                          pulls[i] > 1 ? fmt::format(" x{}", pulls[i]) : "");
  return text;
}

TaskFile tightened_file(const CodesignProblem& problem, int k, const Tightening& tightening) {
  TaskFile file = problem.task(k);
  const Task& asked = problem.objectives[static_cast<std::size_t>(k)]->task();
  const auto pulls = [&](Lever lever) { return pulls_of(tightening, lever); };
  const auto power = [&](double factor, Lever lever) { return std::pow(factor, pulls(lever)); };

  file.margins = asked;
  widen_margins(file.margins, power(kMarginFactor, Lever::margins));
  const int stance = asked.planted_margin + pulls(Lever::long_stance) - pulls(Lever::short_stance);
  if (stance < 1) throw InputError("stance cannot be shorter");
  file.planted_margin = stance * asked.gait.time_step();
  *file.margins.swing_height *= power(kSwingFactor, Lever::low_swing);
  multiply_weight(file, "force_smoothness", power(kForceFactor, Lever::smooth_forces));
  multiply_weight(
      file, "smoothness",
      power(kQuickFactor, Lever::quick_legs) * power(kSmoothFactor, Lever::smooth_legs));
  multiply_weight(file, "design_tether", power(kTetherFactor, Lever::near_given_body));
  aim(tightening, file);
  file.stance_width *= power(kWidthFactor, Lever::narrow) / power(kWidthFactor, Lever::wide);
  return file;
}

Task tightened_task(const CodesignProblem& problem, int k, const Tightening& tightening) {
  return make_task(tightened_file(problem, k, tightening), problem.robot);
}

}  // namespace legwright
