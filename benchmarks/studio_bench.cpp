// SPDX-License-Identifier: Apache-2.0
// How long after a page's edit the server has told what is to be drawn, and what is solved.
// Usage: studio_bench TASK.toml …   Writes JSON to stdout.
#include <stdlib.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "tools/studio/studio_service.hpp"

namespace {

using namespace legwright;
using Clock = std::chrono::steady_clock;

constexpr int kEdits = 60;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

Json figures(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  const auto share = [&](double p) {
    return times[static_cast<std::size_t>(p * (times.size() - 1))];
  };
  return {{"p50", share(0.5)}, {"p95", share(0.95)}, {"count", times.size()}};
}

/// Follows the hub as a page does.
class Follower {
 public:
  explicit Follower(const EventHub& hub) : hub_(hub) {}

  template <class Enough>
  void until(const Enough& enough) {
    for (;;)
      for (const StudioEvent& event : hub_.after(last_, 0, std::chrono::milliseconds(1000))) {
        last_ = event.number;
        if (enough(event.kind, Json::parse(*event.json))) return;
      }
  }

 private:
  const EventHub& hub_;
  std::uint64_t last_ = 0;
};

bool is_settled(const Json& state, std::uint64_t revision) {
  return state["revision"] >= revision && state["settled"] && state["phase"] == "idle";
}

Json measure(StudioService& studio, const std::string& task) {
  const auto start = Clock::now();
  studio.open(task);
  Follower follower(studio.hub());
  follower.until([](const std::string& kind, const Json&) { return kind == "motion"; });
  const double first = milliseconds_since(start);
  follower.until([](const std::string& kind, const Json& data) {
    return kind == "state" && is_settled(data, 0);
  });
  const DesignParameter& one = studio.workspace()->robot().space.parameters.front();
  std::vector<double> answered, drawn, solved;
  for (int k = 0; k < kEdits; ++k) {
    const double value = one.initial + 0.3 * (one.upper - one.initial) * (k + 1) / kEdits;
    const auto edit = Clock::now();
    const StudioReply reply =
        studio.answer({"POST",
                       "/api/command",
                       {},
                       {{"do", "edit"}, {"values", {{one.name, value}}}, {"goes_on", k > 0}}});
    const auto revision = Json::parse(reply.json).at("revision").get<std::uint64_t>();
    answered.push_back(milliseconds_since(edit));
    bool seen = false;
    follower.until([&](const std::string& kind, const Json& data) {
      if (kind == "motion" && !seen && data["revision"].get<std::uint64_t>() + 1 >= revision) {
        seen = true;
        drawn.push_back(milliseconds_since(edit));
      }
      return seen && kind == "state" && is_settled(data, revision);
    });
    solved.push_back(milliseconds_since(edit));
  }
  return {{"task", task},
          {"first_motion_ms", first},
          {"edit_answered_ms", figures(answered)},
          {"edit_drawn_ms", figures(drawn)},
          {"edit_solved_ms", figures(solved)}};
}

}  // namespace

int main(int argc, char** argv) {
  std::string folder = (std::filesystem::temp_directory_path() / "legwright-bench-XXXXXX").string();
  if (!::mkdtemp(folder.data())) return 1;
  Json out = Json::array();
  for (int k = 1; k < argc; ++k) {
    const std::filesystem::path task = std::filesystem::absolute(argv[k]);
    StudioService studio({{task.parent_path()}, folder, {}, {}, {}});
    out.push_back(measure(studio, task.string()));
  }
  std::filesystem::remove_all(folder);
  std::printf("%s", to_text(out).c_str());
  return 0;
}
