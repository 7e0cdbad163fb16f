// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/event_hub.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace legwright {
namespace {

using namespace std::chrono_literals;

std::string told(const std::vector<StudioEvent>& events) {
  std::string out;
  for (const StudioEvent& event : events) out += event.kind + *event.json + " ";
  return out;
}

TEST(EventHubTest, OfEachKeyTheLatestIsToldInTheOrderInWhichItCame) {
  EventHub hub;
  hub.publish("design", "1");
  hub.publish("motion", "2", "motion:0");
  hub.publish("motion", "3", "motion:1");
  hub.publish("state", "4");
  hub.publish("design", "5");
  const auto all = hub.after(0, 0, 0ms);
  EXPECT_EQ(told(all), "motion2 motion3 state4 design5 ");
  EXPECT_TRUE(hub.after(all.back().number, 0, 0ms).empty());
  hub.publish("motion", "6", "motion:0");
  EXPECT_EQ(told(hub.after(all.back().number, 0, 0ms)), "motion6 ");
  hub.forget("motion");
  EXPECT_EQ(told(hub.after(0, 0, 0ms)), "state4 design5 ");
}

TEST(EventHubTest, WhatBelongsTogetherIsFoundTogether) {
  EventHub hub;
  for (int k = 0; k < 100; ++k) {
    const std::uint64_t before = hub.now();
    std::vector<StudioEvent> found;
    std::thread follower([&] { found = hub.after(before, 0, 10s); });
    hub.publish({{"design", "1"}, {"motion", "2", "motion:0"}, {"state", "3"}});
    follower.join();
    EXPECT_EQ(told(found), "design1 motion2 state3 ");
  }
}

TEST(EventHubTest, NoticesAreAllToldButNotThoseFromBeforeOneJoined) {
  EventHub hub;
  hub.publish("state", "1");
  hub.notice("info", "early");
  const std::uint64_t joined = hub.now();
  hub.notice("info", "one");
  hub.notice("error", "two");
  const auto events = hub.after(0, joined, 0ms);
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[0].kind, "state");
  EXPECT_NE(events[1].json->find("one"), std::string::npos);
  EXPECT_NE(events[2].json->find("two"), std::string::npos);
}

TEST(EventHubTest, CloseWakesWhoWaits) {
  EventHub hub;
  hub.close();
  const auto start = std::chrono::steady_clock::now();
  EXPECT_TRUE(hub.after(0, 0, 10s).empty());
  EXPECT_LT(std::chrono::steady_clock::now() - start, 5s);
}

}  // namespace
}  // namespace legwright
