// SPDX-License-Identifier: Apache-2.0
#include "tools/run/attribution_json.hpp"

#include <cmath>

namespace legwright {

Json to_json(const std::vector<Attribution>& attributions) {
  Json result = Json::object();
  for (const Attribution& attribution : attributions) {
    Json terms = Json::object();
    for (const AttributionShare& share : attribution.shares) terms[share.term] = share.decrease;
    result[attribution.parameter] = std::move(terms);
  }
  return result;
}

std::vector<Attribution> attributions_from_json(const Json& pull, const std::string& task) {
  std::vector<Attribution> out;
  if (!pull.is_object()) return out;
  for (const auto& [parameter, terms] : pull.items()) {
    if (!terms.is_object()) continue;
    Attribution one{parameter, {}};
    for (const auto& [term, value] : terms.items()) {
      if (value.is_number() && std::isfinite(value.get<double>()))
        one.shares.push_back({task, term, value.get<double>()});
    }
    sort_by_size(one.shares);
    out.push_back(std::move(one));
  }
  return out;
}

}  // namespace legwright
