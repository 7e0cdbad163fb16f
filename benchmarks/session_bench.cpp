// SPDX-License-Identifier: Apache-2.0
// How quickly a session answers: from an edit to the predicted motion and to the solved one, from a
// command to the end of a search, and how many points a search shows a second. One thread.
// Usage: session_bench TASK…
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include "tools/session/session.hpp"

namespace legwright {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr int kEdits = 100, kPauses = 20;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Sample quantile of times that were measured.
double quantile(std::vector<double> times, double share) {
  std::sort(times.begin(), times.end());
  const auto last = static_cast<double>(times.size() - 1);
  return times.at(static_cast<std::size_t>(std::lround(share * last)));
}

struct Times {
  std::vector<double> predicted, solved, cancelled;
  double first = 0.0, points_per_second = 0.0;
  int points = 0;
};

/// Waits for the next event of a kind. @param after number of the last one seen
SessionEvent await(const Session& session, SessionEvent::Kind kind, std::uint64_t& after) {
  for (;;)
    for (const SessionEvent& event : session.events(after, 100ms)) {
      after = event.number;
      if (event.kind == kind) return event;
    }
}

/// Turns parameters one after the other by a percent of their natural unit, as a handle does.
void time_edits(Session& session, int count, Times& times) {
  const DesignSpace space = session.snapshot()->state->space();
  std::uint64_t seen = 0;
  for (int k = 0; k < count; ++k) {
    const SnapshotPointer before = session.snapshot();
    const int i = k % space.size();
    const DesignParameter& parameter = space.parameters[i];
    const double now = before->state->s()[i], change = 0.01 * space.scale()[i];
    const double value = now + change <= parameter.upper ? now + change : now - change;
    if (value < parameter.lower) continue;
    for (const SessionEvent& event : session.events(seen, 0ms)) seen = event.number;
    const auto start = Clock::now();
    session.apply(session::Edit{{{parameter.name, value}}});
    times.predicted.push_back(milliseconds_since(start));
    (void)await(session, SessionEvent::Kind::solved, seen);
    times.solved.push_back(milliseconds_since(start));
  }
}

void time_cancels(Session& session, int count, Times& times) {
  for (int k = 0; k < count; ++k) {
    session.apply(session::Reset{});
    session.start();
    std::this_thread::sleep_for(std::chrono::milliseconds(150 + 37 * k));  // somewhere on its way
    const auto start = Clock::now();
    session.pause();
    times.cancelled.push_back(milliseconds_since(start));
  }
}

Times measure(const std::string& task) {
  CodesignProblem problem = read_problem(task);
  Session::Options options;
  options.threads = 1;
  Session session(problem.robot, problem.set.text, problem.set.file, options);
  Times times;
  time_cancels(session, kPauses, times);
  session.apply(session::Reset{});
  std::uint64_t seen = 0;
  for (const SessionEvent& event : session.events(seen, 0ms)) seen = event.number;
  const auto start = Clock::now();
  session.start();
  (void)await(session, SessionEvent::Kind::point, seen);
  times.first = milliseconds_since(start);
  (void)await(session, SessionEvent::Kind::ended, seen);
  const double seconds = (milliseconds_since(start) - times.first) / 1000.0;
  (void)session.wait();
  times.points = session.snapshot()->state->iterations;
  times.points_per_second = (times.points - 1) / seconds;
  time_edits(session, kEdits, times);
  return times;
}

}  // namespace
}  // namespace legwright

int main(int argc, char** argv) {
  using namespace legwright;
  const std::vector<std::string> tasks(argv + 1, argv + argc);
  fmt::print(
      "| task | edit to prediction p50, p95 [ms] | edit to solved p50, p95 [ms] | pause p50, "
      "most [ms] | first point [s] | points | points/s |\n|---|---|---|---|---|---|---|\n");
  for (const std::string& task : tasks) {
    const Times t = measure(task);
    fmt::print("| {} | {:.1f}, {:.1f} | {:.0f}, {:.0f} | {:.0f}, {:.0f} | {:.2f} | {} | {:.0f} |\n",
               task, quantile(t.predicted, 0.5), quantile(t.predicted, 0.95),
               quantile(t.solved, 0.5), quantile(t.solved, 0.95), quantile(t.cancelled, 0.5),
               quantile(t.cancelled, 1.0), t.first / 1000.0, t.points, t.points_per_second);
    std::fflush(stdout);
  }
  return 0;
}
