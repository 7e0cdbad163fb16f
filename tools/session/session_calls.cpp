// SPDX-License-Identifier: Apache-2.0
// What other threads ask of a session: its begin and end, commands into the queue, snapshots and
// events out of it.
#include <algorithm>
#include <utility>

#include "tools/session/session.hpp"

namespace legwright {
namespace {

std::vector<std::string> names_of(const session::Edit& edit) {
  std::vector<std::string> names;
  for (const auto& [name, value] : edit.values) names.push_back(name);
  return names;
}

std::exception_ptr closed() { return std::make_exception_ptr(SessionClosed()); }

}  // namespace

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

void Session::obey_all(const std::vector<SessionCommand>& commands, bool held) {
  const auto hold = [this](bool on) {
    const std::lock_guard lock(mutex_);
    held_ = on;
  };
  for (const SessionCommand& command : commands) {
    hold(std::holds_alternative<session::Searched>(command) ||
         std::holds_alternative<session::Settled>(command) ||
         std::holds_alternative<session::Choose>(command) ||
         std::holds_alternative<session::Step>(command));
    const StatePointer before = engine_.state();
    try {
      engine_.apply(command);
    } catch (...) {
      hold(false);
      throw;
    }
    hold(false);
    note(engine_.as_done(command, *before));
  }
  if (commands.empty()) return;
  moves_ = held;
  if (held) pace_.move(DragPace::Clock::now());
  publish(SessionEvent::Kind::changed);
}

void Session::apply(SessionCommand command, bool held) {
  call([this, command = std::move(command), held] { obey_all({command}, held); });
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

void Session::work_out(AlternativeKind kind) {
  call([this, kind] {
    check_workable(kind, *engine_.state());
    const std::lock_guard lock(mutex_);
    working_out_ = kind;
  });
}

void Session::pause() {
  call([] {});
}

bool Session::step() {
  bool moved = false;
  call([this, &moved] {
    moved = engine_.step();
    if (!moved) return;
    note(session::Step{found_in(*engine_.state())});
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
  const SessionPhase phase = pending();
  if (phase == snapshot_->phase) return snapshot_;
  auto now = std::make_shared<SessionSnapshot>(*snapshot_);
  now->phase = phase;
  return now;
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
