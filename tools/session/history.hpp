// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tools/session/state.hpp"

namespace legwright {

using StatePointer = std::shared_ptr<const SessionState>;

/// What undo and redo go back and forth through, and what was given a name.
class SessionHistory {
 public:
  /// So many steps can be undone; of more the oldest are given up.
  static constexpr std::size_t kSteps = 1000;

  /// The state that a change is about to leave.
  void leave(StatePointer state) {
    undo_.push_back(std::move(state));
    if (undo_.size() > kSteps) undo_.pop_front();
    redo_.clear();
  }
  bool can_undo() const { return !undo_.empty(); }
  bool can_redo() const { return !redo_.empty(); }
  /// @param now the state to come back to by redo(). Needs can_undo().
  StatePointer undo(StatePointer now) { return swap(undo_, redo_, std::move(now)); }
  StatePointer redo(StatePointer now) { return swap(redo_, undo_, std::move(now)); }

  void name(const std::string& name, StatePointer state) { named_[name] = std::move(state); }
  /// Null where there is none.
  StatePointer named(const std::string& name) const {
    const auto found = named_.find(name);
    return found == named_.end() ? nullptr : found->second;
  }
  const std::map<std::string, StatePointer>& kept() const { return named_; }
  std::vector<std::string> names() const {
    std::vector<std::string> out;
    for (const auto& [name, state] : named_) out.push_back(name);
    return out;
  }

 private:
  static StatePointer swap(std::deque<StatePointer>& from, std::deque<StatePointer>& to,
                           StatePointer now) {
    StatePointer state = std::move(from.back());
    from.pop_back();
    to.push_back(std::move(now));
    return state;
  }

  std::deque<StatePointer> undo_, redo_;
  std::map<std::string, StatePointer> named_;
};

}  // namespace legwright
