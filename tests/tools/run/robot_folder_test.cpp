// SPDX-License-Identifier: Apache-2.0
#include "tools/run/robot_folder.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <string>

#include "mjcf/text/input_error.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/io_error.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

class RobotFolder : public testing::Test {
 protected:
  RobotFolder() {
    fs::create_directories(home_ / "parts");
    fs::create_directories(home_ / "meshes");
    write_file(home_ / "dog.xml",
               "<mujoco><include file=\"parts/leg.xml\"/>"
               "<asset><mesh file=\"meshes/ear.stl\"/></asset></mujoco>");
    write_file(home_ / "parts/leg.xml", "<mujoco><worldbody/></mujoco>");
    write_file(home_ / "meshes/ear.stl", "an ear");
  }
  fs::path fresh(const std::string& name) const {
    fs::create_directories(folder_.path() / name);
    return folder_.path() / name;
  }

  test::TemporaryFolder folder_;
  fs::path home_ = folder_.path() / "home";
};

TEST_F(RobotFolder, FilesOfTheUserAreCopiedThoseOfTheRunLinked) {
  const RobotFiles files = RobotFiles::read(home_ / "dog.xml");
  const fs::path inputs = fresh("inputs"), design = fresh("design");
  write_robot_files(inputs, files);
  EXPECT_EQ(read_file(inputs / "robot.xml"), read_file(home_ / "dog.xml"));
  EXPECT_EQ(read_file(inputs / "parts/leg.xml"), read_file(home_ / "parts/leg.xml"));
  EXPECT_EQ(read_file(inputs / "meshes/ear.stl"), "an ear");
  EXPECT_EQ(fs::hard_link_count(home_ / "meshes/ear.stl"), 1u);  // the user may edit it in place
  write_robot_files(design, files.moved_to(inputs / "robot.xml"), Durability::process);
  EXPECT_TRUE(fs::equivalent(design / "meshes/ear.stl", inputs / "meshes/ear.stl"));
  EXPECT_FALSE(fs::equivalent(design / "parts/leg.xml", inputs / "parts/leg.xml"));

  write_file(design / "metrics.json", "{}");
  const fs::path copy = folder_.path() / "copy";
  copy_design(design, copy, files);
  EXPECT_EQ(fs::hard_link_count(inputs / "meshes/ear.stl"), 3u);
  EXPECT_EQ(read_file(copy / "parts/leg.xml"), read_file(design / "parts/leg.xml"));
  EXPECT_EQ(fs::hard_link_count(design / "metrics.json"), 1u);
  EXPECT_EQ(read_file(copy / "metrics.json"), "{}");
  EXPECT_THROW(copy_design(design, copy, files), std::system_error);  // is there already
}

/// As `init robot.xml -o dog.xml` names it.
TEST_F(RobotFolder, AFileWithoutFolderIsWrittenIntoTheCurrentOne) {
  const RobotFiles files = RobotFiles::read(home_ / "dog.xml");
  const fs::path before = fs::current_path();
  fs::current_path(fresh("here"));
  write_main_file("mine.xml", files);
  EXPECT_EQ(read_file("mine.xml"), files.main_text());
  EXPECT_TRUE(fs::exists("parts/leg.xml") && fs::exists("meshes/ear.stl"));
  try {
    write_main_file("meshes", files);
    ADD_FAILURE() << "written";
  } catch (const IoError& error) {
    EXPECT_NE(std::string(error.what()).find("give the output another name"), std::string::npos)
        << error.what();
  }
  fs::current_path(before);
}

TEST_F(RobotFolder, FilesElsewhereAreGathered) {
  fs::create_directories(home_ / "mjcf");
  write_file(home_ / "mjcf/dog.xml",
             "<mujoco><compiler meshdir=\"../meshes\"/><include file=\"../parts/leg.xml\"/>"
             "<asset><mesh file=\"ear.stl\"/></asset></mujoco>");
  const RobotFiles files = RobotFiles::read(home_ / "mjcf/dog.xml");
  const fs::path inputs = fresh("inputs"), design = fresh("design");
  write_robot_files(inputs, files);
  EXPECT_EQ(read_file(inputs / "robot.xml"),
            "<mujoco><compiler/><include file=\"parts/leg.xml\"/>"
            "<asset><mesh file=\"meshes/ear.stl\"/></asset></mujoco>");
  EXPECT_EQ(read_file(inputs / "meshes/ear.stl"), "an ear");
  write_robot_files(design, files.moved_to(inputs / "robot.xml"), Durability::process);
  EXPECT_TRUE(fs::equivalent(design / "meshes/ear.stl", inputs / "meshes/ear.stl"));

  const fs::path beside = home_ / "mjcf/new.xml", other = fresh("other") / "new.xml";
  write_main_file(beside, files);
  EXPECT_EQ(read_file(beside), read_file(home_ / "mjcf/dog.xml"));
  write_main_file(other, files);
  EXPECT_EQ(read_file(other), read_file(inputs / "robot.xml"));
  EXPECT_EQ(read_file(other.parent_path() / "parts/leg.xml"), read_file(home_ / "parts/leg.xml"));
  EXPECT_EQ(fs::hard_link_count(home_ / "meshes/ear.stl"), 1u);
  // Beside the same files, but not in the place of others.
  write_main_file(other.parent_path() / "twin.xml", files);
  EXPECT_EQ(read_file(other.parent_path() / "twin.xml"), read_file(other));
  write_file(other.parent_path() / "meshes/ear.stl", "an eye");
  EXPECT_THROW(write_main_file(other.parent_path() / "newer.xml", files), IoError);
  EXPECT_EQ(read_file(other.parent_path() / "meshes/ear.stl"), "an eye");
  EXPECT_FALSE(fs::exists(other.parent_path() / "newer.xml"));
  EXPECT_THROW(write_main_file(fresh("third") / "parts", files), IoError);
  EXPECT_TRUE(fs::is_empty(folder_.path() / "third"));
}

/// Another file system cannot link.
TEST_F(RobotFolder, WhereLinksAreImpossibleFilesAreCopied) {
  const fs::path memory = "/dev/shm";
  struct stat here {
  }, there{};
  if (::stat(folder_.path().c_str(), &here) != 0 || ::stat(memory.c_str(), &there) != 0 ||
      here.st_dev == there.st_dev)
    GTEST_SKIP() << "one file system only";
  std::string pattern = "/dev/shm/legwright-test-XXXXXX";
  if (!::mkdtemp(pattern.data())) GTEST_SKIP() << "cannot be written";
  const RobotFiles files = RobotFiles::read(home_ / "dog.xml").moved_to(home_ / "dog.xml");
  write_robot_files(pattern, files, Durability::process);
  EXPECT_EQ(read_file(fs::path(pattern) / "meshes/ear.stl"), "an ear");
  EXPECT_EQ(fs::hard_link_count(home_ / "meshes/ear.stl"), 1u);
  fs::remove_all(pattern);
}

/// What was a file when it was looked at may be a pipe when it is copied.
TEST_F(RobotFolder, AnAssetThatIsNoFileAnyMoreIsNotWaitedFor) {
  const RobotFiles files = RobotFiles::read(home_ / "dog.xml");
  fs::remove(home_ / "meshes/ear.stl");
  EXPECT_THROW(write_robot_files(fresh("a"), files), InputError);
  ASSERT_EQ(::mkfifo((home_ / "meshes/ear.stl").c_str(), 0600), 0);
  EXPECT_THROW(write_robot_files(fresh("b"), files), InputError);
}

}  // namespace
}  // namespace legwright
