// SPDX-License-Identifier: Apache-2.0
#include "tools/choose/tightened_search.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "mjcf/text/input_error.hpp"

namespace legwright {

std::optional<Candidate> search_tightened(const CodesignProblem& problem,
                                          const std::vector<JointTask>& tasks,
                                          const Candidate& from,
                                          const std::vector<Tightening>& tightening,
                                          const DesignSpace& space,
                                          const CodesignOptions& options) {
  Candidate out;
  out.tightening = tightening;
  std::vector<std::shared_ptr<const Objective>> objectives;  // as long as the search goes on
  std::vector<std::unique_ptr<ObjectiveCost>> costs;
  std::vector<WeightedCost> weighted_costs;
  try {
    for (int k = 0; k < problem.task_count(); ++k) {
      const auto i = static_cast<std::size_t>(k);
      const Task task = tightened_task(problem, k, tightening[i]);
      out.planned.push_back(std::make_shared<const PlannedObjective>(
          as_in_task(problem.robot.morphology, task), problem.robot.space, task));
      objectives.push_back(out.planned.back()->get());
      costs.push_back(std::make_unique<ObjectiveCost>(*objectives.back()));
      weighted_costs.push_back(weighted(tasks[i], tasks[i].weight, from.design.tasks[i].m));
      weighted_costs.back().cost = costs.back().get();
    }
  } catch (const InputError&) {
    return std::nullopt;  // out of reach, or no knot left for a swing
  }
  CodesignResult result = codesign(weighted_costs, space, from.design.s, options);
  if (!std::isfinite(result.best.value)) return std::nullopt;
  out.design = std::move(result.best);
  evaluate_as_asked(problem, out);
  return out;
}

std::vector<Tightening> pulled(const Candidate& candidate, const PlayedCandidate& played,
                               Lever lever) {
  std::vector<Tightening> out = candidate.tightening;
  out.resize(played.trials.size());
  for (std::size_t k = 0; k < out.size(); ++k)
    if (!played.trials[k].pass) out[k] = out[k].with(lever, played.trials[k]);
  return out;
}

bool alike(const std::vector<Tightening>& a, const std::vector<Tightening>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Tightening& x, const Tightening& y) { return x.pulls == y.pulls; });
}

std::vector<Lever> all_levers() {
  std::vector<Lever> out;
  out.reserve(kLeverCount);
  for (int lever = 0; lever < kLeverCount; ++lever) out.push_back(static_cast<Lever>(lever));
  return out;
}

}  // namespace legwright
