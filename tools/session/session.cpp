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

std::vector<std::string> names_of(const session::Edit& edit) {
  std::vector<std::string> names;
  for (const auto& [name, value] : edit.values) names.push_back(name);
  return names;
}

constexpr const char* kPaused = "paused";

std::exception_ptr closed() {
  return std::make_exception_ptr(std::invalid_argument("the session is closed"));
}

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
  queue_.push_back({[this, &options] { obey_all(options.commands); }, done, std::nullopt});
  worker_ = std::thread([this] { run(); });
  try {
    done->get_future().get();
  } catch (...) {
    close();
    throw;
  }
}

Session::~Session() { close(); }

void Session::close() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;  // nothing enters the queue from here on
  }
  changed_.notify_all();
  const std::lock_guard joining(joining_);
  if (!worker_.joinable()) return;
  worker_.join();
  for (Item& item : queue_)
    if (item.done) item.done->set_exception(closed());
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
      // A search that was asked for and has not begun is paused, too.
      const bool paused = !item.starts && std::exchange(searching_, false);
      lock.unlock();
      if (paused) publish(SessionEvent::Kind::ended, kPaused);
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
  } catch (const std::exception& error) {  // no memory
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

// ---- all threads ----

void Session::enqueue(Item item) {
  {
    const std::lock_guard lock(mutex_);
    if (closing_) std::rethrow_exception(closed());
    if (item.edit && !queue_.empty() && queue_.back().edit &&
        names_of(*queue_.back().edit) == names_of(*item.edit)) {
      // One that begins a change of its own still does.
      item.edit->goes_on = item.edit->goes_on && queue_.back().edit->goes_on;
      queue_.pop_back();
    }
    queue_.push_back(std::move(item));
  }
  changed_.notify_all();
}

void Session::call(std::function<void()> work) {
  auto done = std::make_shared<std::promise<void>>();
  enqueue({std::move(work), done, std::nullopt});
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
  if (auto* edit = std::get_if<session::Edit>(&command))
    enqueue({{}, nullptr, std::move(*edit)});
  else
    enqueue({[this, command = std::move(command)] { obey_all({command}); }, nullptr, std::nullopt});
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
           nullptr, std::nullopt, true});
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
  const auto idle = [this] { return !busy_ && !has_work(); };
  changed_.wait_for(lock, limit, [&] { return closing_ || idle(); });
  return idle();
}

SnapshotPointer Session::snapshot() const {
  const std::lock_guard lock(mutex_);
  return snapshot_;
}

SnapshotPointer Session::next_snapshot(std::uint64_t revision,
                                       std::chrono::milliseconds limit) const {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, limit, [&] { return snapshot_->revision != revision || closing_; });
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
    out.journal = journal_.text();
  });
  return out;
}

}  // namespace legwright
