// SPDX-License-Identifier: Apache-2.0
// Mutated trajectories and attributes in a host of their own: it plays them or refuses them with a
// reason; no signal, no exit, no mju_error, no number that is not finite.
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <functional>
#include <iterator>
#include <random>

#include "tests/plugin/engine.hpp"
#include "tests/plugin/mutate.hpp"
#include "tests/plugin/walker.hpp"

namespace legwright {
namespace {

constexpr int kCases = 2400;  // a seeded mutation each

enum class Outcome : int { none, played, refused, broken, mute_refusal, not_finite };

/// What the child tells its parent while it runs: the outcome of each case, so that after a crash
/// the first case without one is to blame.
struct Board {
  Outcome outcome[kCases];
};

std::string attribute(const char* key, const std::string& value) {
  return fmt::format(R"(<config key="{}" value="{}"/>)", key, value);
}

struct Mutation {
  const char* key;
  const char* good;
};

constexpr Mutation kChainKeys[] = {{"t0", "0.1"},       {"period", "0.6"},    {"travel", "0.1 0 0"},
                                   {"turn", "0.2"},     {"ff", "0.8"},        {"phase", "0.3"},
                                   {"speed", "1.2"},    {"blend_in", "0.02"}, {"rest", "home"},
                                   {"ghost_group", "3"}};

/// The model of a case; depends on its number only.
std::string model_of(int number) {
  std::mt19937 random(static_cast<unsigned>(1000 + number));
  if (number % 4 == 0) {  // a robot with feet and sensors, which may also be asked for nonsense
    WalkerOptions options;
    const Mutation& m = kChainKeys[static_cast<std::size_t>(number / 4) % std::size(kChainKeys)];
    const bool twice = std::string(m.key) == "travel" || std::string(m.key) == "turn";
    if (!twice && std::string(m.key) != "period")
      options.config += attribute(m.key, mutate(m.good, random, true));
    for (const char* const kind : {"phase", "planned_contact", "measured_contact", "tracking_error",
                                   "base_error", "torque_share"})
      options.sensors += gait_sensor(kind);
    if (number % 16 == 0) options.sensors += gait_sensor(mutate("base_error", random, true));
    std::string xml = walker(options);
    const std::size_t begin = xml.find("value=\"time_s") + 7, end = xml.find('"', begin);
    if (number % 8 == 0)
      xml.replace(begin, end - begin, mutate(xml.substr(begin, end - begin), random, true));
    return xml;
  }
  ChainOptions options = valid_options();
  if (number % 16 == 1) {
    options.kp = mutate("4", random, true);
  } else if (number % 16 == 2) {
    options.kd = mutate("0.1 0.1 0.1", random, true);
  } else if (number % 4 == 3) {
    const Mutation& m = kChainKeys[static_cast<std::size_t>(number / 4) % std::size(kChainKeys)];
    options.more_config = attribute(m.key, mutate(m.good, random, true));
  } else {
    options.trajectory = mutate(options.trajectory, random, true);
  }
  return plugin_chain(options);
}

/// Adds everything that the viewer can show to a scene.
void visualize(const mjModel* m, mjData* d) {
  mjvScene scene;
  mjv_defaultScene(&scene);
  mjv_makeScene(m, &scene, 600);
  mjvOption option;
  mjv_defaultOption(&option);
  std::fill_n(option.geomgroup, mjNGROUP, mjtByte{1});
  for (const int flag : {mjVIS_COM, mjVIS_CONTACTPOINT, mjVIS_CONTACTFORCE}) option.flags[flag] = 1;
  mjvCamera camera;
  mjv_defaultFreeCamera(m, &camera);
  mjv_updateScene(m, d, &option, nullptr, &camera, mjCAT_ALL, &scene);
  mjv_freeScene(&scene);
}

/// Load, make, steps, look, reset, copy, delete, as a viewer would do.
Outcome play(const std::string& xml, bool with_visualize) {
  try {
    const Loaded loaded = load(xml);
    if (!loaded.model) return loaded.error.size() > 10 ? Outcome::refused : Outcome::mute_refusal;
    const mjModel* const m = loaded.model.get();
    const DataPointer d(mj_makeData(m));
    for (int i = 0; i < 50; ++i) mj_step(m, d.get());
    if (with_visualize) visualize(m, d.get());
    const DataPointer copy(mj_copyData(nullptr, m, d.get()));
    mj_resetData(m, d.get());
    mj_step(m, d.get());
    mj_step(m, copy.get());
    for (const mjData* const data : {d.get(), copy.get()})
      for (int i = 0; i < m->nactuator; ++i)
        if (!std::isfinite(data->actuator_force[i])) return Outcome::not_finite;
    return Outcome::played;
  } catch (...) {
    return Outcome::broken;  // mju_error, which would have ended a host
  }
}

/// Plays cases first … kCases − 1 in a child. Returns the case at which the child died, else
/// kCases.
int play_in_child(Board& board, int first, const std::function<Outcome(int)>& play_case) {
  const pid_t child = fork();
  if (child == 0) {
    for (int i = first; i < kCases; ++i) board.outcome[i] = play_case(i);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  int reached = first;
  while (reached < kCases && board.outcome[reached] != Outcome::none) ++reached;
  return reached;
}

class MutatedTest : public EngineTest {
 protected:
  void SetUp() override {
    EngineTest::SetUp();
    void* const memory =
        mmap(nullptr, sizeof(Board), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    ASSERT_NE(memory, MAP_FAILED);
    board_ = new (memory) Board{};
  }
  void TearDown() override {
    munmap(board_, sizeof(Board));
    EngineTest::TearDown();
  }
  Board* board_ = nullptr;
};

TEST_F(MutatedTest, HostsSurviveMutatedTrajectoriesAndAttributes) {
  for (int first = 0; first < kCases;) {
    const int died =
        play_in_child(*board_, first, [](int i) { return play(model_of(i), i % 3 == 0); });
    if (died < kCases)
      ADD_FAILURE() << "the host ended in case " << died << ":\n" << model_of(died);
    first = died + 1;
  }
  int played = 0, refused = 0, reasons = 0;
  for (int i = 0; i < kCases; ++i) {
    const Outcome outcome = board_->outcome[i];
    played += outcome == Outcome::played;
    refused += outcome == Outcome::refused;
    EXPECT_TRUE(outcome == Outcome::played || outcome == Outcome::refused ||
                outcome == Outcome::none)
        << "outcome " << static_cast<int>(outcome) << " of case " << i << ":\n"
        << model_of(i);
    if (outcome != Outcome::refused || i % 10 != 0) continue;
    const std::string error = load(model_of(i)).error;
    reasons += error.find("legwright.") != std::string::npos ||
               error.find("XML Error") != std::string::npos;
    EXPECT_NE(error.find(':'), std::string::npos) << error;
  }
  take_warnings();
  EXPECT_GT(played, kCases / 5);
  EXPECT_GT(refused, kCases / 4);
  EXPECT_GT(reasons, refused / 20);
}

/// Negative control: a host that dies or breaks is noticed, and the case is named.
TEST_F(MutatedTest, HarnessNoticesDeathAndErrors) {
  const auto fragile = [](int i) {
    if (i == 7) _exit(1);
    if (i == 9) raise(SIGKILL);
    if (i == 11) {
      try {
        mju_error("provoked");
      } catch (...) {
        return Outcome::broken;
      }
    }
    return Outcome::played;
  };
  EXPECT_EQ(play_in_child(*board_, 0, fragile), 7);
  EXPECT_EQ(play_in_child(*board_, 8, fragile), 9);
  EXPECT_EQ(play_in_child(*board_, 10, fragile), kCases);
  EXPECT_EQ(board_->outcome[11], Outcome::broken);
}

}  // namespace
}  // namespace legwright
