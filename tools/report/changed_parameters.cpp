// SPDX-License-Identifier: Apache-2.0
#include "tools/report/changed_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "optimizer/solve/attribution.hpp"
#include "tools/report/parameter_view.hpp"

namespace legwright {
namespace {

constexpr double kNoMotion = std::numeric_limits<double>::infinity();

}  // namespace

std::size_t ChangedParameters::at_bound() const {
  return static_cast<std::size_t>(
      std::count_if(list.begin(), list.end(),
                    [](const ChangedParameter& each) { return !each.view.at_bound().empty(); }));
}

std::string ChangedParameters::bound_words() const {
  const std::size_t bound = at_bound(), all = list.size();
  if (bound == 0) return "";
  if (bound == all)
    return fmt::format("{} at a bound: the bound{} decided how far, not the cost.",
                       all == 1 ? "It stands" : fmt::format("All {} that changed stand", all),
                       all == 1 ? "" : "s");
  return fmt::format(
      "Of {} parameters that changed {} {} at a bound: there the bound decided how far, not the "
      "cost.",
      all, bound, bound == 1 ? "stands" : "stand");
}

ChangedParameters changed_parameters(const RunRecord& run) {
  ChangedParameters out;
  std::map<std::string, const PutBackRecord*> rows;
  if (run.put_back)
    for (const PutBackRecord& each : *run.put_back) rows[each.parameter] = &each;
  out.by_cost = !rows.empty();
  std::vector<ChangedParameter> changed;
  std::vector<ParameterEffect> effects;
  for (ParameterView& view : parameters_of(run)) {
    if (view.change() == "0") continue;
    const auto found = rows.find(view.name);
    const PutBackRecord row = found == rows.end() ? PutBackRecord{} : *found->second;
    const double lowered = std::isnan(row.F) ? kNoMotion : row.F + row.J.value_or(0.0);
    effects.push_back({lowered, view.share_of_range()});
    changed.push_back({std::move(view), lowered, row.played});
  }
  std::vector<ParameterEffect> ordered;
  for (const std::size_t k : order_of_effects(effects)) {
    out.list.push_back(std::move(changed[k]));
    ordered.push_back(effects[k]);
  }
  out.main_count = count_main_effects(ordered, out.by_cost);
  return out;
}

}  // namespace legwright
