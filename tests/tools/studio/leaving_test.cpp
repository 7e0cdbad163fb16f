// SPDX-License-Identifier: Apache-2.0
// What becomes of a robot, of requests and of work in the background when another robot is opened.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <future>
#include <memory>
#include <string>
#include <thread>

#include "mjcf/text/input_error.hpp"
#include "tests/support/paths.hpp"
#include "tests/tools/studio/browser.hpp"

namespace legwright {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;
using test::Browser;
using test::OpenStudio;

const std::string kAssembly = test::source_dir() + "/examples/assemblies/quadruped.toml";
const std::string kHexapodTask = test::source_dir() + "/examples/hexapod/wave.toml";

class LeavingTest : public testing::Test {
 protected:
  Json open(const std::string& path) { return browser_.post("/api/open", {{"path", path}}); }

  OpenStudio studio_;
  Browser& browser_ = *studio_.browser;
};

TEST_F(LeavingTest, APageGoesBackToModulesWhileAnotherOneOpensARobot) {
  for (const char* asked : {"/api/assembly/bench", "/api/assembly/build"}) {
    ASSERT_EQ(open(kAssembly)["status"], 200);
    auto other = std::async(std::launch::async, [&] {
      return Browser(studio_.server->url()).post("/api/open", {{"path", kHexapodTask}});
    });
    std::this_thread::sleep_for(50ms);
    (void)browser_.post(asked, Json::object());  // refused, or done before
    EXPECT_EQ(other.get()["status"], 200);
    const Json opened = browser_.next("opened");
    EXPECT_EQ(opened["path"], kHexapodTask) << asked;
    EXPECT_EQ(opened["of_modules"], false) << asked;
    EXPECT_EQ(browser_.get("/api/document")["path"], kHexapodTask) << asked;
    EXPECT_EQ(browser_.post("/api/assembly/bench", Json::object())["status"], 400) << asked;
  }
}

TEST_F(LeavingTest, WhoStillAsksWhatWasOpenIsRefusedAndNothingOfItIsTold) {
  ASSERT_EQ(open(kHexapodTask)["status"], 200);
  const std::shared_ptr<Workspace> held = studio_.service.workspace();
  held->session().post(session::Searched{3});  // goes on to its end, whatever waits
  auto waiting = std::async(std::launch::async, [&] {
    return Browser(studio_.server->url()).post("/api/command", {{"do", "reset"}});
  });
  std::this_thread::sleep_for(50ms);
  ASSERT_EQ(open(test::kSidewaysTask)["status"], 200);
  const Json late = waiting.get();
  EXPECT_EQ(late["status"], 409) << late;
  EXPECT_NE(late["error"]["message"].get<std::string>().find("another page"), std::string::npos);
  const std::size_t bodies = browser_.get("/api/design")["bodies"].size();
  (void)browser_.settled();
  EXPECT_THROW(held->session().apply(session::Reset{}), SessionClosed);
  PhysicsSettings playing;
  playing.run = true;
  held->physics().set(playing);
  std::this_thread::sleep_for(300ms);
  bool plays = false;
  std::size_t shown = 0;
  browser_.follow([&](const std::string& kind, const Json& data) {
    if (kind == "design") shown = data["bodies"].size();
    plays = plays || kind == "physics";
    return kind == "state";
  });
  EXPECT_EQ(shown, bodies) << "not that of what was open";
  EXPECT_FALSE(plays);
}

/// A program in the place of legwright that waits for a file, `go`, and then exports, or plays.
std::string waiting_program(const fs::path& folder) {
  const fs::path program = folder / "program";
  write_file(program, R"(#!/bin/sh
while [ ! -e "$(dirname "$0")/go" ]; do sleep 0.02; done
[ -e "$2/run.json" ] || { echo "$2 holds no run" >&2; exit 2; }
[ "$1" = validate ] || cp -r "$2" "$4"
)");
  fs::permissions(program, fs::perms::owner_all);
  return program.string();
}

TEST(LeavingWorkTest, AnExportGoesOnToItsEndAndAJudgeOfWhatWasOpenEnds) {
  const test::TemporaryFolder programs;
  OpenStudio studio(test::kSidewaysTask, waiting_program(programs.path()));
  Browser& browser = *studio.browser;
  (void)browser.settled();
  const fs::path exported = studio.folder.path() / "exported",
                 state = studio.folder.path() / "state";
  const auto begun = [&](const std::string& kind) {
    return browser.next(kind, [](const Json& j) { return j["words"] == "playing"; });
  };
  ASSERT_EQ(browser.post("/api/export", {{"path", exported.string()}})["status"], 200);
  ASSERT_FALSE(begun("job").is_null());
  ASSERT_EQ(browser.post("/api/judge", Json::object())["status"], 200);
  ASSERT_FALSE(begun("judge").is_null());
  const std::string other = test::source_dir() + "/examples/puppy/turning.toml";
  ASSERT_EQ(browser.post("/api/open", {{"path", other}})["status"], 200);
  write_file(programs.path() / "go", "");
  const Json done = browser.next("job", [](const Json& j) { return !j["running"]; });
  ASSERT_TRUE(done.is_object());
  EXPECT_EQ(done.value("path", ""), exported.string()) << done;
  EXPECT_TRUE(fs::is_regular_file(exported / "run.json"));
  const auto of_judge = [](const std::string& kind, const Json&) { return kind == "judge"; };
  EXPECT_TRUE(browser.follow(of_judge, 1s).is_null()) << "of another robot than what is open";
  studio.server->stop();
  std::size_t sessions = 0;
  for (const auto& entry : fs::directory_iterator(state / "sessions")) {
    EXPECT_TRUE(fs::exists(entry.path() / "about.json")) << entry.path();
    ++sessions;
  }
  EXPECT_EQ(sessions, 1U) << "that of what is open";
}

TEST_F(LeavingTest, WorkThatDiedLeavesNothingBehind) {
  const KeptSessions kept(studio_.folder.path() / "state");
  const fs::path dead = kept.root() / "work" / "20260101-000000-judged-0";
  fs::create_directories(dead / "run");
  const auto lives = kept.begin_work("judged");
  EXPECT_FALSE(fs::exists(dead));
  auto next = kept.begin_work("judged");
  EXPECT_TRUE(fs::exists(lives->path())) << "is held";
  const fs::path gone = next->path();
  next.reset();
  EXPECT_FALSE(fs::exists(gone));
}

TEST_F(LeavingTest, AnAssemblyThatIsLeftObeysNoMore) {
  EventHub hub;
  MeshStore meshes;
  const ModuleLibrary library = library_with({});
  const KeptSessions kept(studio_.folder.path() / "state");
  AssemblyBench bench(AssemblyDesk(library), {}, kept, hub, meshes);
  const Json put{{"do", "put"}, {"module", "XL430-W250"}, {"spot", "side/front"}};
  EXPECT_EQ(bench.obey(put)["revision"], 1);
  bench.close();
  hub.forget("");
  EXPECT_THROW((void)bench.obey({{"do", "undo"}}), InputError);
  EXPECT_THROW(bench.save(studio_.folder.path() / "late.toml", false), InputError);
  EXPECT_TRUE(hub.after(0, 0, 0ms).empty());
}

}  // namespace
}  // namespace legwright
