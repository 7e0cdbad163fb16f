// SPDX-License-Identifier: Apache-2.0
#include "tools/report/pull_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/report/words.hpp"

namespace legwright {
namespace {

constexpr std::size_t kTold = 3;        // terms of a parameter
constexpr double kOfLargest = 0.05;     // a term's share of the parameter's largest
constexpr double kOfScale = 0.01;       // a parameter's largest share of the largest of all
constexpr double kUnexplained = 0.1;    // of the fall of F
constexpr std::size_t kTermsInSum = 4;  // of the summary
constexpr std::size_t kParameterInSum = 2;

void sort_shares(std::vector<PullShare>& shares) {
  std::stable_sort(shares.begin(), shares.end(), [](const PullShare& a, const PullShare& b) {
    return std::abs(a.decrease) > std::abs(b.decrease);
  });
}

/// "a −3, b −2, at the cost of c +1"
std::string list_words(const std::vector<PullShare>& shares) {
  std::string gains, costs;
  for (const PullShare& share : shares) {
    std::string& list = share.decrease > 0.0 ? gains : costs;
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ", cost_words(share.term),
                        change_of_F(-share.decrease));
  }
  if (costs.empty()) return gains;
  return gains.empty() ? "only at the cost of " + costs : gains + ", at the cost of " + costs;
}

/// The same task by task: "pace: a −3; sideways: b −2".
std::string tasks_words(const std::vector<PullShare>& shares) {
  std::vector<std::string> order;
  for (const PullShare& share : shares)
    if (std::find(order.begin(), order.end(), share.task) == order.end())
      order.push_back(share.task);
  std::string out;
  for (const std::string& task : order) {
    std::vector<PullShare> own;
    for (const PullShare& share : shares)
      if (share.task == task) own.push_back(share);
    out += fmt::format("{}{}{}", out.empty() ? "" : "; ", task.empty() ? "" : spaced(task) + ": ",
                       list_words(own));
  }
  return out;
}

std::vector<PullShare> largest_of(const std::vector<PullShare>& sorted, std::size_t most) {
  std::vector<PullShare> told;
  for (const PullShare& share : sorted) {
    if (told.size() == most ||
        std::abs(share.decrease) < kOfLargest * std::abs(sorted.front().decrease))
      break;
    told.push_back(share);
  }
  return told;
}

}  // namespace

std::string change_of_F(double change) {
  const double size = std::abs(change);
  const int digits = size >= 9.995 ? 1 : size >= 0.00995 ? 2 : size >= 0.000995 ? 3 : 4;
  return fmt::format("{}{:.{}f}", change < 0.0 ? "−" : "+", size, digits);
}

double ParameterPull::total(std::string_view task) const {
  double sum = 0.0;
  for (const PullShare& share : shares)
    if (task.empty() || share.task == task) sum += share.decrease;
  return sum;
}

std::vector<ParameterPull> pulls_of(const Json& pull, const std::string& task) {
  std::vector<ParameterPull> pulls;
  if (!pull.is_object()) return pulls;
  for (const auto& [parameter, terms] : pull.items()) {
    if (!terms.is_object()) continue;
    ParameterPull one{parameter, {}};
    for (const auto& [term, value] : terms.items()) {
      if (value.is_number() && std::isfinite(value.get<double>()))
        one.shares.push_back({task, term, value.get<double>()});
    }
    sort_shares(one.shares);
    pulls.push_back(std::move(one));
  }
  return pulls;
}

void merge_pulls(std::vector<ParameterPull>& all, const std::vector<ParameterPull>& more) {
  for (const ParameterPull& pull : more) {
    const auto same = std::find_if(all.begin(), all.end(), [&](const ParameterPull& one) {
      return one.parameter == pull.parameter;
    });
    if (same == all.end()) {
      all.push_back(pull);
      continue;
    }
    same->shares.insert(same->shares.end(), pull.shares.begin(), pull.shares.end());
    sort_shares(same->shares);
  }
}

double largest_share(const std::vector<ParameterPull>& pulls) {
  double largest = 0.0;
  for (const ParameterPull& pull : pulls)
    if (!pull.shares.empty()) largest = std::max(largest, std::abs(pull.shares.front().decrease));
  return largest;
}

std::string pull_words(const ParameterPull& pull, double scale) {
  if (pull.shares.empty() || std::abs(pull.shares.front().decrease) < kOfScale * scale) return "";
  return tasks_words(largest_of(pull.shares, kTold));
}

std::string pull_summary(const std::vector<ParameterPull>& pulls, std::optional<double> fall) {
  std::vector<PullShare> sums;
  std::vector<std::pair<double, std::string>> parameters;
  double all = 0.0;
  for (const ParameterPull& pull : pulls) {
    for (const PullShare& share : pull.shares) {
      const auto same = std::find_if(sums.begin(), sums.end(), [&](const PullShare& sum) {
        return sum.term == share.term && sum.task == share.task;
      });
      if (same == sums.end())
        sums.push_back(share);
      else
        same->decrease += share.decrease;
    }
    all += pull.total();
    parameters.emplace_back(pull.total(), pull.parameter);
  }
  if (sums.empty()) return "";
  sort_shares(sums);
  std::string out;
  // What lies between two designs is followed to second order only.
  if (fall && std::abs(*fall - all) > kUnexplained * std::abs(*fall))
    out = fmt::format(
        "Of the {} that F fell, {} can be told apart; the rest lies in steps too long to be split.",
        short_number(*fall), short_number(all));
  else
    out = fmt::format("Taken together, the changes {} F by {}.", all < 0.0 ? "raised" : "lowered",
                      short_number(std::abs(all)));
  out += fmt::format(" By term: {}.", tasks_words(largest_of(sums, kTermsInSum)));
  std::stable_sort(parameters.begin(), parameters.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string most;
  for (std::size_t k = 0; k < std::min(kParameterInSum, parameters.size()); ++k) {
    if (!(parameters[k].first > 0.0)) break;
    most += fmt::format("{}{} ({})", most.empty() ? "" : " and ", spaced(parameters[k].second),
                        change_of_F(-parameters[k].first));
  }
  if (!most.empty()) out += fmt::format(" Most came with {}.", most);
  return out;
}

}  // namespace legwright
