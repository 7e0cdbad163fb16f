// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/attribution.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace legwright {
namespace {

constexpr double kShareThreshold = 0.01;       // of the largest share of all
constexpr std::size_t kMainShares = 3;         // of a parameter
constexpr double kMainShareThreshold = 0.05;   // of the parameter's largest share
constexpr double kIdleThreshold = 0.01;        // of the fall of F
constexpr std::size_t kMainParameters = 2;     // of a summary
constexpr std::size_t kMainEffects = 3;        // changed parameters
constexpr double kMainEffectThreshold = 0.05;  // of the largest decrease

std::vector<AttributionShare> largest_of(const std::vector<AttributionShare>& sorted,
                                         std::size_t most) {
  std::vector<AttributionShare> out;
  for (const AttributionShare& share : sorted) {
    if (out.size() == most ||
        std::abs(share.decrease) < kMainShareThreshold * std::abs(sorted.front().decrease))
      break;
    out.push_back(share);
  }
  return out;
}

}  // namespace

double Attribution::total(std::string_view task) const {
  double sum = 0.0;
  for (const AttributionShare& share : shares)
    if (task.empty() || share.task == task) sum += share.decrease;
  return sum;
}

void sort_by_size(std::vector<AttributionShare>& shares) {
  std::stable_sort(shares.begin(), shares.end(),
                   [](const AttributionShare& a, const AttributionShare& b) {
                     return std::abs(a.decrease) > std::abs(b.decrease);
                   });
}

void merge_attributions(std::vector<Attribution>& all, const std::vector<Attribution>& more) {
  for (const Attribution& attribution : more) {
    const auto same = std::find_if(all.begin(), all.end(), [&](const Attribution& one) {
      return one.parameter == attribution.parameter;
    });
    if (same == all.end()) {
      all.push_back(attribution);
      continue;
    }
    same->shares.insert(same->shares.end(), attribution.shares.begin(), attribution.shares.end());
    sort_by_size(same->shares);
  }
}

double largest_share(const std::vector<Attribution>& attributions) {
  double largest = 0.0;
  for (const Attribution& one : attributions)
    if (!one.shares.empty()) largest = std::max(largest, std::abs(one.shares.front().decrease));
  return largest;
}

std::vector<AttributionShare> main_shares(const Attribution& attribution, double scale) {
  const std::vector<AttributionShare>& shares = attribution.shares;
  if (shares.empty() || std::abs(shares.front().decrease) < kShareThreshold * scale) return {};
  return largest_of(shares, kMainShares);
}

std::optional<AttributionSummary> summarise(const std::vector<Attribution>& attributions,
                                            std::optional<double> fall) {
  AttributionSummary out;
  std::vector<std::pair<std::string, double>> parameters;
  for (const Attribution& one : attributions) {
    if (one.shares.empty()) continue;
    const double decrease = one.total();
    ++out.count;
    if (fall && decrease < kIdleThreshold * *fall) ++out.idle;
    parameters.emplace_back(one.parameter, decrease);
  }
  if (out.count == 0) return std::nullopt;
  std::stable_sort(parameters.begin(), parameters.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  for (std::size_t k = 0; k < std::min(kMainParameters, parameters.size()); ++k)
    if (parameters[k].second > 0.0) out.parameters.push_back(parameters[k]);
  return out;
}

std::vector<std::size_t> order_of_effects(const std::vector<ParameterEffect>& effects) {
  std::vector<std::size_t> order(effects.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return effects[a].decrease != effects[b].decrease
               ? effects[a].decrease > effects[b].decrease
               : effects[a].share_of_range > effects[b].share_of_range;
  });
  return order;
}

std::size_t count_main_effects(const std::vector<ParameterEffect>& ordered, bool decreases_known) {
  const std::size_t most = std::min(ordered.size(), kMainEffects);
  for (std::size_t k = 1; decreases_known && k < most; ++k)
    if (ordered[k].decrease < kMainEffectThreshold * ordered.front().decrease) return k;
  return most;
}

}  // namespace legwright
