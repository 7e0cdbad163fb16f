// SPDX-License-Identifier: Apache-2.0
// What becomes of a robot, of requests and of work in the background when another robot is opened.
#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <string>
#include <thread>

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

}  // namespace
}  // namespace legwright
