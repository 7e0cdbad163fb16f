// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/summary.hpp"

#include <gtest/gtest.h>

#include "tools/verbs/viewer_programs.hpp"

namespace legwright {
namespace {

TEST(ShellWord, QuotesOnlyWhatNeedsIt) {
  EXPECT_EQ(shell_word("runs/puppy-sideways"), "runs/puppy-sideways");
  EXPECT_EQ(shell_word("my run"), "'my run'");
  EXPECT_EQ(shell_word("it's; rm"), "'it'\\''s; rm'");
  EXPECT_EQ(shell_word(""), "''");
}

TEST(RunCommand, PassesWordsUntouchedAndTellsTheExitStatus) {
  std::string output;
  EXPECT_EQ(run_command({"printf", "%s|", "a b", "$HOME", "'"}, &output), 0);
  EXPECT_EQ(output, "a b|$HOME|'|");
  EXPECT_EQ(run_command({"sh", "-c", "exit 7"}), 7);
  EXPECT_EQ(run_command({"no-such-program-of-legwright"}), -1);
}

TEST(ViewerCommand, SurvivesQuotesInPaths) {
  const auto command = viewer_command("python3", "/a/it's/p.so", "/b \\ c/scene.xml");
  ASSERT_EQ(command.size(), 3u);
  EXPECT_NE(command[2].find("mj_loadPluginLibrary('/a/it\\'s/p.so')"), std::string::npos)
      << command[2];
  EXPECT_NE(command[2].find("from_xml_path('/b \\\\ c/scene.xml')"), std::string::npos)
      << command[2];
}

}  // namespace
}  // namespace legwright
