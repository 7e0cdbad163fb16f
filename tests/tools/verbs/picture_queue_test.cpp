// SPDX-License-Identifier: Apache-2.0
// Pictures of iterations, drawn beside the search.
#include "tools/verbs/picture_queue.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <set>
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

/// The niceness of each thread of this process. Mesa's own, which fill its cache on disk, have 19.
std::set<int> niceness_of_threads() {
  std::set<int> niceness;
  for (const auto& thread : fs::directory_iterator("/proc/self/task")) {
    const auto id = static_cast<id_t>(std::stoul(thread.path().filename().string()));
    niceness.insert(::getpriority(PRIO_PROCESS, id));
  }
  return niceness;
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
  while (pictures.waiting() > 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const std::set<int> niceness = niceness_of_threads();  // the one that draws waits for more
  EXPECT_TRUE(fs::is_regular_file(first / "frame.png"));
  EXPECT_TRUE(fs::is_regular_file(second / "frame.png"));
  EXPECT_EQ(pictures.finish(), "");
  // The search comes first; but with 19, beside a busy program, the command would wait for minutes.
  EXPECT_TRUE(niceness.contains(std::max(::getpriority(PRIO_PROCESS, 0), 5)));
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
