// SPDX-License-Identifier: Apache-2.0
#include "tools/run/task_folders.hpp"

#include <gtest/gtest.h>

#include "mjcf/text/input_error.hpp"

namespace legwright {
namespace {

RunRecord run_with(const std::string& folder) {
  RunRecord run;
  TaskRecord& task = run.tasks.emplace().emplace_back();
  task.name = "pace";
  task.folder = folder;
  return run;
}

TEST(TaskFolders, AreThoseOfAJointRun) {
  const auto folders = task_folders(run_with("tasks/pace"));
  ASSERT_EQ(folders.size(), 1U);
  EXPECT_EQ(folders[0].name, "pace");
  EXPECT_EQ(folders[0].relative, "tasks/pace");
  EXPECT_TRUE(task_folders(RunRecord()).empty());
}

TEST(TaskFolders, NeverLieOutsideOfTheRun) {
  for (const char* folder : {"../tasks/pace", "/tasks/pace", "tasks/..", "tasks/../x", "tasks", "",
                             "tasks/a/b", "other/pace", "tasks/", "tasks/."})
    EXPECT_THROW(task_folders(run_with(folder)), InputError) << folder;
  RunRecord without = run_with("");
  without.tasks->front().folder.reset();
  EXPECT_THROW(task_folders(without), InputError);
}

}  // namespace
}  // namespace legwright
