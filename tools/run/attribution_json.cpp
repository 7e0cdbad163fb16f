// SPDX-License-Identifier: Apache-2.0
#include "tools/run/attribution_json.hpp"

#include <cmath>

namespace legwright {

AttributionRecord record_of(const std::vector<Attribution>& attributions) {
  AttributionRecord record;
  for (const Attribution& attribution : attributions) {
    ByName<double>& terms = record.of(attribution.parameter);
    for (const AttributionShare& share : attribution.shares) terms.of(share.term) = share.decrease;
  }
  return record;
}

std::vector<Attribution> attributions_of(const std::optional<AttributionRecord>& pull,
                                         const std::string& task) {
  std::vector<Attribution> out;
  if (!pull) return out;
  for (const auto& [parameter, terms] : *pull) {
    Attribution one{parameter, {}};
    for (const auto& [term, value] : terms)
      if (std::isfinite(value)) one.shares.push_back({task, term, value});
    sort_by_size(one.shares);
    out.push_back(std::move(one));
  }
  return out;
}

}  // namespace legwright
