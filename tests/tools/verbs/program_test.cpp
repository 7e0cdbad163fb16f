// SPDX-License-Identifier: Apache-2.0
// The built program, called as people call it.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <map>
#include <thread>

#include "tests/tools/files/temporary_folder.hpp"
#include "tests/tools/verbs/program.hpp"
#include "tests/tools/verbs/run_schemas.hpp"
#include "tools/run/events.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

using test::call;
using test::contains;
using test::kExamples;
using test::Outcome;
using test::start;
using test::wait_for;

const std::string kWalk = (kExamples / "puppy" / "sideways.toml").string();

TEST(Program, HelpAndVersionAreFineAndNonsenseIsBadInput) {
  EXPECT_EQ(call({"--help"}).code, 0);
  EXPECT_EQ(call({"--version"}).code, 0);
  EXPECT_EQ(call({}).code, 2);
  const Outcome typo = call({"optimise"});
  EXPECT_EQ(typo.code, 2);
  EXPECT_TRUE(
      contains(typo.err, "unknown verb 'optimise'; did you mean optimize? the verbs are init, "))
      << typo.err;
  for (const auto& [typed, meant] :
       {std::pair{"valdiate", "validate"}, {"reprot", "report"}, {"gait", "gaits"}})
    EXPECT_TRUE(contains(call({typed}).err, "did you mean " + std::string(meant) + "?")) << typed;
  EXPECT_FALSE(contains(call({"xyzzy"}).err, "did you mean"));
  EXPECT_EQ(call({"optimize", kWalk, "--max-iterations", "many"}).code, 2);
  for (const char* verb : {"init", "check", "optimize", "validate", "render", "report", "play",
                           "export", "diff", "doctor"}) {
    const Outcome help = call({verb, "--help"});
    EXPECT_EQ(help.code, 0) << verb;
    EXPECT_TRUE(contains(help.out, "--json")) << verb;
  }
}

TEST(Program, AFileOfAnotherKindIsToldWithTheVerbThatTakesIt) {
  const std::string robot = (kExamples / "puppy" / "robot.xml").string();
  for (const char* verb : {"check", "optimize"}) {
    const Outcome found = call({verb, robot});
    EXPECT_EQ(found.code, 2);
    EXPECT_TRUE(contains(found.err, "legwright init " + robot)) << found.err;
  }
  const Outcome task = call({"init", kWalk});
  EXPECT_EQ(task.code, 2);
  EXPECT_TRUE(contains(task.err, "legwright check " + kWalk)) << task.err;
  for (const char* verb : {"validate", "render", "report"}) {
    const Outcome run = call({verb, kWalk});
    EXPECT_NE(run.code, 0);
    EXPECT_TRUE(contains(run.err, "`legwright optimize` makes a run of a task")) << run.err;
  }
}

TEST(Check, ExplainsThePuppy) {
  const Outcome outcome = call({"check", kWalk});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  for (const char* part :
       {"puppy", "4 feet", "12 motors", "body_width", "######", "walk", "0.1 m per cycle",
        "default weight", "twice the longest leg that the bounds allow, is refused",
        "next: legwright optimize"})
    EXPECT_TRUE(contains(outcome.out, part)) << part << " in:\n" << outcome.out;
  EXPECT_FALSE(contains(outcome.out, "friction_cone")) << "only weights that the task changes";
}

TEST(Check, TellsTheWeightsThatATaskChanges) {
  const test::TemporaryFolder folder;
  const fs::path task = folder.path() / "task.toml";
  write_file(task, "robot = \"" + (kExamples / "puppy/robot.xml").string() +
                       "\"\n[gait]\nname = \"walk\"\nperiod = 1.0\n[travel]\nvelocity = [0.0, "
                       "0.1]\n[weights]\nstyle_foot = 0.7\n");
  const Outcome outcome = call({"check", task.string()});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "style_foot           (10)  0.7  (else 0.3)")) << outcome.out;
  EXPECT_FALSE(contains(outcome.out, "friction_cone")) << outcome.out;
}

TEST(Check, GivesOneJsonDocument) {
  const Outcome outcome = call({"check", "--json", kWalk});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  ASSERT_TRUE(Json::accept(outcome.out));
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["schema"], "legwright/check");
  EXPECT_EQ(json["robot"]["limbs"].size(), 4u);
  EXPECT_EQ(json["parameters"].size(), 20u);
  EXPECT_EQ(json["gait"]["contact"].size(), 4u);
  EXPECT_TRUE(json["warnings"].empty());
  EXPECT_TRUE(json["weights"].contains("friction_cone"));
}

TEST(Check, TellsTheKeysOfATaskWithoutOne) {
  const Outcome told = call({"check", "--keys"}), listed = call({"check", "--keys", "--json"});
  EXPECT_EQ(told.code, 0);
  const Json keys = Json::parse(listed.out);
  EXPECT_EQ(keys["schema"], "legwright/task_keys");
  EXPECT_GT(keys["keys"].size(), 40u);
  for (const Json& key : keys["keys"])
    EXPECT_TRUE(contains(told.out, "\n" + key["key"].get<std::string>() + " = "));
  for (const Json& term : keys["terms"])
    EXPECT_EQ(contains(told.out, "\n    " + term["name"].get<std::string>() + " "),
              term["role"] != "outer");
  EXPECT_EQ(call({"check", "--keys", kWalk}).code, 2);
  const Outcome nothing = call({"check"});
  EXPECT_EQ(nothing.code, 2);
  EXPECT_TRUE(contains(nothing.err, "TASK is required")) << nothing.err;
}

TEST(Check, RefusesEveryBrokenTaskWithExitCode2) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(kExamples / "broken" / "tasks")) {
    if (entry.path().extension() != ".toml") continue;
    const Outcome outcome = call({"check", entry.path().string()});
    EXPECT_EQ(outcome.code, 2) << entry.path();
    EXPECT_TRUE(contains(outcome.err, entry.path().string())) << outcome.err;
    EXPECT_EQ(outcome.out, "") << entry.path();
    ++count;
  }
  EXPECT_GT(count, 20);
}

TEST(Optimize, WritesNothingForBadInput) {
  const TemporaryFolder folder;
  const std::string bad = (kExamples / "broken" / "tasks" / "nan.toml").string();
  EXPECT_EQ(test::call_in(folder.path(), {"optimize", bad, "-o", "run"}).code, 2);
  EXPECT_EQ(test::call_in(folder.path(), {"optimize", "missing.toml"}).code, 2);
  EXPECT_FALSE(fs::exists(folder.path() / "run"));
  EXPECT_FALSE(fs::exists(folder.path() / "runs"));
}

TEST(Optimize, ExitsWith3WhereItCannotWrite) {
  const Outcome outcome = call({"optimize", kWalk, "-o", "/proc/legwright-run"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_TRUE(contains(outcome.err, "choose another folder")) << outcome.err;
}

std::map<std::string, std::string> files_below(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), folder).string()] = read_file(entry.path());
  return files;
}

TEST(Optimize, WritesACompleteRunTwiceTheSame) {
  const TemporaryFolder folder;
  const std::vector<std::string> words{
      "optimize", kWalk, "--plan-only", "--max-iterations", "1", "--no-pictures", "-o"};
  for (const char* run : {"a", "b"}) {
    std::vector<std::string> all = words;
    all.emplace_back(run);
    const Outcome outcome = test::call_in(folder.path(), all);
    ASSERT_TRUE(outcome.code == 0 || outcome.code == 1) << outcome.code << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "iteration   1"));
    EXPECT_TRUE(contains(outcome.out, "next: legwright validate"));
  }
  const fs::path a = folder.path() / "a", b = folder.path() / "b";
  for (const char* name :
       {"run.json", "events.jsonl", "inputs/task.toml", "inputs/robot.xml", "result/robot.xml",
        "result/scene.xml", "result/motion.csv", "result/metrics.json", "iterations/0000/robot.xml",
        "iterations/0000/scene.xml", "iterations/0000/motion.csv", "iterations/0000/metrics.json",
        "iterations/0001/scene.xml"})
    EXPECT_TRUE(fs::is_regular_file(a / name)) << name;
  EXPECT_EQ(files_below(a / "iterations"), files_below(b / "iterations"));
  EXPECT_EQ(files_below(a / "result"), files_below(b / "result"));
  EXPECT_EQ(read_file(a / "iterations/0000/robot.xml"),
            read_file(kExamples / "puppy" / "robot.xml"));

  const Json run = read_json(a / "run.json");
  EXPECT_EQ(run["schema"], "legwright/run");
  EXPECT_EQ(run["history"].size(), 2u);
  EXPECT_LT(run["final_F"].get<double>(), run["motion_only_F"].get<double>());
  const std::vector<Json> events = read_events(a / "events.jsonl");
  ASSERT_EQ(events.size(), 4u);
  EXPECT_EQ(events.front()["event"], "start");
  EXPECT_EQ(events[1]["F"], run["motion_only_F"]);
  EXPECT_EQ(events.back()["event"], "end");
  auto seen = test::expect_schemas(a);
  EXPECT_EQ(seen["run"], 1);
  EXPECT_EQ(seen["event_iteration"], 2);
  EXPECT_EQ(seen["iteration"], 3);

  const Outcome again = test::call_in(folder.path(), {"optimize", kWalk, "-o", "a"});
  EXPECT_EQ(again.code, 3);
  EXPECT_TRUE(contains(again.err, "--force")) << again.err;
  ::setenv("LEGWRIGHT_PLUGIN", "/nonexistent/gait.so", 1);
  for (const char* verb : {"validate", "render", "play"}) {
    const Outcome without = test::call_in(folder.path(), {verb, "a"});
    EXPECT_EQ(without.code, 3) << verb << without.err;
    EXPECT_TRUE(contains(without.err, "/nonexistent/gait.so")) << verb << without.err;
  }
  ::unsetenv("LEGWRIGHT_PLUGIN");
  const Outcome play = test::call_in(folder.path(), {"play", "a", "--viewer", "python", "--print"});
  EXPECT_EQ(play.code, 0) << play.err;
  EXPECT_TRUE(contains(play.out, "mj_loadPluginLibrary")) << play.out;
  EXPECT_EQ(test::call_in(folder.path(), {"play", "a", "--iteration", "9"}).code, 3);
}

/// By a coarse plan, for which fewer tightened motions are tried.
TEST(Optimize, MotionOnlyKeepsTheBodyAndSaysThatItDoesNotDo) {
  const TemporaryFolder folder;
  write_file(folder.path() / "task.toml",
             "robot = \"" + (kExamples / "puppy/robot.xml").string() +
                 "\"\n[gait]\nname = \"walk\"\nperiod = 1.0\nknots = 12\n[travel]\n"
                 "velocity = [0.0, 0.1]\n");
  const Outcome outcome = wait_for(
      start({"optimize", "task.toml", "--motion-only", "--no-pictures", "--json", "-o", "run"},
            folder.path()),
      folder.path());
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  const Json run = Json::parse(outcome.out, nullptr, false);
  ASSERT_FALSE(run.is_discarded());
  EXPECT_FALSE(run["feasible"].get<bool>());
  EXPECT_FALSE(run["reasons"].empty());
  EXPECT_GT(run["choice"]["candidates"].size(), 1U) << "other motions were tried";
  EXPECT_EQ(read_file(folder.path() / "run/result/robot.xml"),
            read_file(kExamples / "puppy" / "robot.xml"));
}

TEST(Optimize, StopsAtSigintWithAUsableFolder) {
  const TemporaryFolder folder;
  const pid_t child = start({"optimize", kWalk, "--no-pictures", "-o", "run"}, folder.path());
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(120);
  while (!fs::exists(folder.path() / "run/iterations/0001") &&
         std::chrono::steady_clock::now() < limit)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  ::kill(child, SIGINT);
  const Outcome outcome = wait_for(child, folder.path());
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_TRUE(fs::is_regular_file(folder.path() / "run/result/scene.xml"));
  EXPECT_EQ(read_json(folder.path() / "run/run.json")["status"], "interrupted");
}

TEST(Optimize, KeepsInsideRunsAndItsInputsRunAgain) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "tasks");
  fs::create_directories(folder.path() / "robots");
  std::string robot = read_file(kExamples / "puppy" / "robot.xml"), task = read_file(kWalk);
  const auto replace = [](std::string& text, const std::string& from, const std::string& to) {
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
  };
  replace(robot, "model=\"puppy\"", "model=\"a/../../../evil\"");
  replace(task, "\"robot.xml\"", "\"../robots/dog.xml\"");
  write_file(folder.path() / "robots" / "dog.xml", robot);
  write_file(folder.path() / "tasks" / "walk.toml", task);
  const Outcome outcome = wait_for(start({"optimize", "tasks/walk.toml", "--no-pictures",
                                          "--plan-only", "--max-iterations", "0"},
                                         folder.path()),
                                   folder.path());
  EXPECT_TRUE(outcome.code == 0 || outcome.code == 1) << outcome.code << outcome.err;
  const fs::path inputs = folder.path() / "runs" / "a__________evil-walk" / "inputs";
  ASSERT_TRUE(fs::is_directory(inputs));
  const Outcome again = call({"check", (inputs / "task.toml").string()});
  EXPECT_EQ(again.code, 0) << again.err;
}

TEST(Play, NeedsARunAndAViewerThatCanDoWhatIsAsked) {
  EXPECT_EQ(call({"play", "/nowhere", "--print"}).code, 3);
  EXPECT_EQ(call({"play", "/nowhere", "--viewer", "paper"}).code, 2);
  EXPECT_EQ(call({"play", "/nowhere", "--live", "--iteration", "1"}).code, 2);
  const Outcome python = call({"play", "/nowhere", "--live", "--viewer", "python"});
  EXPECT_EQ(python.code, 2);
  EXPECT_TRUE(contains(python.err, "--live needs")) << python.err;
}

TEST(Init, WritesProposalsAndNothingElse) {
  const test::TemporaryFolder folder;
  const fs::path robot = folder.path() / "robot.xml";
  std::string bare = read_file(kExamples / "puppy" / "robot.xml");
  const std::size_t from = bare.find("  <custom>"), to = bare.find("</custom>\n");
  bare.erase(from, to + 10 - from);
  write_file(robot, bare);
  const Outcome told = call({"init", robot.string()});
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_TRUE(contains(told.out, "front_thigh_length")) << told.out;
  EXPECT_EQ(read_file(robot), bare);  // only told so far
  const Outcome wrote =
      call({"init", robot.string(), "--write", "--task", (folder.path() / "t.toml").string()});
  EXPECT_EQ(wrote.code, 0);
  const std::string written = read_file(robot);
  EXPECT_NE(written, bare);
  // What was written, in short: the table was to be read before.
  EXPECT_FALSE(contains(wrote.out, "front_thigh_length")) << wrote.out;
  EXPECT_TRUE(contains(wrote.out, "robot.xml: 20 design parameters (8 lengths, 12 angles) in its"))
      << wrote.out;
  EXPECT_TRUE(contains(wrote.out, "t.toml: trot at 0.")) << wrote.out;
  EXPECT_TRUE(contains(wrote.out, "next: legwright optimize ")) << wrote.out;
  EXPECT_TRUE(contains(wrote.out, " -o runs/t\n")) << wrote.out;
  EXPECT_LT(std::count(wrote.out.begin(), wrote.out.end(), '\n'), 8) << wrote.out;
  const Outcome again = call({"init", robot.string(), "--write"});
  EXPECT_EQ(again.code, 0);
  EXPECT_TRUE(contains(again.out, "nothing to add: the file declares 20 design parameters"))
      << again.out;
  EXPECT_EQ(read_file(robot), written);  // nothing is left to propose
  EXPECT_EQ(call({"init", robot.string(), "-o", robot.string() + "2"}).code, 0);
  EXPECT_EQ(call({"init", (folder.path() / "robot.xml2").string(), "-o", robot.string()}).code, 3);
  EXPECT_EQ(call({"init", "/nowhere.xml"}).code, 2);
  EXPECT_EQ(call({"init", (kExamples / "broken" / "robots" / "two_free_roots.xml").string()}).code,
            2);
}

TEST(Init, WritesNoEscapeSequencesToTheTerminal) {
  const test::TemporaryFolder folder;
  const fs::path robot = folder.path() / "robot.xml";
  std::string hostile = read_file(kExamples / "puppy" / "robot.xml");
  for (std::size_t at; (at = hostile.find("\"FL_thigh\"")) != std::string::npos;)
    hostile.replace(at, 10,
                    "\"\xC2\x9B"
                    "31mthigh\"");
  write_file(robot, hostile);
  for (const Outcome& told :
       {call({"init", robot.string()}),
        call({"diff", robot.string(), (kExamples / "puppy" / "robot.xml").string()})}) {
    EXPECT_FALSE(contains(told.out, "\xC2\x9B")) << told.out;
    EXPECT_FALSE(contains(told.err, "\xC2\x9B")) << told.err;
  }
}

TEST(Doctor, FindsThePlugin) {
  const Outcome outcome = call({"doctor", "--json"});
  EXPECT_EQ(outcome.code, 0) << outcome.out;
  const Json json = Json::parse(outcome.out, nullptr, false);
  ASSERT_FALSE(json.is_discarded());
  bool plugin = false;
  for (const Json& item : json["items"])
    plugin = plugin || (item["name"] == "plugin" && item["found"] == true);
  EXPECT_TRUE(plugin);
}

}  // namespace
}  // namespace legwright
