// SPDX-License-Identifier: Apache-2.0
#include "tools/session/found.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "tools/files/base64.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

constexpr double kSameValue = 1e-9;  // relative: sums of another processor end in other last bits

constexpr std::array kStatuses{SolveStatus::converged,  SolveStatus::iteration_limit,
                               SolveStatus::stalled,    SolveStatus::not_a_minimum,
                               SolveStatus::not_finite, SolveStatus::stopped};

Json packed(const VectorXd& x) {
  return base64_of(std::vector<double>(x.data(), x.data() + x.size()));
}

VectorXd unpacked(const Json& json) {
  const auto bytes = from_base64(json.get<std::string>());
  if (!bytes || bytes->size() % sizeof(double) != 0)
    throw std::invalid_argument("numbers are no base64 of such");
  VectorXd out(static_cast<Eigen::Index>(bytes->size() / sizeof(double)));
  if (out.size() > 0) std::memcpy(out.data(), bytes->data(), bytes->size());
  return out;
}

Json packed(const std::vector<VectorXd>& all) {
  Json out = Json::array();
  for (const VectorXd& one : all) out.push_back(packed(one));
  return out;
}

std::vector<VectorXd> all_unpacked(const Json& json) {
  std::vector<VectorXd> out;
  for (const Json& one : json) out.push_back(unpacked(one));
  return out;
}

int index_of(const Json& json) {
  if (!json.is_number_integer() || json < 0 || json > std::numeric_limits<int>::max())
    throw std::invalid_argument("is no whole number that counts");
  return json.get<int>();
}

std::vector<int> indices_of(const Json& json) {
  std::vector<int> out;
  for (const Json& one : json) out.push_back(index_of(one));
  return out;
}

SolveStatus status_of(const Json& json) {
  const auto word = json.get<std::string>();
  const auto found = std::find_if(kStatuses.begin(), kStatuses.end(),
                                  [&](SolveStatus one) { return to_string(one) == word; });
  if (found == kStatuses.end())
    throw std::invalid_argument(fmt::format("'{}' is no end of a solve", word));
  return *found;
}

bool are_motions(const std::vector<VectorXd>& motions, const CodesignProblem& problem) {
  if (static_cast<int>(motions.size()) != problem.task_count()) return false;
  for (int k = 0; k < problem.task_count(); ++k) {
    const VectorXd& m = motions[static_cast<std::size_t>(k)];
    if (m.size() != problem.objectives[k]->layout().motion_size() || !m.allFinite()) return false;
  }
  return true;
}

}  // namespace

std::optional<Found> found_in(const SessionState& state) {
  Found out;
  out.s = state.s();
  for (const TaskIterate& task : state.now->tasks) {
    if (!std::isfinite(task.value + task.outer_value)) return std::nullopt;
    out.motions.push_back(task.m);
    out.values.push_back(task.value + task.outer_value);
    out.status.push_back(task.motion_status);
  }
  return out;
}

bool fits(const Found& found, const SessionState& state) {
  const std::size_t tasks = found.motions.size();
  if (found.s.size() != state.s().size() || found.values.size() != tasks ||
      found.status.size() != tasks || !are_motions(found.motions, *state.problem))
    return false;
  const DesignSpace space = state.space();
  return (found.s.array() >= space.lower().array()).all() &&
         (found.s.array() <= space.upper().array()).all();
}

bool same_values(const Found& found, const DesignPoint& point) {
  for (std::size_t k = 0; k < point.tasks.size(); ++k) {
    const double now = point.tasks[k].value + point.tasks[k].outer_value;
    if (!std::isfinite(now) || !(std::abs(now - found.values[k]) <= kSameValue * std::abs(now)))
      return false;
  }
  return true;
}

Json json_of(const Found& found) {
  Json status = Json::array();
  for (const SolveStatus one : found.status) status.push_back(to_string(one));
  return {{"s", packed(found.s)},
          {"motions", packed(found.motions)},
          {"values", found.values},
          {"status", std::move(status)}};
}

Found found_of(const Json& json) {
  Found out{unpacked(json.at("s")),
            all_unpacked(json.at("motions")),
            json.at("values").get<std::vector<double>>(),
            {}};
  for (const Json& one : json.at("status")) out.status.push_back(status_of(one));
  return out;
}

Json json_of(const Alternatives& all) {
  Json designs = Json::array(), worths = Json::array();
  for (const Alternative& one : all.designs)
    designs.push_back({{"s", packed(one.s)},
                       {"motions", packed(one.motions)},
                       {"weights", one.weights},
                       {"values", one.values},
                       {"changed", one.changed}});
  for (const ChangeWorth& one : all.worths)
    worths.push_back({{"parameter", one.parameter},
                      {"given", one.given},
                      {"worth", std::isfinite(one.worth) ? Json(one.worth) : Json(nullptr)}});
  return {{"kind", to_string(all.kind)},
          {"designs", std::move(designs)},
          {"given_value", all.given_value},
          {"fewest", all.fewest},
          {"worths", std::move(worths)}};
}

Alternatives alternatives_of(const Json& json) {
  Alternatives out;
  const auto kind = json.at("kind").get<std::string>();
  if (kind == to_string(AlternativeKind::front))
    out.kind = AlternativeKind::front;
  else if (kind != to_string(AlternativeKind::fewest))
    throw std::invalid_argument(fmt::format("'{}' are no designs to choose from", kind));
  for (const Json& one : json.at("designs"))
    out.designs.push_back({unpacked(one.at("s")), all_unpacked(one.at("motions")),
                           one.at("weights").get<std::vector<double>>(),
                           one.at("values").get<std::vector<double>>(),
                           indices_of(one.at("changed"))});
  json.at("given_value").get_to(out.given_value);
  out.fewest = static_cast<std::size_t>(index_of(json.at("fewest")));
  for (const Json& one : json.at("worths")) {
    const Json& worth = one.at("worth");
    out.worths.push_back(
        {index_of(one.at("parameter")), one.at("given").get<double>(),
         worth.is_null() ? std::numeric_limits<double>::infinity() : worth.get<double>()});
  }
  return out;
}

bool fits(const Alternatives& all, const SessionState& state) {
  const auto parameters = static_cast<int>(state.s().size());
  const auto tasks = static_cast<std::size_t>(state.problem->task_count());
  const auto is_parameter = [&](int k) { return k >= 0 && k < parameters; };
  const bool designs = std::all_of(all.designs.begin(), all.designs.end(), [&](const auto& one) {
    return one.s.size() == parameters && one.s.allFinite() &&
           are_motions(one.motions, *state.problem) && one.weights.size() == tasks &&
           one.values.size() == tasks &&
           std::all_of(one.changed.begin(), one.changed.end(), is_parameter);
  });
  return designs && all.fewest < all.designs.size() &&
         std::all_of(all.worths.begin(), all.worths.end(),
                     [&](const ChangeWorth& one) { return is_parameter(one.parameter); });
}

}  // namespace legwright
