// SPDX-License-Identifier: Apache-2.0
// A co-design that is followed from within the process: what its follower may do meanwhile.
#include "tools/verbs/optimize_run.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <csignal>

#include "tests/mjcf/robots/robots.hpp"
#include "tests/mjcf/robots/split_robot.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/checksum.hpp"
#include "tools/files/json_file.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/verbs/save_session.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

const fs::path kExamples = fs::path(test::source_dir()) / "examples";

class OptimizeRun : public testing::Test {
 protected:
  static void SetUpTestSuite() { load_gait_plugin(); }
  OptimizeRun() {
    options_.quiet = options_.one_start = true;
    options_.no_pictures = options_.no_reasons = options_.no_certificate = true;
    options_.threads = 1;
  }
  RunRecord run(const fs::path& task) {
    CodesignProblem problem = read_problem(task.string(), "");
    CommandTimes times;
    const ResultFolder folder = ResultFolder::create(run_, false);
    return optimize_into(folder, problem, options_, follower_, times);
  }
  test::TemporaryFolder folder_;
  const fs::path run_ = folder_.path() / "run";
  OptimizeOptions options_;
  RunFollower follower_;
};

TEST_F(OptimizeRun, ARobotThatGoesAwayMeanwhileIsNotMissed) {
  const fs::path home = folder_.path() / "home";
  test::write_package_puppy(home);
  fs::copy_file(kExamples / "puppy" / "sideways.toml", home / "mjcf/sideways.toml");
  options_.max_iterations = 2;
  follower_.on_iteration = [&](const RunLabel&, const DesignIteration& iteration) {
    if (iteration.index == 0) fs::remove_all(home);
    return true;
  };
  const RunRecord record = run(home / "mjcf/sideways.toml");
  EXPECT_NE(record.status, "failed");
  EXPECT_TRUE(record.choice);  // physics has played it, too, with its meshes
  EXPECT_TRUE(fs::is_regular_file(run_ / "result/meshes/ear.stl"));
}

// Counts the questions after the search, so that the stop falls into the first roll-out.
TEST_F(OptimizeRun, AStopBeforeTheFirstVerdictIsAReasonForEveryTask) {
  options_.max_iterations = 1;
  constexpr int kQuestionsUntilTheStop = 20;
  std::atomic<bool> searched{false};
  std::atomic<int> questions{0};
  follower_.on_iteration = [&](const RunLabel&, const DesignIteration&) {
    searched = true;
    return false;
  };
  follower_.stop_signal = [&] {
    return searched && ++questions > kQuestionsUntilTheStop ? SIGINT : 0;
  };
  const RunRecord record = run(kExamples / "quadruped" / "both.toml");
  EXPECT_EQ(record.status, "interrupted");
  EXPECT_FALSE(record.choice);
  EXPECT_FALSE(record.feasible.value());
  for (const char* task : {"pace", "sideways"}) {
    const Json own = read_json(run_ / "tasks" / task / "run.json");
    EXPECT_FALSE(own["feasible"].get<bool>()) << task;
    EXPECT_EQ(own["reasons"].back(), "MuJoCo was not asked: the run was interrupted before");
  }
}

// Whoever stops the reasons at any moment gets those that are there; the fewest changes, which
// are fewer the longer they are looked for, are told when all are known.
TEST_F(OptimizeRun, AStopAmongTheReasonsKeepsThoseThatAreKnown) {
  options_.max_iterations = 1;
  options_.plan_only = true;
  options_.no_reasons = false;
  options_.threads = 2;
  std::size_t stopped_among_rows = 0;
  for (const int last : {30, 60}) {
    std::atomic<int> questions{0};
    follower_.stop_signal = [&] {
      return fs::exists(run_ / "result/scene.xml") && ++questions > last ? SIGINT : 0;
    };
    const RunRecord record = run(kExamples / "puppy" / "sideways.toml");
    ASSERT_TRUE(record.put_back) << last;
    EXPECT_FALSE(record.fewest_changes) << last;
    const auto changes = static_cast<std::size_t>(
        std::count_if(record.parameters.begin(), record.parameters.end(),
                      [](const auto& one) { return one.final != one.initial; }));
    const std::size_t rows = record.put_back->size();
    ASSERT_LE(rows, changes) << last;
    stopped_among_rows += rows > 0 && rows < changes ? 1 : 0;
    fs::remove_all(run_);
  }
  EXPECT_EQ(stopped_among_rows, 2U) << "this shows nothing";
}

// Its ends are the tasks solved alone.
TEST_F(OptimizeRun, ASearchThatIsEndedEarlyHasNoFront) {
  options_.one_start = false;
  options_.plan_only = true;
  options_.front = 1;
  follower_.on_iteration = [](const RunLabel&, const DesignIteration&) { return false; };
  std::vector<std::string> warnings;
  follower_.warn = [&](const std::string& what) { warnings.push_back(what); };
  const RunRecord record = run(kExamples / "quadruped" / "both.toml");
  EXPECT_EQ(record.status, "stopped");
  EXPECT_FALSE(record.front);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("no trade-off front"), std::string::npos) << warnings[0];
}

// A session is saved as a run; its verbs take it.
TEST(SaveSession, IsARunThatCanBeOpenedAndReplayed) {
  const test::TemporaryFolder root;
  const fs::path task = kExamples / "quadruped" / "both.toml";
  const RobotModel robot = read_robot(kExamples / "quadruped" / "robot.xml");
  Session session(robot, read_file(task), task);
  (void)session.step();
  session.apply(session::Weights{{0.25, 0.75}});
  const SessionRecord record = session.record();
  save_session(record, root.path() / "run", false);
  const ResultFolder folder = ResultFolder::open(root.path() / "run");
  const Json run = read_json(folder.run_json());
  EXPECT_EQ(run["status"], "designed in a session");
  EXPECT_EQ(run["parameters"][0]["final"].get<double>(), record.state->s()[0]);
  EXPECT_NEAR(run["final_F"].get<double>(), record.state->value(), 1e-6 * record.state->value());
  const fs::path pace = root.path() / "run/tasks/pace";
  EXPECT_EQ(read_json(pace / "run.json")["scenes"]["result/scene.xml"],
            sha256_hex(read_file(pace / "result/scene.xml")));
  // Its inputs have the weights that it was left with, and lead there.
  const TaskSet tasks = read_task_set(folder.inputs() / "task.toml");
  EXPECT_EQ(tasks.tasks[1].weight, 0.75);
  Session::Options options;
  options.commands = read_journal(folder.inputs() / "session.jsonl").commands;
  Session again(robot, read_file(task), task, options);
  EXPECT_EQ(again.snapshot()->state->s(), record.state->s());
  EXPECT_EQ(again.snapshot()->state->weights, record.state->weights);
  // What cannot be saved takes no run away.
  SessionState none = *record.state;
  DesignPoint point = *none.now;
  point.tasks[0].m.setConstant(std::numeric_limits<double>::quiet_NaN());
  none.now = std::make_shared<const DesignPoint>(point);
  none.cold.assign(none.cold.size(), false);
  const SessionRecord broken{std::make_shared<const SessionState>(none), record.journal};
  EXPECT_THROW(save_session(broken, root.path() / "run", true), InputError);
  EXPECT_EQ(read_json(folder.run_json()), run);
}

TEST(SaveSession, TheGivenBodyIsSolvedForOnceToTheSameBytes) {
  const test::TemporaryFolder root;
  const fs::path task = kExamples / "puppy" / "sideways.toml";
  Session session(read_robot(kExamples / "puppy" / "robot.xml"), read_file(task), task);
  ASSERT_TRUE(session.wait(std::chrono::minutes(2)));
  session.apply(session::Edit{{{"front_thigh_length", 0.061}}});
  const SessionRecord record = session.record();
  SessionState unknown = *record.state;
  unknown.given_motions = std::make_shared<GivenMotions>();
  int solves = 0;
  const auto solve = [&] {
    ++solves;
    return SolvedMotions{};
  };
  (void)record.state->given_motions->get(solve);
  EXPECT_EQ(solves, 0) << "the session began with it";
  save_session(record, root.path() / "known", false);
  save_session({std::make_shared<const SessionState>(unknown), record.journal},
               root.path() / "solved", false);
  (void)unknown.given_motions->get(solve);
  EXPECT_EQ(solves, 0) << "the next time it is known";
  EXPECT_EQ(read_file(root.path() / "known/iterations/0000/motion.csv"),
            read_file(root.path() / "solved/iterations/0000/motion.csv"));
}

}  // namespace
}  // namespace legwright
