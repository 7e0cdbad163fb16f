// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <limits>
#include <system_error>

#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/files/parse_json.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(WriteFile, ReplacesTheFileAndLeavesNothingElse) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "name with spaces \xC3\xA4.txt";
  for (const std::string& text :
       {std::string("first"), std::string("a\0b\n", 4), std::string(300000, 'x'), std::string()}) {
    write_file(path, text);
    EXPECT_EQ(read_file(path), text);
    write_file(path, text, Durability::process);
    EXPECT_EQ(read_file(path), text);
  }
  EXPECT_EQ(entries(folder.path()), 1u);
}

TEST(WriteFile, KeepsTheOldFileAndNoTemporaryWhenItFails) {
  const TemporaryFolder folder;
  // A folder of that name cannot be replaced by a file: the rename fails.
  fs::create_directory(folder.path() / "taken");
  std::ofstream(folder.path() / "taken" / "inside") << "kept";
  try {
    write_file(folder.path() / "taken", "text");
    FAIL() << "expected an error";
  } catch (const std::system_error& error) {
    EXPECT_NE(std::string(error.what()).find("taken"), std::string::npos) << error.what();
  }
  EXPECT_EQ(read_file(folder.path() / "taken" / "inside"), "kept");
  EXPECT_EQ(entries(folder.path()), 1u);
  EXPECT_THROW(write_file(folder.path() / "no" / "folder", "text"), std::system_error);
}

TEST(WriteFile, FollowsLinksAndKeepsModeAndOwner) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "real.xml", link = folder.path() / "link.xml";
  std::ofstream(file) << "old";
  ASSERT_EQ(::chmod(file.c_str(), 0640), 0);
  const bool root = ::geteuid() == 0;
  ASSERT_EQ(root ? ::chown(file.c_str(), 1234, 4321) : 0, 0);
  fs::create_symlink("real.xml", folder.path() / "first.xml");
  fs::create_symlink("first.xml", link);
  write_file(link, "new");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(read_file(file), "new");
  struct stat found {};
  ASSERT_EQ(::stat(file.c_str(), &found), 0);
  EXPECT_EQ(found.st_mode & 07777U, 0640U);
  EXPECT_EQ(found.st_uid, root ? 1234U : ::geteuid());
  EXPECT_EQ(found.st_gid, root ? 4321U : ::getegid());
  fs::create_symlink("not_yet.xml", folder.path() / "dangling.xml");
  write_file(folder.path() / "dangling.xml", "made");
  EXPECT_EQ(read_file(folder.path() / "not_yet.xml"), "made");
  fs::create_symlink("loop", folder.path() / "loop");
  EXPECT_THROW(write_file(folder.path() / "loop", "text"), std::system_error);
}

TEST(WriteFile, LongNamesAndLeftoversOfOtherProcessesAreNoObstacle) {
  const TemporaryFolder folder;
  const std::string longest(255, 'n');
  write_file(folder.path() / longest, "text");
  EXPECT_EQ(read_file(folder.path() / longest), "text");
  // What a killed process of the same id would have left, had it counted.
  for (int n = 0; n < 50; ++n)
    std::ofstream(folder.path() /
                  (".a." + std::to_string(::getpid()) + "-" + std::to_string(n) + ".tmp"))
        << "left";
  for (int n = 0; n < 50; ++n) write_file(folder.path() / "a", std::to_string(n));
  EXPECT_EQ(read_file(folder.path() / "a"), "49");
}

TEST(WriteFile, WritesIntoPipesAndOpenDescriptorsWithoutReplacingThem) {
  const TemporaryFolder folder;
  const fs::path fifo = folder.path() / "fifo", out = folder.path() / "out";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  const int reader = ::open(fifo.c_str(), O_RDONLY | O_NONBLOCK);
  write_file(fifo, "through");
  char bytes[16] = {};
  EXPECT_EQ(::read(reader, bytes, sizeof bytes), 7);
  EXPECT_EQ(std::string(bytes), "through");
  ::close(reader);
  EXPECT_TRUE(fs::is_fifo(fifo));

  const int open = ::open(out.c_str(), O_WRONLY | O_CREAT, 0600);
  ASSERT_EQ(::write(open, "before ", 7), 7);
  for (const std::string name : {"/dev/fd/", "/proc/self/fd/"})
    write_file(name + std::to_string(open), name + " ");
  ASSERT_EQ(::write(open, "after", 5), 5);
  ::close(open);
  EXPECT_EQ(read_file(out), "before /dev/fd/ /proc/self/fd/ after");
  write_file("/dev/null", "nothing");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(ReadFile, RefusesPipesAndDevicesAtOnce) {
  const TemporaryFolder folder;
  const fs::path fifo = folder.path() / "fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  EXPECT_THROW(read_file(fifo), IoError);  // not: waits for a writer
  EXPECT_THROW(read_file("/dev/zero"), IoError);
}

TEST(JsonFile, NestedDeeperThan64IsNoDocument) {
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + std::string(depth, ']');
  };
  EXPECT_FALSE(parse_json(nested(64)).is_discarded());
  EXPECT_TRUE(parse_json(nested(65)).is_discarded());
  EXPECT_TRUE(parse_json(std::string(30'000'000, '[')).is_discarded());
  EXPECT_FALSE(parse_json("[\"" + nested(100) + "\\\"[[\"]").is_discarded());  // of a text
  EXPECT_FALSE(parse_json("[" + std::string(1000, ' ') + "{},{},[],[]]").is_discarded());
}

TEST(ReadFile, NamesWhatIsMissingAndRefusesWhatIsTooLarge) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_file(folder.path() / "missing"), std::system_error);
  EXPECT_THROW(read_file(folder.path()), std::system_error);
  write_file(folder.path() / "ten", "0123456789");
  EXPECT_EQ(read_file(folder.path() / "ten", 10).size(), 10u);
  EXPECT_THROW(read_file(folder.path() / "ten", 9), IoError);
}

TEST(JsonFile, KeepsOrderAndEveryBitOfANumber) {
  const TemporaryFolder folder;
  const Json document{
      {"z", 0.1}, {"a", 1.0 / 3.0}, {"tiny", 5e-324}, {"big", 1.7976931348623157e308}};
  write_json(folder.path() / "x.json", document);
  EXPECT_EQ(read_json(folder.path() / "x.json"), document);
  EXPECT_EQ(read_file(folder.path() / "x.json").substr(0, 13), "{\n  \"z\": 0.1,");
}

TEST(JsonFile, NeverWritesWhatIsNoJson) {
  EXPECT_EQ(to_text({{"x", std::numeric_limits<double>::quiet_NaN()}}), "{\n  \"x\": null\n}\n");
  EXPECT_TRUE(Json::accept(to_text({{"name", "bad \xFF byte \n </script>"}})));
  const TemporaryFolder folder;
  write_file(folder.path() / "bad.json", "{\"a\": ");
  EXPECT_THROW(read_json(folder.path() / "bad.json"), IoError);
}

}  // namespace
}  // namespace legwright
