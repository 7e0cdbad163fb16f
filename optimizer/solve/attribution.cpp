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
constexpr double kUnexplained = 0.1;           // of the fall of F
constexpr std::size_t kMainTerms = 4;          // of a summary
constexpr std::size_t kMainParameters = 2;     // of a summary
constexpr std::size_t kMainEffects = 3;        // changed parameters
constexpr double kMainEffectThreshold = 0.05;  // of the largest decrease

/// Derivatives explain a long step in part only: the rest goes to the parameters in the ratio of
/// their shares.
/// @return the size of the rest that the shares do not explain
double spread_rest(double decrease, Eigen::MatrixXd::RowXpr shares) {
  const double size = shares.cwiseAbs().sum(), rest = decrease - shares.sum();
  if (size > 0.0) shares += rest / size * shares.cwiseAbs();
  return std::abs(rest);
}

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

/// By term and task, over all parameters.
std::vector<AttributionShare> sums_of_terms(const std::vector<Attribution>& attributions) {
  std::vector<AttributionShare> sums;
  for (const Attribution& attribution : attributions)
    for (const AttributionShare& share : attribution.shares) {
      const auto same = std::find_if(sums.begin(), sums.end(), [&](const AttributionShare& sum) {
        return sum.term == share.term && sum.task == share.task;
      });
      if (same == sums.end())
        sums.push_back(share);
      else
        same->decrease += share.decrease;
    }
  sort_by_size(sums);
  return sums;
}

}  // namespace

double Attribution::total(std::string_view task) const {
  double sum = 0.0;
  for (const AttributionShare& share : shares)
    if (task.empty() || share.task == task) sum += share.decrease;
  return sum;
}

void AttributionAlongPath::add(const Objective& objective, const Eigen::VectorXd& s,
                               const Eigen::VectorXd& m, const Eigen::MatrixXd& sensitivity) {
  TermShares now = objective.shares(s, m, sensitivity.size() > 0);
  if (sensitivity.size() > 0) now.partial_s += now.stationarity * sensitivity;
  if (decrease_.size() == 0) decrease_.setZero(now.partial_s.rows(), now.partial_s.cols());
  std::vector<double> values;
  for (const TermValue& term : objective.terms(s, m)) values.push_back(term.value);
  if (share_.size() > 0) {
    const Eigen::RowVectorXd change = (s - s_).transpose();
    Eigen::MatrixXd step = -0.5 * (share_ + now.partial_s) * change.asDiagonal();
    for (int t = 0; t < step.rows(); ++t)
      spread_ += spread_rest(values_[t] - values[t], step.row(t));
    decrease_ += step;
  }
  values_ = std::move(values);
  terms_ = std::move(now.names);
  share_ = std::move(now.partial_s);
  s_ = s;
}

void AttributionAlongPath::follow(const AttributionAlongPath& before) {
  if (decrease_.size() == 0)
    decrease_ = before.decrease_;
  else if (before.decrease_.size() > 0)
    decrease_ += before.decrease_;
  if (terms_.empty()) terms_ = before.terms_;
  spread_ += before.spread_;
}

std::vector<Attribution> AttributionAlongPath::by_parameter(const DesignSpace& space,
                                                            double weight) const {
  std::vector<Attribution> out;
  const double largest = decrease_.size() > 0 ? decrease_.cwiseAbs().maxCoeff() : 0.0;
  for (int k = 0; k < decrease_.cols(); ++k) {
    Attribution one{space.parameters[k].name, {}};
    for (int t = 0; t < decrease_.rows(); ++t)
      if (std::abs(decrease_(t, k)) > kShareThreshold * largest)
        one.shares.push_back({{}, std::string(terms_[t]), decrease_(t, k)});
    sort_by_size(one.shares);
    for (AttributionShare& share : one.shares) share.decrease *= weight;
    out.push_back(std::move(one));
  }
  return out;
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
  out.terms = largest_of(sums_of_terms(attributions), kMainTerms);
  if (out.terms.empty()) return std::nullopt;
  std::vector<std::pair<std::string, double>> parameters;
  for (const Attribution& one : attributions) {
    out.decrease += one.total();
    parameters.emplace_back(one.parameter, one.total());
  }
  // Shares follow a step to second order only.
  out.partial = fall && std::abs(*fall - out.decrease) > kUnexplained * std::abs(*fall);
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
