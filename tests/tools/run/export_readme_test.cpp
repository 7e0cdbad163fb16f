// SPDX-License-Identifier: Apache-2.0
#include "tools/run/export_readme.hpp"

#include <gtest/gtest.h>

#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/files/licence.hpp"
#include "tools/files/unfinished_folder.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(ExportReadme, TellsWhatChanged) {
  ExportFacts facts;
  facts.name = "dog";
  facts.parameters = {{"length", "m", "Length.", 0.1, 0.125}, {"width", "m", "Width.", 0.2, 0.2}};
  facts.mass_before = 2.0;
  facts.mass_after = 2.5;
  const std::string text = export_readme(facts);
  EXPECT_TRUE(contains(text, "| length | 0.1 | 0.125 | +0.025 | m | Length. |")) << text;
  EXPECT_TRUE(contains(text, "| width | 0.2 | 0.2 |  | m | Width. |")) << text;
  EXPECT_TRUE(contains(text, "2 kg before, 2.5 kg after"));
  EXPECT_TRUE(contains(text, "was not validated"));
  facts.chosen_verdict = "PASS  walk";
  EXPECT_FALSE(contains(export_readme(facts), "was not validated"));
  EXPECT_TRUE(contains(export_readme(facts), "- PASS  walk\n- So the search played it"));
  facts.verdicts = {"PASS  trot"};
  EXPECT_FALSE(contains(export_readme(facts), "PASS  walk"));
  EXPECT_FALSE(contains(export_readme(facts), "was not validated"));
  EXPECT_FALSE(contains(export_readme(facts), "firmer servos"));
  EXPECT_FALSE(contains(export_readme(facts), "touches itself"));
  facts.touches = "a box of 'left' and a box of 'right'";
  EXPECT_TRUE(contains(export_readme(facts), "**It touches itself**: a box of 'left'"));
  facts.servo_kp = 310.0;
  EXPECT_TRUE(contains(export_readme(facts), "played with kp 310 N m/rad"));
}

TEST(ExportReadme, TextsBringNoMarkupAndNoNewRows) {
  ExportFacts facts;
  facts.name = "dog";
  facts.model = "<script>\n# title";
  facts.parameters = {{"a|b", "m", "[link](http://x) `c`\n| new | row |", 0, 1}};
  facts.command = "legwright\n\n# out of the block";
  const std::string text = export_readme(facts);
  EXPECT_FALSE(contains(text, "<script>"));
  EXPECT_FALSE(contains(text, "\n# title"));
  EXPECT_FALSE(contains(text, "\n# out"));
  EXPECT_TRUE(contains(text, "| a\\|b |")) << text;
  EXPECT_FALSE(contains(text, "[link]"));
  EXPECT_FALSE(contains(text, "\n| new"));
}

TEST(PlainName, IsNoPath) {
  EXPECT_EQ(plain_name("../a b/\xC3\xBC"), "___a_b___");
  EXPECT_EQ(plain_name("Go-1_x"), "Go-1_x");
  EXPECT_EQ(plain_name(std::string(300, 'x')).size(), 64u);
}

TEST(Licences, FilesCountAndLinksDoNot) {
  const test::TemporaryFolder from, to;
  write_file(from.path() / "COPYING", "all of it");
  fs::create_symlink("/etc/hostname", from.path() / "LICENSE");
  write_file(from.path() / "NOTICE", std::string((1u << 20) + 1, 'x'));
  fs::create_directory(from.path() / "LICENSE.txt");
  EXPECT_EQ(copy_licences(from.path(), to.path()), std::vector<std::string>{"COPYING"});
  EXPECT_EQ(read_file(to.path() / "COPYING"), "all of it");
  EXPECT_EQ(std::distance(fs::directory_iterator(to.path()), {}), 1);
}

TEST(UnfinishedFolder, AppearsWholeOrNotAtAll) {
  const test::TemporaryFolder root;
  const fs::path target = root.path() / "out";
  {
    const UnfinishedFolder given_up(target);
    write_file(given_up.path() / "a", "a");
    EXPECT_FALSE(fs::exists(target));
  }
  EXPECT_TRUE(fs::is_empty(root.path()));
  {
    UnfinishedFolder folder(target);
    write_file(folder.path() / "a", "a");
    folder.appear();
  }
  EXPECT_EQ(read_file(target / "a"), "a");
  UnfinishedFolder second(target);
  write_file(second.path() / "a", "b");
  EXPECT_THROW(second.appear(), fs::filesystem_error);
  EXPECT_EQ(read_file(target / "a"), "a");
}

TEST(UnfinishedFolder, SweepsWhatKilledProcessesLeftAndNothingElse) {
  const test::TemporaryFolder root;
  const fs::path target = root.path() / "out";
  const fs::path left = root.path() / ".out.12345.0.tmp";
  fs::create_directories(left / "deeper");
  const std::vector<fs::path> others{root.path() / ".out.12345.tmp", root.path() / ".out.a.0.tmp",
                                     root.path() / ".outer.12345.0.tmp",
                                     root.path() / ".out.12345.0.tmp.mine"};
  for (const fs::path& other : others) fs::create_directory(other);
  fs::create_directory_symlink(others[0], root.path() / ".out.1.0.tmp");
  const UnfinishedFolder first(target);
  EXPECT_FALSE(fs::exists(left));
  for (const fs::path& other : others) EXPECT_TRUE(fs::exists(other)) << other;
  EXPECT_TRUE(fs::is_symlink(root.path() / ".out.1.0.tmp"));
  const UnfinishedFolder second(target);  // as another process would
  EXPECT_TRUE(fs::exists(first.path())) << "it is held";
  EXPECT_NE(first.path(), second.path());
}

}  // namespace
}  // namespace legwright
