// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <system_error>

#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"

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
