// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "tools/session/drag_pace.hpp"
#include "tools/session/engine.hpp"
#include "tools/session/journal.hpp"

namespace legwright {

/// What a session is doing.
enum class SessionPhase { idle, solving, searching, working_out };
std::string_view to_string(SessionPhase phase);

/// What readers see of a session; never changed once it is made.
struct SessionSnapshot {
  std::uint64_t revision = 0;  // rises with each snapshot
  StatePointer state;
  SessionPhase phase = SessionPhase::idle;
  bool can_undo = false, can_redo = false;
  std::vector<std::string> names;                 // of what was kept under one
  std::map<std::string, StatePointer> kept;       // under these
  std::vector<AlternativesPointer> alternatives;  // worked out, the latest of each kind
};
using SnapshotPointer = std::shared_ptr<const SessionSnapshot>;

/// A state and the journal whose replay leads to it, as text.
struct SessionRecord {
  StatePointer state;
  std::string journal;
};

/// Something that happened, for whoever follows.
struct SessionEvent {
  enum class Kind {
    changed,     // a command was obeyed; motions are first-order ones
    solved,      // the motions are those of the body
    unsolved,    // Newton's method found none
    point,       // a search came to another body
    ended,       // a search ended, or was paused; `words` say how
    worked_out,  // other designs are there to choose from; or `words` say why there are none
    failed,      // what was posted could not be obeyed; `words` say why
  };
  std::uint64_t number = 0;  // from 1, without gaps
  Kind kind = Kind::changed;
  SnapshotPointer snapshot;
  std::string words;
};
std::string_view to_string(SessionEvent::Kind kind);

/// A session that was closed is asked for something.
class SessionClosed : public std::invalid_argument {
 public:
  SessionClosed() : std::invalid_argument("the session is closed") {}
};

/// Co-design with somebody who takes part. Every call may come from any thread. A worker thread
/// owns the state: it obeys commands in their order, at once, and does the long work between them:
/// solving for motions that a change left behind, and the search. While a hand holds the body it
/// solves once the hand rests, and now and then (DragPace). A command interrupts long work
/// within one Newton step; a search is then paused, and start() goes on from what is there. What
/// happened stands in the journal, whose replay leads to the same bits.
class Session {
 public:
  struct Options {
    std::filesystem::path journal = {};         // file, or none
    std::vector<SessionCommand> commands = {};  // of a journal, to be obeyed first
    int threads = 0;                            // 0: all cores
  };

  /// Throws InputError where text, robot, tasks and commands do not fit, std::system_error where
  /// the journal cannot be begun. Where it can be written no further, an event `failed` says so,
  /// and the session goes on without its file.
  Session(const RobotModel& robot, const std::string& text, const std::filesystem::path& file,
          const Options& options);
  Session(const RobotModel& robot, const std::string& text, const std::filesystem::path& file)
      : Session(robot, text, file, Options()) {}
  ~Session();  // as close()
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Throws InputError, with nothing changed, where the command does not fit; returns once it is
  /// obeyed and motions are predicted. Of session::Searched, Settled and Step the work is done,
  /// too, whatever waits.
  /// @param held a hand holds what the command moves, and goes on soon
  void apply(SessionCommand command, bool held = false);
  /// The same without waiting. Edits of the same parameters that wait are replaced by the last one;
  /// what does not fit is an event.
  void post(SessionCommand command);
  /// Searches on, in the background, until pause(), another command, or its end.
  void start();
  /// Returns once no search goes on.
  void pause();
  /// Works out other designs than the one that stands, in the background, until another command or
  /// its end. session::Choose takes one. Throws InputError as check_workable().
  void work_out(AlternativeKind kind);
  /// One design iteration. @return whether there was a better body near
  bool step();
  /// Returns once nothing goes on: commands obeyed, searches ended, motions solved.
  /// @return false after `limit`, or where the session is closed before
  bool wait(std::chrono::milliseconds limit = std::chrono::hours(24 * 365));

  /// Where it stands. Its phase tells what is pending, too: idle is where nothing goes on and
  /// nothing waits that was posted or started.
  SnapshotPointer snapshot() const;
  /// The same, waiting up to `limit` for one of another revision than this.
  SnapshotPointer next_snapshot(std::uint64_t revision, std::chrono::milliseconds limit) const;
  /// What happened after the event of this number (0: from the first that is kept), waiting up to
  /// `limit` for one. The last thousand are kept.
  std::vector<SessionEvent> events(std::uint64_t after, std::chrono::milliseconds limit) const;
  /// Where it stands, and the journal that leads there. A search is paused for it.
  SessionRecord record();
  /// Ends what goes on, within one Newton step but for a journal that is being obeyed. Calls that
  /// wait for their turn, and all after this one that change or ask the worker, throw
  /// SessionClosed.
  void close();

 private:
  struct Item {
    std::function<void()> work;                // on the worker, which may throw
    std::shared_ptr<std::promise<void>> done;  // null: nobody waits
    std::optional<session::Edit> edit;         // posted, in the place of work
    bool starts = false;                       // a search; what does not pauses one
  };

  void run();
  void work();
  void obey(Item& item);
  void search();
  void settle();
  void work_out_now(AlternativeKind kind);
  bool must_settle() const;  // needs mutex_
  bool has_work() const;     // needs mutex_
  static std::optional<SessionPhase> phase_after(const Item& item);
  SessionPhase pending() const;  // needs mutex_
  void await_work(std::unique_lock<std::mutex>& lock);
  bool interrupted() const;
  void enqueue(Item item);
  void call(std::function<void()> work);
  void obey_all(const std::vector<SessionCommand>& commands, bool held = false);
  void note(const SessionCommand& command);
  void write_journal(const std::function<void()>& write);
  void publish(SessionEvent::Kind kind, std::string words = {});
  void show();

  mutable std::mutex mutex_;  // of all below but what the worker owns
  mutable std::condition_variable changed_;
  std::deque<Item> queue_;
  std::deque<SessionEvent> events_;
  std::uint64_t event_count_ = 0, revision_ = 0;
  SnapshotPointer snapshot_;
  SessionPhase phase_ = SessionPhase::idle;
  bool closing_ = false, searching_ = false;
  std::optional<AlternativeKind> working_out_;
  bool busy_ = false;                    // the worker is at something
  bool held_ = false;                    // what it is at must not be interrupted
  std::optional<SessionPhase> obeying_;  // what follows from an item that nobody waits for
  StatePointer given_up_;                // a state whose motions cannot be solved

  // The worker's own.
  SessionEngine engine_;
  SessionJournal journal_;
  DragPace pace_;       // of solving
  bool moves_ = false;  // a hand holds what was moved last
  std::thread worker_;
  std::mutex joining_;  // of the worker, by close() alone
};

}  // namespace legwright
