// SPDX-License-Identifier: Apache-2.0
#include "tools/report/gap_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/report/judged_words.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

constexpr std::size_t kMostScalars = 12;
constexpr double kUnchanged = 5e-5;  // a factor this close to 1 would be shown as 1

/// "speed × 1.012, swing height × 1.05"
std::string factors_words(const ByName<double>& scalars) {
  std::string out;
  std::size_t shown = 0;
  for (const auto& [name, factor] : scalars) {
    if (!std::isfinite(factor) || std::abs(factor - 1.0) < kUnchanged) continue;
    if (shown++ == kMostScalars) return out + ", …";
    out += fmt::format("{}{} × {:.4g}", out.empty() ? "" : ", ", spaced(name), factor);
  }
  return out;
}

GapSide side_of(const PlayedGait& gait) {
  GapSide out{gait.pass, verdict_details(gait.line)};
  if (out.words.empty()) out.words = "not told";
  return out;
}

}  // namespace

std::optional<GapView> gap_of(const RunRecord& run) {
  if (!run.physics_steps) return std::nullopt;
  const PhysicsStepsRecord& found = *run.physics_steps;
  GapView gap{found.changed,        factors_words(found.scalars), side_of(found.before),
              side_of(found.after), found.steps.size(),           0};
  if (gap.factors.empty()) gap.factors = "by how much is not told";
  for (const PhysicsStepRecord& step : found.steps) gap.confirmed += step.accepted ? 1 : 0;
  return gap;
}

bool gait_was_stepped(const TaskRecord& task) {
  return task.physics_steps && task.physics_steps->changed;
}

bool gait_was_stepped(const RunRecord& run) {
  if (run.physics_steps && run.physics_steps->changed) return true;
  return run.tasks && std::any_of(run.tasks->begin(), run.tasks->end(),
                                  [](const TaskRecord& task) { return gait_was_stepped(task); });
}

}  // namespace legwright
