// SPDX-License-Identifier: Apache-2.0
// How a session takes what its journal says was found, in the place of solving for it once more.
#include <utility>

#include "tools/session/engine.hpp"

namespace legwright {

/// The body and motions that were found, where they are of this state's problem and F there is what
/// it was; else null: then the work is done anew.
std::shared_ptr<const DesignPoint> SessionEngine::point_of(const std::optional<Found>& found) {
  if (!found || !fits(*found, *state_)) return nullptr;
  auto point = shown(found->s, found->motions);
  return same_values(*found, *point) ? point : nullptr;
}

void SessionEngine::apply(const session::Settled& settled) {
  const bool same = point_of(settled.found) && settled.found->s == state_->s();
  auto point = same ? adopted(*settled.found) : nullptr;
  if (!point) {
    (void)settle();
    return;
  }
  const StatePointer before = state_;
  SessionState next = *state_;
  next.cold.assign(next.cold.size(), false);
  next.now = next.base = std::move(point);
  state_ = std::make_shared<const SessionState>(std::move(next));
  keep_given(*before);
}

/// To where so many design iterations led. False where that does not fit.
bool SessionEngine::go_to(const std::optional<Found>& found, int iterations) {
  auto point = point_of(found);
  if (!point) return false;
  SessionState next = *state_;
  next.cold.assign(next.cold.size(), false);
  next.now = std::move(point);
  next.iterations += iterations;
  change(std::move(next));
  return true;
}

void SessionEngine::apply(const session::Searched& searched) {
  if (!go_to(searched.found, searched.points)) (void)search(searched.points, {});
}

void SessionEngine::apply(const session::Step& step) {
  if (!go_to(step.found, 1)) (void)this->step();
}

SessionCommand SessionEngine::as_done(SessionCommand command, const SessionState& before) const {
  const bool moved = state_->now != before.now;
  const std::optional<Found> found = moved ? found_in(*state_) : std::nullopt;
  if (auto* settled = std::get_if<session::Settled>(&command)) {
    settled->found = found;
  } else if (auto* step = std::get_if<session::Step>(&command)) {
    step->found = found;
  } else if (auto* searched = std::get_if<session::Searched>(&command)) {
    if (moved) searched->points = state_->iterations - before.iterations;
    searched->found = found;
  } else if (auto* worked_out = std::get_if<session::WorkedOut>(&command)) {
    worked_out->found = this->worked_out(kind_of(worked_out->what));
  }
  return command;
}

}  // namespace legwright
