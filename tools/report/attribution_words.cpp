// SPDX-License-Identifier: Apache-2.0
#include "tools/report/attribution_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/report/words.hpp"

namespace legwright {
namespace {

/// "a −3, b −2, at the cost of c +1"
std::string list_words(const std::vector<AttributionShare>& shares) {
  std::string gains, costs;
  for (const AttributionShare& share : shares) {
    std::string& list = share.decrease > 0.0 ? gains : costs;
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ", cost_words(share.term),
                        change_of_cost(-share.decrease));
  }
  if (costs.empty()) return gains;
  return gains.empty() ? "only at the cost of " + costs : gains + ", at the cost of " + costs;
}

/// The same task by task: "pace: a −3; sideways: b −2".
std::string tasks_words(const std::vector<AttributionShare>& shares) {
  std::vector<std::string> order;
  for (const AttributionShare& share : shares)
    if (std::find(order.begin(), order.end(), share.task) == order.end())
      order.push_back(share.task);
  std::string out;
  for (const std::string& task : order) {
    std::vector<AttributionShare> own;
    for (const AttributionShare& share : shares)
      if (share.task == task) own.push_back(share);
    out += fmt::format("{}{}{}", out.empty() ? "" : "; ", task.empty() ? "" : spaced(task) + ": ",
                       list_words(own));
  }
  return out;
}

}  // namespace

std::string change_of_cost(double change) {
  const double size = std::abs(change);
  const int digits = size >= 9.995 ? 1 : size >= 0.00995 ? 2 : size >= 0.000995 ? 3 : 4;
  return fmt::format("{}{:.{}f}", change < 0.0 ? "−" : "+", size, digits);
}

std::string attribution_words(const Attribution& attribution, double scale) {
  return tasks_words(main_shares(attribution, scale));
}

std::string attribution_summary(const std::vector<Attribution>& attributions,
                                std::optional<double> fall) {
  const std::optional<AttributionSummary> summary = summarise(attributions, fall);
  if (!summary) return "";
  std::string out;
  for (const auto& [parameter, decrease] : summary->parameters)
    out += fmt::format("{}{} ({})", out.empty() ? "" : " and of ", spaced(parameter),
                       change_of_cost(-decrease));
  out = out.empty() ? "No change of the finished body lowers F by itself."
                    : fmt::format("In the finished body F owes most to the change of {}.", out);
  if (summary->idle > 0)
    out +=
        fmt::format(" {} of {} changes could each be put back at less than 1 % of the fall of F.",
                    summary->idle, summary->count);
  return out;
}

std::string put_back_words(double raised, const std::optional<PlayedGait>& played) {
  if (!std::isfinite(raised)) return "put back alone, no motion is found";
  std::string out = fmt::format("put back alone, F {} by {}", raised < 0.0 ? "falls" : "rises",
                                change_of_cost(std::abs(raised)).substr(1));
  if (played) out += played->pass ? ", and MuJoCo still passes it" : ", and it fails in MuJoCo";
  return out;
}

std::string put_back_physics_words(const std::optional<std::vector<PutBackRecord>>& rows) {
  if (!rows) return "";
  std::size_t played = 0;
  std::vector<std::string> failing;
  for (const PutBackRecord& row : *rows) {
    if (!row.played) continue;
    ++played;
    if (!row.played->pass) failing.push_back(row.parameter);
  }
  if (played == 0) return "";
  std::string out = fmt::format(
      "Put back alone, {} of the {} that buy{} 1 % of F or more let{} the robot fail in MuJoCo "
      "within a few cycles",
      failing.empty() ? "none" : std::to_string(failing.size()), played, played == 1 ? "s" : "",
      failing.size() <= 1 ? "s" : "");
  return out + named_if_few(failing) + ".";
}

}  // namespace legwright
