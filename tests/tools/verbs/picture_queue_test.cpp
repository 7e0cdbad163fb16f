// SPDX-License-Identifier: Apache-2.0
// Pictures of iterations, drawn beside the search.
#include "tools/verbs/picture_queue.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/atomic_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr const char* kScene = R"(<mujoco><worldbody>
  <body name="trunk" pos="0 0 0.3"><freejoint/><geom type="box" size="0.1 0.05 0.03"/></body>
</worldbody></mujoco>)";

/// The largest niceness among the threads that draw; Mesa's for its cache on disk have their own.
int nicest_that_draws() {
  int most = 0;
  for (const auto& thread : fs::directory_iterator("/proc/self/task")) {
    std::string name;
    std::getline(std::ifstream(thread.path() / "comm"), name);
    const auto id = static_cast<id_t>(std::stoul(thread.path().filename().string()));
    if (name.find("disk") == std::string::npos)
      most = std::max(most, ::getpriority(PRIO_PROCESS, id));
  }
  return most;
}

class PictureQueueTest : public testing::Test {
 protected:
  fs::path design(const std::string& name) {
    const fs::path folder = folder_.path() / name;
    fs::create_directories(folder);
    write_file(folder / "scene.xml", kScene);
    return folder;
  }
  test::TemporaryFolder folder_;
};

TEST_F(PictureQueueTest, OneAtHandIsWaitedForToo) {
  PictureQueue pictures(true);
  const fs::path first = design("first"), second = design("second");
  pictures.add(first);
  pictures.add(second);
  int most_nice = 0;
  while (pictures.waiting() > 0) {
    most_nice = std::max(most_nice, nicest_that_draws());
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_TRUE(fs::is_regular_file(first / "frame.png"));
  EXPECT_TRUE(fs::is_regular_file(second / "frame.png"));
  EXPECT_EQ(pictures.finish(), "");
  const int own = ::getpriority(PRIO_PROCESS, 0);
  EXPECT_TRUE(own >= 5 || most_nice > own);  // the search comes first
  EXPECT_LT(most_nice, own + 10);  // beside a busy program the command would wait for minutes
}

TEST_F(PictureQueueTest, AFailureEndsThePicturesAndIsTold) {
  PictureQueue pictures(true);
  const fs::path broken = design("broken");
  write_file(broken / "scene.xml", "<mujoco><nonsense/></mujoco>");
  pictures.add(broken);
  pictures.add(design("whole"));
  while (pictures.waiting() > 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_NE(pictures.finish().find("no pictures: "), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_.path() / "whole/frame.png"));
}

}  // namespace
}  // namespace legwright
