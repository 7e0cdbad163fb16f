// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/alternatives_json.hpp"

#include <cmath>
#include <vector>

namespace legwright {

Json alternatives_json(const Alternatives& all) {
  Json designs = Json::array();
  for (const Alternative& one : all.designs)
    designs.push_back({{"s", std::vector<double>(one.s.begin(), one.s.end())},
                       {"weights", one.weights},
                       {"task_F", one.values},
                       {"F", one.value()}});
  Json out{{"what", to_string(all.kind)}, {"designs", std::move(designs)}};
  if (all.kind != AlternativeKind::fewest) return out;
  Json worths = Json::array();
  const auto& parameters = all.problem->robot.space.parameters;
  for (const ChangeWorth& one : all.worths)
    worths.push_back({{"name", parameters[static_cast<std::size_t>(one.parameter)].name},
                      {"given", one.given},
                      {"worth", std::isfinite(one.worth) ? Json(one.worth) : Json(nullptr)}});
  out["given_F"] = all.given_value;
  out["fewest"] = all.fewest;
  out["kept"] = Alternatives::kKept;
  out["worths"] = std::move(worths);
  return out;
}

}  // namespace legwright
