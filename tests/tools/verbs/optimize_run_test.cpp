// SPDX-License-Identifier: Apache-2.0
// A co-design that is followed from within the process: what its follower may do meanwhile.
#include "tools/verbs/optimize_run.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>

#include "tests/mjcf/robots/robots.hpp"
#include "tests/mjcf/robots/split_robot.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/json_file.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/verbs/save_session.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

const fs::path kExamples = fs::path(LEGWRIGHT_SOURCE_DIR) / "examples";

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
  test::write_split_puppy(home);
  write_file(home / "sideways.toml", test::with(read_file(kExamples / "puppy" / "sideways.toml"),
                                                "\"robot.xml\"", "\"dog.xml\""));
  options_.max_iterations = 2;
  follower_.on_iteration = [&](const RunLabel&, const DesignIteration& iteration) {
    if (iteration.index == 0) fs::remove_all(home);
    return true;
  };
  const RunRecord record = run(home / "sideways.toml");
  EXPECT_NE(record.status, "failed");
  EXPECT_TRUE(record.choice);  // physics has played it, too, with its meshes
  EXPECT_TRUE(fs::is_regular_file(run_ / "result/assets/ear.stl"));
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

// A session is saved as a run; its verbs take it.
TEST(SaveSession, IsARunThatCanBeOpenedAndReplayed) {
  const test::TemporaryFolder root;
  const fs::path task = kExamples / "quadruped" / "both.toml";
  const RobotModel robot = read_robot(kExamples / "quadruped" / "robot.xml");
  Session session(robot, read_file(task), task);
  (void)session.step();
  session.apply(session::Weights{{0.25, 0.75}});
  const SessionRecord record = session.record();
  const ResultFolder folder = ResultFolder::create(root.path() / "run", false);
  save_session(record, folder);
  const Json run = read_json(folder.run_json());
  EXPECT_EQ(run["status"], "stopped");
  EXPECT_EQ(run["parameters"][0]["final"].get<double>(), record.state->s()[0]);
  EXPECT_NEAR(run["final_F"].get<double>(), record.state->value(), 1e-6 * record.state->value());
  EXPECT_TRUE(fs::is_regular_file(root.path() / "run/tasks/pace/result/scene.xml"));
  // Its inputs have the weights that it was left with, and lead there.
  const TaskSet tasks = read_task_set(folder.inputs() / "task.toml");
  EXPECT_EQ(tasks.tasks[1].weight, 0.75);
  Session::Options options;
  options.commands = read_journal(folder.inputs() / "session.jsonl").commands;
  Session again(robot, read_file(task), task, options);
  EXPECT_EQ(again.snapshot()->state->s(), record.state->s());
  EXPECT_EQ(again.snapshot()->state->weights, record.state->weights);
}

}  // namespace
}  // namespace legwright
