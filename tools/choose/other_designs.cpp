// SPDX-License-Identifier: Apache-2.0
#include "tools/choose/other_designs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace legwright {
namespace {

constexpr int kIteratesPlayed = 6;  // along the way, evenly by number
constexpr double kAnother = 1.01;   // × F of the optimum: another start's end with more is another

Candidate end_of(const StartedRun& run) {
  return {"from " + run.label.start, run.result.best, {}, {}};
}

}  // namespace

std::vector<Candidate> further_candidates(const MultistartResult& found,
                                          const std::vector<DesignIteration>& along) {
  std::vector<Candidate> out;
  for (std::size_t i = 0; i < found.joint.size(); ++i)
    if (static_cast<int>(i) != found.best) out.push_back(end_of(found.joint[i]));
  const std::size_t step = std::max<std::size_t>(1, along.size() / kIteratesPlayed);
  for (std::size_t i = step; i + 1 < along.size(); i += step)
    out.push_back({fmt::format("iteration {}", i), along[i], {}, {}});
  std::erase_if(out, [](const Candidate& candidate) {
    return !std::isfinite(candidate.design.value) || candidate.design.tasks.empty();
  });
  std::stable_sort(out.begin(), out.end(), [](const Candidate& a, const Candidate& b) {
    return a.design.value < b.design.value;
  });
  return out;
}

std::optional<Candidate> other_optimum(const MultistartResult& found, double dear) {
  const double best = found.winner().best.value;
  const StartedRun* least = nullptr;
  for (std::size_t i = 0; i < found.joint.size(); ++i) {
    const StartedRun& run = found.joint[i];
    const double value = run.result.best.value;
    if (static_cast<int>(i) == found.best || run.result.best.tasks.empty() ||
        !(value > kAnother * best && value < dear * best))
      continue;
    if (least == nullptr || value < least->result.best.value) least = &run;
  }
  if (least == nullptr) return std::nullopt;
  return end_of(*least);
}

}  // namespace legwright
