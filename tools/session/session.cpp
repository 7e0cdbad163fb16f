// SPDX-License-Identifier: Apache-2.0
#include "tools/session/session.hpp"

#include <algorithm>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "mjcf/text/input_error.hpp"

namespace legwright {
namespace {

constexpr std::size_t kEventsKept = 1000;
// A process that dies during a search loses no more of it.
constexpr std::chrono::milliseconds kSearchNoted{500};

constexpr const char* kPaused = "paused";

std::string end_words(const SearchEnd& end) {
  switch (end.status) {
    case SolveStatus::converged:
      return "converged: no body near is better";
    case SolveStatus::stopped:
      return kPaused;
    case SolveStatus::not_finite:
      return "the cost is not finite here; change the body or the task";
    default:
      return "settled: F hardly falls any more";
  }
}

}  // namespace

std::string_view to_string(SessionPhase phase) {
  switch (phase) {
    case SessionPhase::idle:
      return "idle";
    case SessionPhase::solving:
      return "solving";
    case SessionPhase::searching:
      return "searching";
    case SessionPhase::working_out:
      return "working out";
  }
  return "unknown";
}

std::string_view to_string(SessionEvent::Kind kind) {
  using Kind = SessionEvent::Kind;
  switch (kind) {
    case Kind::changed:
      return "changed";
    case Kind::solved:
      return "solved";
    case Kind::unsolved:
      return "unsolved";
    case Kind::point:
      return "point";
    case Kind::ended:
      return "ended";
    case Kind::worked_out:
      return "worked out";
    case Kind::failed:
      return "failed";
  }
  return "unknown";
}

bool Session::interrupted() const {
  const std::lock_guard lock(mutex_);
  return !held_ && (closing_ || !queue_.empty());
}

bool Session::must_settle() const {
  return !snapshot_->state->settled() && snapshot_->state != given_up_;
}

bool Session::has_work() const {
  return !queue_.empty() || searching_ || must_settle() || working_out_;
}

/// What goes on once an item that nobody waits for is obeyed.
std::optional<SessionPhase> Session::phase_after(const Item& item) {
  if (item.starts) return SessionPhase::searching;
  if (!item.done) return SessionPhase::solving;
  return std::nullopt;
}

/// What goes on, or will once what waits is obeyed.
SessionPhase Session::pending() const {
  for (auto item = queue_.rbegin(); item != queue_.rend(); ++item)
    if (const auto phase = phase_after(*item)) return *phase;
  if (obeying_) return *obeying_;
  if (searching_) return SessionPhase::searching;
  if (must_settle()) return SessionPhase::solving;
  return working_out_ ? SessionPhase::working_out : SessionPhase::idle;
}

/// Waits until there is something to do, or the session is closed.
void Session::await_work(std::unique_lock<std::mutex>& lock) {
  const auto at_once = [this] {
    return closing_ || !queue_.empty() || searching_ || (working_out_ && !must_settle());
  };
  while (!at_once()) {
    if (!must_settle())
      changed_.wait(lock);
    else if (DragPace::Clock::now() < pace_.due())
      changed_.wait_until(lock, pace_.due());
    else
      return;
  }
}

void Session::run() {
  std::unique_lock lock(mutex_);
  for (;;) {
    await_work(lock);
    if (closing_) return;
    busy_ = true;
    if (!queue_.empty()) {
      Item item = std::move(queue_.front());
      queue_.pop_front();
      // A search that was asked for and has not begun is paused, too.
      const bool paused = !item.starts && std::exchange(searching_, false);
      const bool dropped = working_out_.has_value();
      working_out_.reset();
      obeying_ = phase_after(item);
      lock.unlock();
      if (dropped) publish(SessionEvent::Kind::worked_out, "stopped");
      if (paused) publish(SessionEvent::Kind::ended, kPaused);
      obey(item);
    } else {
      phase_ = searching_      ? SessionPhase::searching
               : must_settle() ? SessionPhase::solving
                               : SessionPhase::working_out;
      held_ = phase_ == SessionPhase::solving && pace_.must_end(DragPace::Clock::now());
      pace_.end();
      lock.unlock();
      work();
    }
    lock.lock();
    held_ = false;
    obeying_.reset();
    const bool was_idle = std::exchange(phase_, SessionPhase::idle) == SessionPhase::idle;
    if (!was_idle && !has_work()) {  // readers see that nothing goes on
      lock.unlock();
      show();
      lock.lock();
    }
    busy_ = false;
    changed_.notify_all();
  }
}

void Session::work() {
  try {
    show();
    if (phase_ == SessionPhase::searching)
      search();
    else if (phase_ == SessionPhase::solving)
      settle();
    else
      work_out_now(*working_out_);
  } catch (const std::exception& error) {  // no memory
    {
      const std::lock_guard lock(mutex_);
      searching_ = false;
      working_out_.reset();
      given_up_ = engine_.state();
    }
    publish(SessionEvent::Kind::failed, error.what());
  }
}

void Session::obey(Item& item) {
  moves_ = false;
  try {
    if (item.edit)
      obey_all({*item.edit});
    else
      item.work();
    if (item.done) item.done->set_value();
  } catch (const std::exception& error) {
    if (item.done)
      item.done->set_exception(std::current_exception());
    else
      publish(SessionEvent::Kind::failed, error.what());
  }
  if (!moves_) pace_.end();
}

void Session::search() {
  int points = 0;
  auto noted = std::chrono::steady_clock::now();
  const SearchEnd end = engine_.search(0, [&] {
    ++points;
    publish(SessionEvent::Kind::point);
    const auto now = std::chrono::steady_clock::now();
    if (points == 1 || now - noted > kSearchNoted) {
      write_journal([&] { journal_.searching(points); });
      noted = now;
    }
  });
  if (end.points > 0) note(session::Searched{end.points, found_in(*engine_.state())});
  {
    const std::lock_guard lock(mutex_);
    searching_ = false;
    phase_ = SessionPhase::idle;
  }
  publish(SessionEvent::Kind::ended, end_words(end));
}

void Session::settle() {
  const auto start = DragPace::Clock::now();
  const bool solved = engine_.settle();
  if (!solved && interrupted()) return;
  pace_.solved(DragPace::Clock::now() - start);
  if (solved) note(session::Settled{found_in(*engine_.state())});
  {
    const std::lock_guard lock(mutex_);
    phase_ = SessionPhase::idle;
    if (!solved) given_up_ = engine_.state();
  }
  if (solved)
    publish(SessionEvent::Kind::solved);
  else
    publish(SessionEvent::Kind::unsolved, "F is not finite for this body and motion");
}

void Session::work_out_now(AlternativeKind kind) {
  bool done = false;
  std::string why;
  try {
    done = engine_.work_out(kind, {});
  } catch (const InputError& error) {
    why = error.message();
  }
  if (!done && why.empty()) {
    if (interrupted()) return;
    why = "F is not finite on the way to other designs";
  }
  if (done) note(session::WorkedOut{std::string(to_string(kind)), engine_.worked_out(kind)});
  {
    const std::lock_guard lock(mutex_);
    working_out_.reset();
    phase_ = SessionPhase::idle;
  }
  publish(SessionEvent::Kind::worked_out, why);
}

void Session::note(const SessionCommand& command) {
  write_journal([&] { journal_.add(command); });
}

/// A full disk ends the file, not the session: what happened is kept in memory all the same.
void Session::write_journal(const std::function<void()>& write) {
  try {
    write();
  } catch (const std::system_error& error) {
    publish(
        SessionEvent::Kind::failed,
        std::string(error.what()) +
            "; the session goes on without that file: save and the journal as text have it all");
  }
}

/// Makes a snapshot of what is there.
void Session::show() {
  auto next = std::make_shared<SessionSnapshot>();
  next->state = engine_.state();
  next->can_undo = engine_.history().can_undo();
  next->can_redo = engine_.history().can_redo();
  next->names = engine_.history().names();
  next->kept = engine_.history().kept();
  next->alternatives = engine_.alternatives();
  {
    const std::lock_guard lock(mutex_);
    next->phase = phase_;
    next->revision = ++revision_;
    snapshot_ = std::move(next);
  }
  changed_.notify_all();
}

void Session::publish(SessionEvent::Kind kind, std::string words) {
  show();
  {
    const std::lock_guard lock(mutex_);
    events_.push_back({++event_count_, kind, snapshot_, std::move(words)});
    if (events_.size() > kEventsKept) events_.pop_front();
  }
  changed_.notify_all();
}

}  // namespace legwright
