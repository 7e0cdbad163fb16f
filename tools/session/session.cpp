// SPDX-License-Identifier: Apache-2.0
#include "tools/session/session.hpp"

#include <algorithm>
#include <utility>

#include "mjcf/text/input_error.hpp"

namespace legwright {
namespace {

constexpr std::size_t kEventsKept = 1000;
// A process that dies during a search loses no more of it.
constexpr std::chrono::milliseconds kSearchNoted{500};

std::vector<std::string> names_of(const session::Edit& edit) {
  std::vector<std::string> names;
  for (const auto& [name, value] : edit.values) names.push_back(name);
  return names;
}

std::string end_words(const SearchEnd& end) {
  switch (end.status) {
    case SolveStatus::converged:
      return "converged: no body near is better";
    case SolveStatus::stopped:
      return "paused";
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
    case Kind::failed:
      return "failed";
  }
  return "unknown";
}

Session::Session(const RobotModel& robot, const std::string& text,
                 const std::filesystem::path& file, const Options& options)
    : engine_(robot, text, file, options.threads),
      journal_(begin_of(robot, text, file), options.journal) {
  engine_.set_stop([this] { return interrupted(); });
  show();
  const auto done = std::make_shared<std::promise<void>>();
  queue_.push_back({[this, &options] { obey_all(options.commands); }, done, {}});
  worker_ = std::thread([this] { run(); });
  try {
    done->get_future().get();
  } catch (...) {
    end();
    throw;
  }
}

Session::~Session() { end(); }

void Session::end() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  changed_.notify_all();
  worker_.join();
  for (Item& item : queue_)
    if (item.done)
      item.done->set_exception(
          std::make_exception_ptr(std::runtime_error("the session is closed")));
}

bool Session::interrupted() const {
  const std::lock_guard lock(mutex_);
  return !held_ && (closing_ || !queue_.empty());
}

// ---- the worker ----

bool Session::has_work() const {
  if (!queue_.empty() || searching_) return true;
  const SessionState& state = *snapshot_->state;
  return !state.settled() && snapshot_->state != given_up_;
}

void Session::run() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return closing_ || has_work(); });
    if (closing_) return;
    busy_ = true;
    if (!queue_.empty()) {
      Item item = std::move(queue_.front());
      queue_.pop_front();
      lock.unlock();
      obey(item);
    } else {
      phase_ = searching_ ? SessionPhase::searching : SessionPhase::solving;
      lock.unlock();
      work();
    }
    lock.lock();
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
    else
      settle();
  } catch (const std::exception& error) {  // a full disk, no memory
    {
      const std::lock_guard lock(mutex_);
      searching_ = false;
      given_up_ = engine_.state();
    }
    publish(SessionEvent::Kind::failed, error.what());
  }
}

void Session::obey(Item& item) {
  try {
    item.work();
    if (item.done) item.done->set_value();
  } catch (const std::exception& error) {
    if (item.done)
      item.done->set_exception(std::current_exception());
    else
      publish(SessionEvent::Kind::failed, error.what());
  }
}

void Session::search() {
  int points = 0;
  auto noted = std::chrono::steady_clock::now();
  const SearchEnd end = engine_.search(0, [&] {
    ++points;
    publish(SessionEvent::Kind::point);
    if (const auto now = std::chrono::steady_clock::now(); now - noted > kSearchNoted) {
      journal_.searching(points);
      noted = now;
    }
  });
  if (end.points > 0) note(session::Searched{end.points});
  {
    const std::lock_guard lock(mutex_);
    searching_ = false;
    phase_ = SessionPhase::idle;
  }
  publish(SessionEvent::Kind::ended, end_words(end));
}

void Session::settle() {
  const bool solved = engine_.settle();
  if (!solved && interrupted()) return;
  if (solved) note(session::Settled{});
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

void Session::note(const SessionCommand& command) {
  const std::lock_guard lock(mutex_);
  journal_.add(command);
}

/// Makes a snapshot of what is there.
void Session::show() {
  auto next = std::make_shared<SessionSnapshot>();
  next->state = engine_.state();
  next->can_undo = engine_.history().can_undo();
  next->can_redo = engine_.history().can_redo();
  next->names = engine_.history().names();
  const std::lock_guard lock(mutex_);
  next->phase = phase_;
  next->revision = ++revision_;
  snapshot_ = std::move(next);
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

// ---- all threads ----

void Session::enqueue(Item item) {
  {
    const std::lock_guard lock(mutex_);
    const bool replaces = !item.edits.empty() && !queue_.empty() &&
                          queue_.back().edits == item.edits && !queue_.back().done;
    if (replaces) queue_.pop_back();
    queue_.push_back(std::move(item));
  }
  changed_.notify_all();
}

void Session::call(std::function<void()> work) {
  auto done = std::make_shared<std::promise<void>>();
  enqueue({std::move(work), done, {}});
  done->get_future().get();
}

void Session::obey_all(const std::vector<SessionCommand>& commands) {
  const auto hold = [this](bool held) {
    const std::lock_guard lock(mutex_);
    held_ = held;
  };
  for (const SessionCommand& command : commands) {
    hold(std::holds_alternative<session::Searched>(command) ||
         std::holds_alternative<session::Settled>(command) ||
         std::holds_alternative<session::Step>(command));
    try {
      engine_.apply(command);
    } catch (...) {
      hold(false);
      throw;
    }
    hold(false);
    note(command);
  }
  if (!commands.empty()) publish(SessionEvent::Kind::changed);
}

void Session::apply(SessionCommand command) {
  call([this, command = std::move(command)] { obey_all({command}); });
}

void Session::post(SessionCommand command) {
  std::vector<std::string> edits;
  if (const auto* edit = std::get_if<session::Edit>(&command)) edits = names_of(*edit);
  enqueue(
      {[this, command = std::move(command)] { obey_all({command}); }, nullptr, std::move(edits)});
}

void Session::start() {
  {
    const std::lock_guard lock(mutex_);
    if (searching_ && queue_.empty()) return;
  }
  enqueue({[this] {
             const std::lock_guard lock(mutex_);
             searching_ = true;
           },
           nullptr,
           {}});
}

void Session::pause() {
  call([] {});
}

bool Session::step() {
  bool moved = false;
  call([this, &moved] {
    moved = engine_.step();
    if (!moved) return;
    note(session::Step{});
    publish(SessionEvent::Kind::changed);
  });
  return moved;
}

bool Session::wait(std::chrono::milliseconds limit) {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, limit, [this] { return !busy_ && !has_work(); });
}

SnapshotPointer Session::snapshot() const {
  const std::lock_guard lock(mutex_);
  return snapshot_;
}

std::vector<SessionEvent> Session::events(std::uint64_t after,
                                          std::chrono::milliseconds limit) const {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, limit, [&] { return event_count_ > after || closing_; });
  std::vector<SessionEvent> out;
  for (const SessionEvent& event : events_)
    if (event.number > after) out.push_back(event);
  return out;
}

SessionRecord Session::record() {
  SessionRecord out;
  call([&] {
    out.state = engine_.state();
    const std::lock_guard lock(mutex_);
    out.journal = journal_.text();
  });
  return out;
}

}  // namespace legwright
