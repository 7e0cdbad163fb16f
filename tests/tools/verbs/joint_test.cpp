// SPDX-License-Identifier: Apache-2.0
// Runs of several tasks: what is on disk, and that it is the same at any thread count.
#include <gtest/gtest.h>

#include <chrono>
#include <map>
#include <thread>

#include "tests/support/long_tests.hpp"
#include "tests/tools/verbs/judged_example.hpp"
#include "tests/tools/verbs/program.hpp"
#include "tests/tools/verbs/run_schemas.hpp"
#include "tools/run/events.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::call;
using test::contains;
using test::Outcome;

const std::string kBoth = (test::kExamples / "quadruped" / "both.toml").string();

class Joint : public testing::Test, protected test::CallsInFolder {
 protected:
  Json json(const char* file) const { return Json::parse(read_file(folder_.path() / file)); }
};

/// Everything in a run that must not depend on time or threads.
std::map<std::string, std::string> contents(const fs::path& run) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(run)) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_regular_file() || name == "run.json" || name == "events.jsonl") continue;
    files[fs::relative(entry.path(), run).string()] = read_file(entry.path());
  }
  return files;
}

TEST_F(Joint, RunIsCompleteAndItsTasksAreRunsOfTheirOwn) {
  const Outcome optimize = call(
      {"optimize", kBoth, "--plan-only", "--max-iterations", "2", "--no-pictures", "-o", "run"});
  ASSERT_LE(optimize.code, 1) << optimize.err;
  const Json run = json("run/run.json");
  ASSERT_EQ(run["tasks"].size(), 2u);
  EXPECT_EQ(run["starts"].size(), 3u);
  EXPECT_EQ(run["alone"].size(), 2u);
  double sum = 0.0;
  for (const Json& task : run["tasks"])
    sum += task["weight"].get<double>() * task["F"].get<double>();
  EXPECT_NEAR(run["final_F"].get<double>(), sum, 1e-9 * sum);
  for (const Json& start : run["starts"])
    EXPECT_GE(start["F"].get<double>(), run["final_F"].get<double>());
  for (const char* task : {"pace", "sideways"}) {
    const fs::path own = folder_.path() / "run" / "tasks" / task;
    for (const char* file :
         {"run.json", "events.jsonl", "inputs/task.toml", "iterations/0000/scene.xml",
          "iterations/0001/motion.csv", "result/robot.xml", "result/certificate.json"})
      EXPECT_TRUE(fs::is_regular_file(own / file)) << task << " " << file;
    EXPECT_EQ(read_file(own / "result" / "robot.xml"),
              read_file(folder_.path() / "run" / "result" / "robot.xml"))
        << "one body for all tasks";
    EXPECT_EQ(read_json(own / "run.json")["files"], run["files"]) << "as given";
    EXPECT_EQ(read_events(own / "events.jsonl").front()["event"], "start");
  }
  EXPECT_LT(run["certificate"]["worst_gradient_error"].get<double>(), 1e-4);

  const Outcome validate = call({"validate", "run", "--quick", "--junit", "out.xml"});
  const std::string junit = read_file(folder_.path() / "out.xml");
  EXPECT_TRUE(contains(junit, "<testsuite name=\"run.")) << junit.substr(0, 400);
  EXPECT_LE(validate.code, 1) << validate.err;
  const Json matrix = json("run/result/matrix.json");
  ASSERT_EQ(matrix["designs"].size(), 4u);
  for (const char* task : {"pace", "sideways"}) {
    ASSERT_EQ(matrix["cells"][task].size(), 4u);
    EXPECT_FALSE(matrix["cells"][task][0]["pass"].get<bool>()) << "the initial body";
  }
  auto seen = test::expect_schemas(folder_.path() / "run");
  EXPECT_EQ(seen["run"], 3);
  EXPECT_EQ(seen["certificate"], 3);
  EXPECT_EQ(seen["matrix"], 1);
  EXPECT_EQ(seen["event_start"], 3);
  EXPECT_GE(seen["event_joint_iteration"], 5);
  EXPECT_GE(seen["iteration"], 10);

  for (const char* played :
       {"starts/from-pace/sideways/iterations/0000/scene.xml", "tasks/sideways/result/scene.xml"}) {
    const fs::path scene = folder_.path() / "run" / played;
    const std::string whole = read_file(scene);
    write_file(scene, whole + "<!-- mine -->\n");
    const Outcome refused = call({"validate", "run", "--quick"});
    EXPECT_EQ(refused.code, 2) << refused.out;
    EXPECT_TRUE(contains(refused.err, std::string("run/") + played + ": was edited since"))
        << refused.err;
    write_file(scene, whole);
  }
}

TEST_F(Joint, InterruptedAfterATaskAloneItCanStillBeValidated) {
  LEGWRIGHT_LONG_TEST();
  const pid_t child =
      test::start({"optimize", kBoth, "--no-pictures", "-o", "run"}, folder_.path());
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(200);
  while (!fs::exists(folder_.path() / "run/starts/pace-alone/pace/iterations/0002") &&
         std::chrono::steady_clock::now() < limit)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  ::kill(child, SIGINT);
  const Outcome optimize = test::wait_for(child, folder_.path());
  EXPECT_EQ(optimize.code, 130) << optimize.err;
  EXPECT_EQ(json("run/run.json")["status"], "interrupted");
  EXPECT_FALSE(fs::exists(folder_.path() / "run/starts/from-pace"));
  const Outcome validate = call({"validate", "run", "--quick"});
  EXPECT_LE(validate.code, 1) << validate.err;
  EXPECT_EQ(json("run/result/matrix.json")["designs"].size(), 2u);  // initial body, all tasks
}

TEST_F(Joint, ForeignFoldersInRunJsonAreRefused) {
  const Outcome optimize =
      call({"optimize", kBoth, "--plan-only", "--max-iterations", "0", "--one-start",
            "--no-pictures", "--no-certificate", "--no-reasons", "-o", "run"});
  ASSERT_LE(optimize.code, 1) << optimize.err;
  Json run = json("run/run.json");
  run["tasks"][0]["folder"] = "../elsewhere";
  write_file(folder_.path() / "run/run.json", run.dump());
  EXPECT_EQ(call({"validate", "run", "--quick"}).code, 2);
}

TEST_F(Joint, SameBytesAtAnyThreadCount) {
  for (const char* threads : {"1", "2"}) {
    const Outcome optimize =
        call({"optimize", kBoth, "--plan-only", "--max-iterations", "1", "--no-pictures",
              "--one-start", "--threads", threads, "-o", std::string("run") + threads});
    ASSERT_LE(optimize.code, 1) << optimize.err;
  }
  const auto one = contents(folder_.path() / "run1"), two = contents(folder_.path() / "run2");
  ASSERT_EQ(one.size(), two.size());
  for (const auto& [name, text] : one) EXPECT_EQ(text, two.at(name)) << name;
}

TEST_F(Joint, FrontNeedsTwoTasksSolvedAlone) {
  const std::string single = (test::kExamples / "quadruped" / "pace.toml").string();
  const Outcome one = call({"optimize", single, "--front", "3", "-o", "run"});
  EXPECT_EQ(one.code, 2);
  EXPECT_TRUE(contains(one.err, "front needs two tasks") && contains(one.err, "[[task]]"))
      << one.err;
  EXPECT_EQ(call({"optimize", kBoth, "--front", "3", "--one-start", "-o", "run"}).code, 2);
  EXPECT_FALSE(fs::exists(folder_.path() / "run"));
}

TEST_F(Joint, FrontHasNoPointAboveABetterOne) {
  LEGWRIGHT_LONG_TEST();
  const Outcome optimize =
      call({"optimize", kBoth, "--plan-only", "--max-iterations", "3", "--front", "2",
            "--no-pictures", "--no-certificate", "--no-reasons", "-o", "run"});
  ASSERT_LE(optimize.code, 1) << optimize.err;
  const Json front = json("run/result/front.json"), run = json("run/run.json");
  ASSERT_EQ(front["points"].size(), 5u);
  EXPECT_EQ(test::expect_schemas(folder_.path() / "run")["front"], 1);
  EXPECT_EQ(front["points"][0]["weight"], 0.0);
  EXPECT_EQ(front["points"][4]["weight"], 1.0);
  // Its ends are the tasks alone, or joint designs that do them better; none is above another one.
  const auto cost = [&](std::size_t point, const char* task) {
    return front["points"][point]["F_tasks"][task].get<double>();
  };
  EXPECT_LE(cost(4, "pace"), run["alone"][0]["F"].get<double>() + 1e-3);
  EXPECT_LE(cost(0, "sideways"), run["alone"][1]["F"].get<double>() + 1e-3);
  EXPECT_LE(front["points"][2]["F"].get<double>(), run["final_F"].get<double>() + 1e-9);
  for (std::size_t k = 0; k < 5; ++k) {
    const double weight = front["points"][k]["weight"], F = front["points"][k]["F"];
    for (std::size_t other = 0; other < 5; ++other)
      EXPECT_LE(F, (weight * cost(other, "pace") + (1.0 - weight) * cost(other, "sideways")) *
                       (1.0 + 1e-6))
          << k << " above " << other;
  }

  // Points and starts can be picked: of all tasks, with the body that they share.
  const auto file = [&](const std::string& name) { return read_file(folder_.path() / name); };
  const auto expect_picked = [&](const std::string& option, const std::string& value,
                                 const std::string& name) {
    const Outcome pick = call({"pick", "run", option, value});
    ASSERT_EQ(pick.code, 0) << pick.err;
    EXPECT_EQ(json("run/run.json")["picked"], name);
    for (const std::string task : {"pace", "sideways"}) {
      EXPECT_EQ(json(("run/tasks/" + task + "/run.json").c_str())["picked"], name);
      EXPECT_EQ(file("run/tasks/" + task + "/result/robot.xml"), file("run/result/robot.xml"));
    }
    test::expect_schemas(folder_.path() / "run");
  };
  expect_picked("--front", "1", "front point 1");
  EXPECT_EQ(file("run/tasks/pace/result/motion.csv"), file("run/front/01/pace/motion.csv"));
  EXPECT_NEAR(json("run/run.json")["tasks"][0]["F"].get<double>(),
              front["points"][1]["F_tasks"]["pace"].get<double>(), 1e-9);
  expect_picked("--start", "pace", "start pace");
  for (const Json& start : run["starts"])
    if (start["start"] == "pace") {
      EXPECT_NEAR(json("run/run.json")["final_F"].get<double>(), start["F"].get<double>(), 1e-9);
    }
  EXPECT_EQ(call({"pick", "run", "--front", "5"}).code, 2);

  // A pick that ends on the way leaves run and tasks between two results, until the next.
  const fs::path record = folder_.path() / "run/tasks/sideways/run.json";
  fs::rename(record, folder_.path() / "aside.json");
  fs::create_directory(record);
  EXPECT_NE(call({"pick", "run", "--front", "1"}).code, 0);
  fs::remove(record);
  fs::rename(folder_.path() / "aside.json", record);
  for (const char* each : {"run", "run/tasks/pace", "run/tasks/sideways"}) {
    const Outcome report = call({"report", each});
    EXPECT_EQ(report.code, 3) << each;
    EXPECT_TRUE(contains(report.err, "between two results")) << report.err;
  }
  expect_picked("--front", "1", "front point 1");
  EXPECT_EQ(call({"report", "run/tasks/pace"}).code, 0);
}

TEST(CheckGradients, OfAllTasks) {
  const Outcome outcome = call({"check", "--gradients", "--json", kBoth});
  ASSERT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  const Json checks = Json::parse(outcome.out)["checks"];
  ASSERT_EQ(checks.size(), 4u);  // two tasks, standing and solved
  for (const Json& check : checks)
    for (const char* what : {"partial_m", "partial_s", "hessian_mm", "hessian_ms"})
      EXPECT_LT(check[what].get<double>(), 1e-5) << check.dump();
}

TEST(Outer, BodyThatSpendsLessWork) {
  const test::TemporaryFolder folder;
  const auto power = [&](const char* task) {
    const test::JudgedExample judged =
        test::judge_example(std::string("puppy/") + task, folder.path() / task);
    EXPECT_EQ(judged.optimize, 0) << judged.told;
    EXPECT_EQ(judged.validate, 0) << judged.told;
    return Json::parse(read_file(folder.path() / task / "result" /
                                 "metrics.json"))["result"]["default"]["power_mean_W"]
        .get<double>();
  };
  const double less = power("efficient.toml");
  EXPECT_LT(less, 0.9 * power("sideways.toml"));
  // The quantity in its unit, in the plans and in MuJoCo; the initial body falls.
  const Json outer = Json::parse(read_file(folder.path() / "efficient.toml" / "run.json"))["outer"];
  EXPECT_EQ(outer["unit"], "J");
  EXPECT_LT(outer["plan_final"].get<double>(), outer["plan_initial"].get<double>());
  EXPECT_TRUE(outer["measured"]["initial"].empty());
  EXPECT_NEAR(outer["measured"]["result"]["default"].get<double>(), less, 1e-3);  // 1 s a cycle
}

}  // namespace
}  // namespace legwright
