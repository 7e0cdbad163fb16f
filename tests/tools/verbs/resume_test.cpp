// SPDX-License-Identifier: Apache-2.0
// legwright optimize --resume: a search that was killed or stopped goes on, to the same bytes.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <thread>

#include "tests/support/long_tests.hpp"
#include "tests/tools/verbs/program.hpp"
#include "tools/run/checkpoint_file.hpp"
#include "tools/run/events.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::Outcome;

/// Without what tells of time, memory and the command line.
Json timeless(const Json& json) {
  if (json.is_array()) {
    Json out = Json::array();
    for (const Json& each : json) out.push_back(timeless(each));
    return out;
  }
  if (!json.is_object()) return json;
  Json out = Json::object();
  for (const auto& [key, value] : json.items())
    if (!key.starts_with("seconds") && !key.ends_with("seconds") && key != "argv" &&
        key != "peak_rss_mib")
      out[key] = timeless(value);
  return out;
}

/// What the files of a run hold.
std::map<std::string, std::string> contents(const fs::path& run) {
  std::map<std::string, std::string> out;
  for (const auto& entry : fs::recursive_directory_iterator(run)) {
    if (!entry.is_regular_file() || entry.path().filename() == ".lock") continue;
    std::string& text = out[entry.path().lexically_relative(run).string()];
    if (entry.path().extension() == ".json")
      text = timeless(read_json(entry.path())).dump();
    else if (entry.path().extension() == ".jsonl")
      for (const Json& event : read_events(entry.path())) text += timeless(event).dump() + "\n";
    else
      text = read_file(entry.path());
  }
  return out;
}

/// Of a file that may go away meanwhile: nothing then.
std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class Resume : public testing::Test, protected test::CallsInFolder {
 protected:
  fs::path run() const { return folder_.path() / "run"; }
  fs::path states() const { return run() / "checkpoint/states.bin"; }
  static std::string task(const char* name) { return (test::kExamples / "puppy" / name).string(); }

  /// Starts the program and signals it once its search has kept more than it began with, and a
  /// state of that name. @return the code that it ended with
  int signalled(int signal, const std::vector<std::string>& words, const std::string& name = "") {
    const pid_t child = test::start(words, elsewhere_.path());
    std::error_code none;
    std::uintmax_t first = 0;
    for (int status = 0;;) {
      if (::waitpid(child, &status, WNOHANG) == child)
        return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
      std::uintmax_t most = 0;  // of the run, or of the build beside it
      for (const auto& entry : fs::directory_iterator(folder_.path())) {
        const fs::path kept = entry.path() / "checkpoint/states.bin";
        const auto size = fs::file_size(kept, none);
        if (!none && contains(text_of(kept), name)) most = std::max(most, size);
      }
      if (first == 0) first = most;
      if (most > first) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ::kill(child, signal);
    return test::wait_for(child, elsewhere_.path()).code;
  }
  std::vector<std::string> begin(const char* name, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{"optimize", task(name), "--no-pictures", "-o", run().string()};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  /// A search with steps on the gait, which MuJoCo plays some dozen times in a few seconds.
  std::vector<std::string> begin_stepping(const fs::path& into) const {
    const fs::path file = folder_.path() / "trot.toml";
    if (!fs::exists(file))
      write_file(file, "robot = \"" + (test::kExamples / "quadruped/robot.xml").string() +
                           "\"\n[gait]\nname = \"trot\"\nperiod = 0.4\nknots = 12\n"
                           "[travel]\nvelocity = [0.1, 0.0]\n");
    return {"optimize",
            file.string(),
            "--no-pictures",
            "--no-reasons",
            "--plan-only",
            "--physics-steps",
            "2",
            "-o",
            into.string()};
  }
  std::string err() const { return read_file(elsewhere_.path() / "err"); }

  test::TemporaryFolder elsewhere_;
};

TEST_F(Resume, AfterManyKillsAndStopsEveryFileIsThatOfAWholeRun) {
  ASSERT_LE(call({"optimize", task("sideways.toml"), "--no-pictures", "-o", "whole"}).code, 1);
  const int kills = test::long_tests() ? 30 : 4, stops = test::long_tests() ? 8 : 4;
  const std::vector<std::string> resume{"optimize", "--resume", run().string()};
  ASSERT_EQ(signalled(SIGKILL, begin("sideways.toml")), -SIGKILL);
  for (int k = 1; k < kills; ++k) {
    const int signal = k % 3 == 0 ? SIGTERM : SIGKILL;
    ASSERT_EQ(signalled(signal, resume), signal == SIGTERM ? 75 : -SIGKILL) << err();
  }
  for (int k = 1; k <= stops; ++k) {  // while it catches up with itself
    const pid_t child = test::start(resume, elsewhere_.path());
    ::usleep(40'000 * k * 8 / stops);
    ::kill(child, SIGTERM);
    const Outcome stopped = test::wait_for(child, elsewhere_.path());
    ASSERT_TRUE(stopped.code == 75 || stopped.code == -SIGTERM) << stopped.code << stopped.err;
  }
  test::tell_tries("kills and stops of a search that went on", kills + stops);
  const Outcome last = call({"optimize", "--resume", "run"});
  EXPECT_LE(last.code, 1) << last.err;
  EXPECT_EQ(contents(run()), contents(folder_.path() / "whole"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 4)
      << "run, whole, out and err";
}

TEST_F(Resume, AStoppedSearchSaysHowItGoesOnAndDoes) {
  const std::vector<std::string> words = begin("sideways.toml", {"--plan-only", "--no-reasons"});
  std::vector<std::string> whole = words;
  whole[4] = "whole";
  ASSERT_LE(call(whole).code, 1);
  ASSERT_EQ(signalled(SIGTERM, words), 75) << err();
  EXPECT_TRUE(contains(err(), "--resume " + run().string())) << err();
  EXPECT_TRUE(fs::exists(states()));
  EXPECT_EQ(call({"report", "run"}).code, 0) << "what there is can be looked at";
  fs::remove(run() / "report.html");
  const Outcome anew = call({"optimize", task("sideways.toml"), "-o", "run"});
  EXPECT_EQ(anew.code, 3);
  EXPECT_TRUE(contains(anew.err, "go on with its search")) << anew.err;
  EXPECT_LE(call({"optimize", "--resume", "run"}).code, 1);
  EXPECT_EQ(contents(run()), contents(folder_.path() / "whole"));
  const Outcome again = call({"optimize", "--resume", "run"});
  EXPECT_EQ(again.code, 3);
  EXPECT_TRUE(contains(again.err, "came to its end")) << again.err;
  Json record = read_json(run() / "run.json");
  record["status"] = "running";  // as where a disk is full before there is a state
  write_json(run() / "run.json", record);
  const Outcome broken_off = call({"optimize", "--resume", "run"});
  EXPECT_EQ(broken_off.code, 3);
  EXPECT_TRUE(contains(broken_off.err, "before it had a state to go on from; begin anew"))
      << broken_off.err;
}

TEST_F(Resume, ItIsRefusedAfterAnythingChanged) {
  const fs::path own = folder_.path() / "own.toml";
  const std::string text = "robot = \"" + (test::kExamples / "puppy/robot.xml").string() +
                           "\"\n[gait]\nname = \"trot\"\nperiod = 0.5\n[travel]\n"
                           "velocity = [0.1, 0.0]\n";
  write_file(own, text);
  std::vector<std::string> words = begin("sideways.toml", {"--plan-only", "--no-reasons"});
  words[1] = own.string();
  ASSERT_EQ(signalled(SIGKILL, words), -SIGKILL);

  write_file(own, text + "turn_rate = 0.1\n");
  const Outcome other = call({"optimize", "--resume", "run"});
  EXPECT_EQ(other.code, 2);
  EXPECT_TRUE(contains(other.err, "inputs/task.toml is not what")) << other.err;
  EXPECT_TRUE(contains(other.err, "--force")) << other.err;
  write_file(own, text);

  const fs::path begin_json = run() / "checkpoint/begin.json";
  Json begun = read_json(begin_json);
  begun["versions"]["legwright"] = "0.0.1";
  write_json(begin_json, begun);
  const Outcome older = call({"optimize", "--resume", "run"});
  EXPECT_EQ(older.code, 2);
  EXPECT_TRUE(contains(older.err, "--anyway") && contains(older.err, "0.0.1")) << older.err;
  EXPECT_TRUE(fs::exists(states())) << "a refusal costs nothing";
  EXPECT_LE(call({"optimize", "--resume", "run", "--anyway"}).code, 1);

  const Outcome more = call({"optimize", "t.toml", "--resume", "run", "--seed", "3", "--force"});
  EXPECT_EQ(more.code, 2);
  EXPECT_TRUE(contains(more.err, "leave out TASK, --seed, --force")) << more.err;
  EXPECT_EQ(call({"optimize", own.string(), "--anyway"}).code, 2);
  EXPECT_EQ(call({"optimize", "--resume", "nowhere"}).code, 3);
  const Outcome nothing = call({"optimize"});
  EXPECT_EQ(nothing.code, 2);
  EXPECT_TRUE(contains(nothing.err, "TASK")) << nothing.err;
}

TEST_F(Resume, OneThatWasToReplaceARunDoesSoInTheEnd) {
  ASSERT_LE(call(begin("sideways.toml", {"--motion-only", "--plan-only"})).code, 1);
  const std::string before = read_file(run() / "run.json");
  const std::vector<std::string> fast{"--plan-only", "--no-reasons", "--force"};
  ASSERT_EQ(signalled(SIGKILL, begin("sideways_trot.toml", fast)), -SIGKILL);
  EXPECT_EQ(read_file(run() / "run.json"), before);
  EXPECT_EQ(call({"report", "run"}).code, 0);

  // Killed again while the old run is still there, it goes on from what the second process kept.
  EXPECT_EQ(signalled(SIGKILL, {"optimize", "--resume", run().string()}), -SIGKILL);
  EXPECT_LE(call({"optimize", "--resume", "run"}).code, 1);
  EXPECT_EQ(read_json(run() / "run.json")["task"]["gait"], "trot");
  EXPECT_FALSE(fs::exists(states()));
}

/// The state of a gait that was played, with so many more roll-outs than it took.
std::vector<double> with_rollouts(std::vector<double> state, int more) {
  double origin = 0.0, distance = 0.0, speed = 0.0, drift = 0.0;
  bool pass = false;
  Eigen::VectorXd residual;
  std::string line;
  int rollouts = 0;
  const auto all = [&](SolveState& of) {
    of(origin);
    of(pass);
    of(residual);
    of(line);
    for (double* const member : {&distance, &speed, &drift}) of(*member);
    of(rollouts);
  };
  SolveState read(state), written;
  all(read);
  EXPECT_GT(rollouts, 0);
  rollouts += more;
  all(written);
  std::copy(written.numbers().begin(), written.numbers().end(), state.begin());
  return state;
}

/// What a killed search had played counts: a false number of it comes out in the end.
TEST_F(Resume, StepsOnTheGaitTakeUpWhatWasPlayed) {
  constexpr int kMore = 1000;
  const std::vector<std::string> words = begin_stepping(run());
  const std::string steps = "physics steps";
  ASSERT_EQ(signalled(SIGKILL, words, steps), -SIGKILL) << err();
  std::optional<ReadCheckpoint> kept = read_checkpoint(run());
  ASSERT_TRUE(kept);
  int played = 0;
  for (auto& [name, state] : kept->states) {
    if (!contains(name, steps)) continue;
    state = with_rollouts(std::move(state), kMore);
    ++played;
  }
  ASSERT_GT(played, 0);
  CheckpointFile(run(), kept->begin, kept->states);
  EXPECT_EQ(call({"optimize", "--resume", run().string()}).code, 0);
  const int told = read_json(run() / "run.json")["physics_steps"]["rollouts"];
  EXPECT_EQ(told / kMore, played);
}

TEST_F(Resume, StepsOnTheGaitEndInTheSameBytes) {
  LEGWRIGHT_LONG_TEST();
  std::vector<std::string> whole = begin_stepping(folder_.path() / "whole");
  whole.insert(whole.end(), {"--threads", "3"});  // at any number of them
  ASSERT_EQ(call(whole).code, 0);
  std::vector<std::string> words = begin_stepping(run());
  words.insert(words.end(), {"--threads", "1"});
  const std::vector<std::string> resume{"optimize", "--resume", run().string()};
  const std::string steps = "physics steps";
  ASSERT_EQ(signalled(SIGKILL, words, steps), -SIGKILL) << err();
  const int stopped = signalled(SIGTERM, resume, steps);
  ASSERT_TRUE(stopped == 75 || stopped == 0) << err();  // 0: what was left was done before
  if (stopped == 75) {
    EXPECT_EQ(call(resume).code, 0);
  }
  EXPECT_EQ(contents(run()), contents(folder_.path() / "whole"));
}

TEST_F(Resume, ASearchThatIsAtWorkIsLeftAlone) {
  // Of many starts: it is at work still, however late it is stopped.
  const pid_t child = test::start(begin("sideways.toml", {"--starts", "50"}), elsewhere_.path());
  for (int n = 0; n < 1000 && !fs::exists(states()); ++n) ::usleep(10'000);
  ::kill(child, SIGSTOP);
  const Outcome second = call({"optimize", "--resume", "run"});
  EXPECT_EQ(second.code, 3);
  EXPECT_TRUE(contains(second.err, "in use by process " + std::to_string(child))) << second.err;
  EXPECT_TRUE(fs::exists(states()));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
}

}  // namespace
}  // namespace legwright
