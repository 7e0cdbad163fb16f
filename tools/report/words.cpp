// SPDX-License-Identifier: Apache-2.0
#include "tools/report/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "optimizer/motion/faced_frame.hpp"
#include "optimizer/terms/registry.hpp"
#include "tools/report/number_words.hpp"

namespace legwright {
std::string spaced(std::string_view name) {
  std::string out(name);
  std::replace(out.begin(), out.end(), '_', ' ');
  return out;
}

std::string named_if_few(const std::vector<std::string>& names) {
  constexpr std::size_t kMostNamed = 6;
  std::string out;
  if (names.size() > kMostNamed) return out;
  for (std::size_t k = 0; k < names.size(); ++k)
    out += (k == 0 ? ": " : k + 1 < names.size() ? ", " : " and ") + spaced(names[k]);
  return out;
}

std::string term_words(const std::string& name) {
  const TermEntry* term = find_term(name);
  return term != nullptr ? std::string(term->label) : spaced(name);
}

std::string cost_words(const std::string& name) {
  const TermEntry* term = find_term(name);
  return term != nullptr ? std::string(term->cost_label) : spaced(name);
}

std::string task_words(const RunRecord& run) { return run.task ? way_words(*run.task) : ""; }

namespace {

/// ", up a slope of 8°, carrying 0.5 kg", …
std::string demand_words(const TaskRecord& task) {
  std::string out;
  const SlopeRecord slope = task.slope.value_or(SlopeRecord{});
  if (slope.along != 0.0)
    out += fmt::format(", {} a slope of {}", slope.along > 0.0 ? "up" : "down",
                       quantity_words(std::abs(slope.along), "rad"));
  if (slope.across != 0.0)
    out += fmt::format(", across a slope of {}", quantity_words(std::abs(slope.across), "rad"));
  if (task.payload) out += fmt::format(", carrying {} kg", short_number(task.payload->mass));
  if (task.step_over) out += ", stepping over " + quantity_words(*task.step_over, "m");
  if (task.torque_limit) out += ", with motors of " + quantity_words(*task.torque_limit, "N m");
  if (task.servo_kp)
    out += fmt::format(", servos as stiff as {} N m/rad or as their torque limits bear",
                       short_number(task.servo_kp));
  if (task.dynamics) out += ", planned with constant inertia";
  return out;
}

}  // namespace

std::string way_words(const TaskRecord& task) {
  std::string out = task.gait;
  const auto part = [&](double speed, const char* ahead, const char* back) {
    if (speed != 0.0)
      out += fmt::format("{}{} m/s {}", out.empty() ? "" : ", ", short_number(std::abs(speed)),
                         speed > 0 ? ahead : back);
  };
  const Eigen::Vector2d velocity = as_faced({task.velocity[0], task.velocity[1]}, task.facing());
  part(velocity.x(), "forward", "backward");
  part(velocity.y(), "to the left", "to the right");
  if (task.turn_rate != 0.0) out += fmt::format(", turning {} rad/s", short_number(task.turn_rate));
  return out + demand_words(task) + fmt::format(", {} s per cycle", short_number(task.period));
}

std::string result_words(const RunRecord& run) {
  if (!run.body_kept()) return "body and gait co-designed";
  return run.tightened() ? "the same body, its gait tightened" : "the same body and gait";
}

}  // namespace legwright
