// SPDX-License-Identifier: Apache-2.0
#include "tools/run/task_folders.hpp"

#include <gtest/gtest.h>

#include "mjcf/text/input_error.hpp"

namespace legwright {
namespace {

Json run_with(const std::string& folder) {
  return {{"tasks", {{{"name", "pace"}, {"folder", folder}}}}};
}

TEST(TaskFolders, AreThoseOfAJointRun) {
  const auto folders = task_folders(run_with("tasks/pace"));
  ASSERT_EQ(folders.size(), 1U);
  EXPECT_EQ(folders[0].name, "pace");
  EXPECT_EQ(folders[0].relative, "tasks/pace");
  EXPECT_TRUE(task_folders({{"task", "alone"}}).empty());
  EXPECT_TRUE(task_folders(Json()).empty());
}

TEST(TaskFolders, NeverLieOutsideOfTheRun) {
  for (const char* folder : {"../tasks/pace", "/tasks/pace", "tasks/..", "tasks/../x", "tasks", "",
                             "tasks/a/b", "other/pace", "tasks/", "tasks/."})
    EXPECT_THROW(task_folders(run_with(folder)), InputError) << folder;
  EXPECT_THROW(task_folders({{"tasks", {1}}}), InputError);
}

}  // namespace
}  // namespace legwright
