// SPDX-License-Identifier: Apache-2.0
// What becomes of a robot, of requests and of work in the background when another robot is opened.
#include <gtest/gtest.h>

#include <chrono>
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
