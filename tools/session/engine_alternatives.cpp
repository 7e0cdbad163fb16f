// SPDX-License-Identifier: Apache-2.0
// What a session works out beside the design that stands, and how one of that takes its place.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tools/session/engine.hpp"

namespace legwright {
namespace {

constexpr double kLeastTaskWeight = 0.01;  // a task of weight 0 would not be solved for

/// The parameter that a session holds elsewhere; its number of parameters where there is none.
int held_elsewhere(const SessionState& state, const Eigen::VectorXd& s) {
  for (int i = 0; i < s.size(); ++i) {
    const bool frozen = state.frozen[static_cast<std::size_t>(i)] && s[i] != state.s()[i];
    if (frozen || s[i] < state.lower[i] || s[i] > state.upper[i]) return i;
  }
  return static_cast<int>(s.size());
}

}  // namespace

AlternativeKind SessionEngine::kind_of(const std::string& what) {
  for (const AlternativeKind kind : {AlternativeKind::fewest, AlternativeKind::front})
    if (what == to_string(kind)) return kind;
  refuse(what, "is nothing that can be worked out; expected \"fewest\" or \"front\"");
}

bool SessionEngine::work_out(AlternativeKind kind, const std::function<void()>& tell) {
  AlternativeRules rules;
  rules.threads = threads_;
  rules.stop = stop_;
  if (tell) rules.tell = tell;
  AlternativesPointer found = legwright::work_out(kind, *state_, rules);
  if (!found) return false;
  worked_[kind] = {state_, std::move(found)};
  return true;
}

/// Whether designs of a journal are of this problem, with the F that they had.
bool SessionEngine::are_as_found(const Alternatives& all) {
  if (!fits(all, *state_)) return false;
  return std::all_of(all.designs.begin(), all.designs.end(), [&](const Alternative& one) {
    return same_values({one.s, one.motions, one.values, {}}, *shown(one.s, one.motions));
  });
}

void SessionEngine::apply(const session::WorkedOut& worked_out) {
  const AlternativeKind kind = kind_of(worked_out.what);
  AlternativesPointer found;
  if (worked_out.found && worked_out.found->kind == kind && are_as_found(*worked_out.found)) {
    auto all = std::make_shared<Alternatives>(*worked_out.found);
    all->problem = state_->problem;
    found = std::move(all);
  }
  worked_[kind] = {state_, std::move(found)};
}

void SessionEngine::apply(const session::Choose& choose) {
  const auto entry = worked_.find(kind_of(choose.what));
  if (entry == worked_.end())
    refuse(choose.what, "was not worked out yet, so there is nothing to choose from");
  Worked& worked = entry->second;
  if (!worked.found) {
    AlternativeRules rules;
    rules.threads = threads_;
    worked.found = legwright::work_out(entry->first, *worked.from, rules);
    if (!worked.found) refuse(choose.what, "has no designs; work it out anew");
  }
  const Alternatives& all = *worked.found;
  if (choose.design < 0 || choose.design >= static_cast<int>(all.designs.size()))
    refuse(choose.what,
           fmt::format("design {}: expected 0 to {}", choose.design, all.designs.size() - 1));
  if (all.problem != state_->problem)
    refuse(choose.what, "was worked out for other tasks; work it out anew");
  const Alternative& chosen = all.designs[static_cast<std::size_t>(choose.design)];
  const int held = held_elsewhere(*state_, chosen.s);
  if (held < chosen.s.size()) {
    const DesignParameter& parameter = robot_.space.parameters[static_cast<std::size_t>(held)];
    refuse(parameter.name,
           fmt::format("is locked or bounded since this was worked out, and is to be {} {}; unlock "
                       "it, widen its bounds, or work it out anew",
                       chosen.s[held], parameter.unit));
  }
  SessionState next = *state_;
  if (all.kind == AlternativeKind::front) {
    next.weights = chosen.weights;
    for (double& weight : next.weights) weight = std::max(weight, kLeastTaskWeight);
  }
  next.cold.assign(next.cold.size(), false);
  next.now = shown(chosen.s, chosen.motions);
  const std::vector<std::string> key{"", choose.what};  // no parameter has that name
  change(std::move(next), choose.goes_on && moving_ == key && history_.can_undo());
  moving_ = key;
}

AlternativesPointer SessionEngine::worked_out(AlternativeKind kind) const {
  const auto found = worked_.find(kind);
  return found == worked_.end() ? nullptr : found->second.found;
}

std::vector<AlternativesPointer> SessionEngine::alternatives() const {
  std::vector<AlternativesPointer> out;
  for (const auto& [kind, worked] : worked_)
    if (worked.found) out.push_back(worked.found);
  return out;
}

}  // namespace legwright
