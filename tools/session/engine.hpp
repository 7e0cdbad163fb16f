// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tools/session/alternatives.hpp"
#include "tools/session/command.hpp"
#include "tools/session/design_motions.hpp"
#include "tools/session/history.hpp"
#include "tools/session/search.hpp"
#include "tools/session/state.hpp"

namespace legwright {

/// A robot and its tasks under somebody's hands: the session without its thread. Commands change
/// the state at once, with first-order motions; settle() and search() do the long work. The same
/// commands lead to the same bits. Not safe for several threads at once.
class SessionEngine {
 public:
  /// Throws InputError where text, robot and tasks do not fit.
  /// @param text of a task file; its [design] is where bounds and frozen parameters begin, and says
  ///   which body was given, from which the session sets out
  /// @param file for messages. @param threads 0: one for each task, as far as there are cores
  SessionEngine(RobotModel robot, const std::string& text, const std::filesystem::path& file,
                int threads = 0);
  SessionEngine(const SessionEngine&) = delete;  // its costs refer to it
  SessionEngine& operator=(const SessionEngine&) = delete;

  const StatePointer& state() const { return state_; }
  const SessionHistory& history() const { return history_; }
  /// For solves: asked before each Newton step.
  void set_stop(std::function<bool()> stop) { stop_ = std::move(stop); }

  /// Throws InputError, with nothing changed, where a name or value does not fit.
  void apply(const session::Edit& edit);
  void apply(const session::Freeze& freeze);
  void apply(const session::Bounds& bounds);
  void apply(const session::Tasks& tasks);
  void apply(const session::Weights& weights);
  void apply(const session::Reset& reset);
  void apply(const session::Undo& undo);
  void apply(const session::Redo& redo);
  void apply(const session::Snapshot& snapshot);
  void apply(const session::Branch& branch);
  /// Takes what the journal says was found, or does the work, which `stop` must not interrupt.
  void apply(const session::Step& step);
  void apply(const session::Settled& settled);
  void apply(const session::Searched& searched);
  /// Notes where it was; without what was found the work is done when one of the designs is asked
  /// for.
  void apply(const session::WorkedOut& worked_out);
  void apply(const session::Choose& choose);
  void apply(const SessionCommand& command);

  /// The command as the journal has it, with what it came to.
  /// @param before the state that it was obeyed in
  SessionCommand as_done(SessionCommand command, const SessionState& before) const;

  /// Solves for the motions of the body as it stands. False where stopped or F is not finite: then
  /// nothing has changed.
  bool settle();
  /// Searches on, body and motions. @param most points; 0: to the end. @param tell after each point
  SearchEnd search(int most, const std::function<void()>& tell);
  /// One design iteration. False where stopped, or where no better body is near: then nothing has
  /// changed.
  bool step();
  /// Works out other designs, which choose() takes; the state stays. False where stopped: then
  /// nothing has changed. Throws InputError where there is nothing to be worked out.
  bool work_out(AlternativeKind kind, const std::function<void()>& tell);
  /// "fewest" or "front". Throws InputError for another word.
  static AlternativeKind kind_of(const std::string& what);
  /// What was worked out, the latest of each kind; null where there is nothing of it.
  std::vector<AlternativesPointer> alternatives() const;
  AlternativesPointer worked_out(AlternativeKind kind) const;

 private:
  struct Costs;

  Costs& costs();
  SearchRules rules();
  std::vector<WeightedCost> weighted_costs();
  bool warm_up();
  void keep_given(const SessionState& before);
  int find(const std::string& name) const;
  std::shared_ptr<const DesignPoint> shown(const Eigen::VectorXd& s,
                                           std::vector<Eigen::VectorXd> motions);
  std::shared_ptr<const DesignPoint> guessed(const SessionState& state, const Eigen::VectorXd& s);
  void move_to(const Eigen::VectorXd& s, bool goes_on);
  void change(SessionState next, bool goes_on = false);
  std::shared_ptr<const DesignPoint> point_of(const std::optional<Found>& found);
  std::shared_ptr<const DesignPoint> adopted(const Found& found);
  bool go_to(const std::optional<Found>& found, int iterations);
  bool are_as_found(const Alternatives& all);
  [[noreturn]] static void refuse(const std::string& where, const std::string& message);

  RobotModel robot_;  // with the bounds of its file
  std::filesystem::path file_;
  int threads_;
  std::function<bool()> stop_ = [] { return false; };
  StatePointer state_;
  SessionHistory history_;
  std::vector<std::string> moving_;  // the parameters of the last command, where that was an edit
  struct Worked {
    StatePointer from;
    AlternativesPointer found;  // null: a journal's, not worked out anew yet
  };
  std::map<AlternativeKind, Worked> worked_;
  std::shared_ptr<Costs> costs_;
};

}  // namespace legwright
