// SPDX-License-Identifier: Apache-2.0
// The program itself: what survives when it is killed, and what it does in processes of its own.
#include <gtest/gtest.h>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <thread>
#include <vector>

#include "tests/support/paths.hpp"
#include "tests/tools/studio/browser.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/studio/kept_sessions.hpp"

namespace legwright {
namespace {

using test::Browser;

/// `legwright studio …` in a process of its own.
class RunningStudio {
 public:
  RunningStudio(const std::filesystem::path& folder, const std::string& path) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) return;
    child_ = ::fork();
    if (child_ == 0) {
      ::dup2(ends[1], STDOUT_FILENO);
      ::close(ends[0]);
      ::setenv("XDG_STATE_HOME", (folder / "state").c_str(), 1);
      if (::chdir(folder.c_str()) != 0) ::_exit(1);
      ::execl(test::program().c_str(), "legwright", "studio", path.c_str(), "--no-browser",
              nullptr);
      ::_exit(127);
    }
    ::close(ends[1]);
    char letter = 0;
    while (::read(ends[0], &letter, 1) == 1 && letter != '\n') url_ += letter;
    ::close(ends[0]);
  }
  ~RunningStudio() { end(SIGTERM); }
  RunningStudio(const RunningStudio&) = delete;
  RunningStudio& operator=(const RunningStudio&) = delete;

  /// @return exit code, or minus the signal
  int end(int signal) {
    if (child_ <= 0) return 0;
    ::kill(child_, signal);
    int status = 0;
    ::waitpid(child_, &status, 0);
    child_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }
  const std::string& url() const { return url_; }

 private:
  pid_t child_ = -1;
  std::string url_;
};

class StudioProgramTest : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
  const KeptSessions kept_{folder_.path() / "state" / "legwright" / "studio"};
};

constexpr const char* kThigh = "front_thigh_length";

TEST_F(StudioProgramTest, NothingOlderThanASecondIsLostWhenItIsKilled) {
  std::vector<double> last;  // what a page was shown, a second and more before the end
  int iterations = 0;
  {
    RunningStudio studio(folder_.path(), test::kSidewaysTask);
    Browser browser(studio.url());
    browser.post("/api/command", {{"do", "edit"}, {"values", {{kThigh, 0.061}}}});
    browser.post("/api/command", {{"do", "snapshot"}, {"name", "mine"}});
    (void)browser.settled();
    browser.post("/api/command", {{"do", "start"}});
    const Json point = browser.next("state", [](const Json& s) { return s["iterations"] >= 12; });
    iterations = point["iterations"].get<int>();
    last = point["s"].get<std::vector<double>>();
    std::this_thread::sleep_for(std::chrono::milliseconds(1000));
    EXPECT_EQ(studio.end(SIGKILL), -SIGKILL);
  }
  const std::vector<KeptSession> left = kept_.left_behind();
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].origin, test::kSidewaysTask);
  RunningStudio again(folder_.path(), left[0].folder.string());
  Browser browser(again.url());
  const Json state = browser.settled();
  EXPECT_GE(state["iterations"].get<int>(), iterations);
  EXPECT_EQ(state["names"], Json::array({"mine"}));
  EXPECT_TRUE(state["can_undo"].get<bool>());
  browser.post("/api/command", {{"do", "undo"}});
  EXPECT_EQ(browser.settled()["s"][0], 0.061) << "the search is one step back";
  EXPECT_TRUE(kept_.left_behind().empty()) << "it has been taken up";
}

TEST_F(StudioProgramTest, AnAssemblyIsAsItWasAnsweredWhenItIsKilled) {
  const std::string assembly = test::source_dir() + "/examples/assemblies/puppy.toml";
  {
    RunningStudio studio(folder_.path(), assembly);
    Browser browser(studio.url());
    const Json put{{"do", "put"}, {"module", "XM430-W350"}, {"spot", "limb/0/joint/1"}};
    ASSERT_EQ(browser.post("/api/assembly", put)["item"], "limb/0/joint/1");
    EXPECT_EQ(studio.end(SIGKILL), -SIGKILL);
  }
  const std::vector<KeptSession> left = kept_.left_behind();
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].origin, assembly);
  RunningStudio again(folder_.path(), left[0].folder.string());
  const Json told = Browser(again.url()).next("assembly");
  EXPECT_EQ(told["limbs"][0]["joints"][1]["servo"], "XM430-W350");
  EXPECT_EQ(told["path"], assembly);
}

TEST_F(StudioProgramTest, ARunGoesOnWhereAKilledStudioLeftIt) {
  const std::string run = (folder_.path() / "run").string();
  {
    RunningStudio studio(folder_.path(), test::kSidewaysTask);
    Browser browser(studio.url());
    ASSERT_EQ(browser.post("/api/save", {{"path", run}})["status"], 200);
    EXPECT_EQ(studio.end(SIGTERM), 0);
  }
  EXPECT_TRUE(kept_.left_behind().empty()) << "nothing was done that was not saved";
  {
    RunningStudio studio(folder_.path(), run);
    Browser browser(studio.url());
    browser.post("/api/command", {{"do", "edit"}, {"values", {{kThigh, 0.07}}}});
    EXPECT_EQ(studio.end(SIGKILL), -SIGKILL);
  }
  RunningStudio again(folder_.path(), run);
  EXPECT_EQ(Browser(again.url()).settled()["s"][0], 0.07);
}

/// A run that was found from an edited body is opened: it stands, its verdict is told, and what was
/// given is the robot as the user opened it first.
void expect_opened_as_found(Browser& browser, const Json& run) {
  ASSERT_EQ(browser.post("/api/open", {{"path", "found"}})["status"], 200);
  const Json found = browser.settled(), document = browser.get("/api/document");
  const Json& parameters = document["parameters"];
  const auto given = [&](std::size_t k) { return parameters[k]["given"].get<double>(); };
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    EXPECT_EQ(parameters[k]["name"], run["parameters"][k]["name"]);
    EXPECT_EQ(found["s"][k], run["parameters"][k]["final"]) << parameters[k]["name"];
    if (parameters[k]["name"] == kThigh) {
      EXPECT_EQ(given(k), 0.06) << "the robot's, not the one that the search began from";
    }
  }
  const Json judged = browser.next("judge", [](const Json& j) { return !j["running"]; });
  EXPECT_EQ(judged["verdict"]["word"], "PASS");
  EXPECT_EQ(judged["judged"]["s"], found["s"]);
  EXPECT_EQ(judged["judged"]["task_text"], document["task_text"]);
  EXPECT_EQ(browser.get("/api/compare?a=&b=")["verdict"]["b"], "PASS");
  browser.post("/api/command", {{"do", "freeze"}, {"names", {kThigh}}, {"frozen", false}});
  browser.post("/api/command", {{"do", "reset"}});
  const Json back = browser.settled();
  for (std::size_t k = 0; k < parameters.size(); ++k) EXPECT_EQ(back["s"][k], given(k));
}

TEST_F(StudioProgramTest, SearchesOnWithMujocoFromTheBodyThatStands) {
  RunningStudio studio(folder_.path(), test::source_dir() + "/examples/puppy/sideways.toml");
  Browser browser(studio.url());
  (void)browser.settled();
  browser.post("/api/command", {{"do", "edit"}, {"values", {{"front_thigh_length", 0.081}}}});
  browser.post("/api/command", {{"do", "freeze"}, {"names", {"front_thigh_length"}}});
  browser.post("/api/command",
               {{"do", "bounds"}, {"name", "hind_thigh_length"}, {"lower", 0.05}, {"upper", 0.07}});
  (void)browser.settled();
  ASSERT_EQ(browser.post("/api/optimize", {{"path", "found"}})["status"], 200);
  EXPECT_EQ(browser.post("/api/optimize", {{"path", "other"}})["status"], 400) << "one at a time";
  bool searched = false, played = false;
  const Json found = browser.next("job", [&](const Json& j) {
    searched = searched || (j.value("words", "") == "searching" && j.value("of", 0) > 0);
    played = played || (j.value("words", "").starts_with("playing") && j.value("done", 0) > 0);
    return !j["running"];
  });
  EXPECT_TRUE(searched && played) << "it tells how far it is";
  EXPECT_EQ(found["what"], "optimize");
  ASSERT_EQ(found.value("failed", ""), "") << found;
  const std::filesystem::path run = folder_.path() / "found";
  EXPECT_EQ(found["path"], std::filesystem::canonical(run).string());
  EXPECT_EQ(browser.get("/api/start")["recent"][0]["path"], found["path"]);
  const Json told = Json::parse(std::ifstream(run / "run.json"));
  EXPECT_TRUE(told["feasible"].get<bool>());
  // Alone the search makes the front thighs 88 mm long and the hind ones 46 mm.
  const auto parameter = [&](const std::string& name) -> Json {
    for (const Json& each : told["parameters"])
      if (each["name"] == name) return each;
    return nullptr;
  };
  ASSERT_TRUE(parameter("front_thigh_length").is_object());
  EXPECT_EQ(parameter("front_thigh_length")["final"], 0.081) << "it is locked";
  const Json narrow = parameter("hind_thigh_length");
  ASSERT_TRUE(narrow.is_object());
  EXPECT_EQ(narrow["lower"], 0.05);
  EXPECT_EQ(narrow["upper"], 0.07);
  EXPECT_GE(narrow["final"].get<double>(), 0.05);
  EXPECT_LE(narrow["final"].get<double>(), 0.07);
  EXPECT_TRUE(found["passes"].get<bool>());

  // What it found is exported as it is: the body that stands is another.
  const Json asked{{"path", "mine"}, {"run", found["path"]}};
  ASSERT_EQ(browser.post("/api/export", asked)["status"], 200);
  const Json exported = browser.next(
      "job", [](const Json& j) { return j.value("what", "") == "export" && !j["running"]; });
  EXPECT_EQ(exported.value("failed", ""), "");
  EXPECT_NE(read_file(folder_.path() / "mine" / "README.md").find("- PASS  walk sideways"),
            std::string::npos)
      << "its own verdict";
  const RobotModel mine = read_robot(folder_.path() / "mine" / "puppy.xml");
  const Eigen::VectorXd values = mine.space.initial();
  for (int k = 0; k < values.size(); ++k) {
    const std::string& name = mine.space.parameters[static_cast<std::size_t>(k)].name;
    EXPECT_NEAR(values[k], parameter(name)["final"].get<double>(), 1e-12) << name;
  }
  ASSERT_EQ(browser.post("/api/export", {{"path", "mine"}, {"run", "/etc"}})["status"], 400);
  expect_opened_as_found(browser, told);

  // A gait that was planned more strictly than the task says is not the one that is shown then.
  std::string text = read_file(run / "run.json");
  const std::string optimum = R"("chosen": "optimum")";
  ASSERT_NE(text.find(optimum), std::string::npos);
  text.replace(text.find(optimum), optimum.size(), R"("chosen": "tightened: lower steps")");
  std::ofstream(run / "run.json") << text;
  ASSERT_EQ(browser.post("/api/open", {{"path", found["path"]}})["status"], 200);
  const auto tells = [](const std::string& is, const Json& data) {
    return is == "notice" &&
           data.value("words", "").find("tightened: lower steps") != std::string::npos;
  };
  EXPECT_TRUE(browser.follow(tells, std::chrono::seconds(20), "/api/events?heard=0").is_object());
}

TEST_F(StudioProgramTest, PlansATightenedGaitAsItsSearchDid) {
  const std::string task = test::source_dir() + "/examples/puppy/sideways_trot.toml";
  RunningStudio studio(folder_.path(), task);
  Browser browser(studio.url());
  (void)browser.settled();
  ASSERT_EQ(browser.post("/api/optimize", {{"path", "found"}})["status"], 200);
  const Json found = browser.next("job", [](const Json& j) { return !j["running"]; });
  ASSERT_TRUE(found["passes"].get<bool>()) << found;
  const Json told = Json::parse(std::ifstream(folder_.path() / "found" / "run.json"));
  ASSERT_TRUE(told["choice"]["chosen"].get<std::string>().starts_with("tightened"))
      << "choose another task, whose optimum MuJoCo fails";
  ASSERT_EQ(browser.post("/api/open", {{"path", found["path"]}})["status"], 200);
  (void)browser.settled();
  browser.post("/api/judge", Json::object());
  const Json judged = browser.next("judge", [](const Json& j) { return !j["running"]; });
  EXPECT_EQ(judged["verdict"]["word"], "PASS") << judged["verdict"];
  std::string folder;
  for (const Json& each : told["choice"]["candidates"])
    if (each["name"] == told["choice"]["chosen"]) folder = each["folder"];
  const std::string planned = read_file(folder_.path() / "found" / folder / "tightened.toml");
  EXPECT_NE(planned.find("torque_margin"), std::string::npos) << planned;
  EXPECT_EQ(judged["judged"]["task_text"], planned);
}

TEST_F(StudioProgramTest, WhatIsExportedIsCalledAsTheUserCallsItAndTellsWhereItWasMade) {
  std::string text = read_file(test::source_dir() + "/examples/puppy/robot.xml");
  const std::string name = " model=\"puppy\"";
  text.erase(text.find(name), name.size());
  const std::filesystem::path robot = folder_.path() / "fire_dog.xml";
  write_file(robot, text);
  RunningStudio studio(folder_.path(), robot.string());
  Browser browser(studio.url());
  (void)browser.settled();
  ASSERT_EQ(browser.post("/api/save", {{"path", "run"}})["status"], 200);
  const Json run = Json::parse(std::ifstream(folder_.path() / "run" / "run.json"));
  EXPECT_EQ(run["status"], "designed in the Studio");
  EXPECT_EQ(run["robot"], "fire_dog");
  EXPECT_EQ(run["argv"][1], "studio");
  const Json asked{{"path", "mine"}, {"run", (folder_.path() / "run").string()}};
  ASSERT_EQ(browser.post("/api/export", asked)["status"], 200);
  const Json exported = browser.next("job", [](const Json& j) { return !j["running"]; });
  EXPECT_EQ(exported.value("failed", ""), "");
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "mine" / "fire_dog.xml"));
  const std::string readme = read_file(folder_.path() / "mine" / "README.md");
  for (const char* told : {"| robot | fire\\_dog.xml |", "| the search | designed in the Studio |",
                           "    legwright studio fire_dog.xml"})
    EXPECT_NE(readme.find(told), std::string::npos) << told << "\n" << readme.substr(0, 900);
}

TEST_F(StudioProgramTest, JudgesReportsAndExportsWhatStands) {
  RunningStudio studio(folder_.path(), test::source_dir() + "/examples/quadruped/crawl.toml");
  Browser browser(studio.url());
  (void)browser.settled();
  browser.post("/api/command", {{"do", "snapshot"}, {"name", "as built"}});
  const std::string compare = "/api/compare?a=as%20built&b=";
  EXPECT_TRUE(browser.get(compare)["verdict"]["a"].is_null());
  ASSERT_EQ(browser.post("/api/judge", Json::object())["status"], 200);
  EXPECT_EQ(browser.post("/api/judge", Json::object())["status"], 400) << "one at a time";
  const Json judged = browser.next("judge", [](const Json& j) { return !j["running"]; });
  ASSERT_TRUE(judged.contains("lines")) << judged;
  EXPECT_GT(judged["lines"].size(), 5U);
  EXPECT_FALSE(judged["verdict"]["words"].get<std::string>().empty());
  EXPECT_EQ(browser.get(compare)["verdict"]["a"], judged["verdict"]["word"]);
  EXPECT_EQ(browser.get(compare)["verdict"]["b"], judged["verdict"]["word"]) << "the same design";
  ASSERT_EQ(browser.post("/api/export", {{"path", "mine"}})["status"], 200);
  const Json exported = browser.next("job", [](const Json& j) { return !j["running"]; });
  EXPECT_EQ(exported.value("failed", ""), "");
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "mine" / "play.py"));
  EXPECT_NE(read_file(folder_.path() / "mine" / "README.md")
                .find("- " + judged["verdict"]["word"].get<std::string>() + "  crawl"),
            std::string::npos);
  ASSERT_EQ(browser.post("/api/save", {{"path", "run"}})["status"], 200);
  browser.post("/api/command", {{"do", "edit"}, {"values", {{"front_thigh_length", 0.1}}}});
  (void)browser.settled();
  EXPECT_EQ(browser.get(compare)["verdict"]["a"], judged["verdict"]["word"]);
  EXPECT_TRUE(browser.get(compare)["verdict"]["b"].is_null()) << "nobody judged it";
  EXPECT_EQ(browser.post("/api/report", {{"path", "run"}})["status"], 400) << "another state";
  browser.post("/api/command", {{"do", "undo"}});
  ASSERT_EQ(browser.post("/api/report", {{"path", "reported"}})["status"], 200);
  const Json reported = browser.next("job", [&](const Json& j) {
    return !j["running"] && j.value("path", "") != exported.value("path", "");
  });
  EXPECT_EQ(reported.value("failed", ""), "");
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "reported" / "report.html"));
  EXPECT_EQ(browser.post("/api/judge", Json::object())["status"], 200);
  EXPECT_EQ(browser.remove("/api/judge")["status"], 200);
  const Json ended = browser.next(
      "judge", [](const Json& j) { return !j["running"] && j.value("failed", "") == "cancelled"; });
  EXPECT_FALSE(ended.is_null());
}

}  // namespace
}  // namespace legwright
