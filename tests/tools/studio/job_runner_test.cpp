// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/job_runner.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "mjcf/text/input_error.hpp"

namespace legwright {
namespace {

using namespace std::chrono_literals;

TEST(JobRunnerTest, WhoHearsOfAnEndMayAskForTheNextAtOnce) {
  EventHub hub;
  std::atomic<bool> cleared = false, second = false;
  JobRunner jobs(hub, "job");
  jobs.start("first", [&](JobRunner& job) {
    job.tell({{"words", "written"}}, false);
    std::this_thread::sleep_for(100ms);
    cleared = true;
  });
  ASSERT_FALSE(hub.after(0, 0, 5000ms).empty());
  jobs.start("second", [&](JobRunner& job) {
    second = cleared.load();
    job.tell({{"words", "written"}}, false);
  });
  for (int k = 0; k < 500 && !second; ++k) std::this_thread::sleep_for(10ms);
  EXPECT_TRUE(second) << "it begins once the first has cleared up";
}

TEST(JobRunnerTest, OneAtATime) {
  EventHub hub;
  std::atomic<bool> stop = false;
  JobRunner jobs(hub, "job");
  jobs.start("first", [&](JobRunner& job) {
    job.tell({{"words", "works"}}, true);
    while (!stop) std::this_thread::sleep_for(1ms);
  });
  EXPECT_THROW(jobs.start("second", [](JobRunner&) {}), InputError);
  stop = true;
}

}  // namespace
}  // namespace legwright
