// SPDX-License-Identifier: Apache-2.0
#include "tools/choose/cheapest_stable.hpp"

#include <algorithm>

namespace legwright {
namespace {

constexpr double kAlmostAsCheap = 1.1;  // × F of the best that passes: stability decides

}  // namespace

std::optional<std::size_t> cheapest_stable(const std::vector<PlayedCost>& played, double least,
                                           const std::function<double(std::size_t)>& multiplier) {
  std::vector<std::size_t> rivals;
  for (std::size_t i = 0; i < played.size(); ++i)
    if (played[i].pass && played[i].F <= kAlmostAsCheap * least) rivals.push_back(i);
  if (rivals.size() < 2) return std::nullopt;
  std::stable_sort(rivals.begin(), rivals.end(),
                   [&](std::size_t a, std::size_t b) { return played[a].F < played[b].F; });
  for (const std::size_t rival : rivals)
    if (multiplier(rival) < 1.0) return rival;
  return std::nullopt;
}

}  // namespace legwright
