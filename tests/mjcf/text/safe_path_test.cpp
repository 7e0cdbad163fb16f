// SPDX-License-Identifier: Apache-2.0
// What a robot's files may name, and what not: paths, links, pipes, chains of includes.
#include "mjcf/text/safe_path.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <functional>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/robot_files.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/mjcf/robots/split_robot.hpp"
#include "tests/mjcf/text/robot_home.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::put;

class SafePath : public test::RobotHome {};

TEST_F(SafePath, FilesBelowTheFolderAreFound) {
  for (const char* reference :
       {"parts/leg.xml", "./parts/leg.xml", "parts/../parts//leg.xml", "no/../parts/leg.xml"}) {
    const FoundFile found = find_file(home_, reference, 1000);
    EXPECT_EQ(found.fault, "") << reference;
    EXPECT_EQ(found.path, "parts/leg.xml");
    EXPECT_EQ(found.bytes, 29u);
  }
}

TEST_F(SafePath, FilesElsewhereAreFoundAsMujocoFindsThem) {
  const fs::path outside = folder_.path() / "outside.xml";
  for (const std::string& reference :
       {std::string("../outside.xml"), std::string("parts/../../outside.xml"),
        std::string("../home/../no/../outside.xml")}) {
    const FoundFile found = find_file(home_, reference, 1000);
    EXPECT_EQ(found.fault, "") << reference;
    EXPECT_EQ(found.path, "../outside.xml");
    EXPECT_EQ(found.source, outside);
  }
  const FoundFile absolute = find_file(home_, (home_ / ".." / "outside.xml").string(), 1000);
  EXPECT_EQ(absolute.fault, "");
  EXPECT_EQ(absolute.path, outside);
  EXPECT_EQ(absolute.source, outside);
  // What lies in the folder after all is called so.
  for (const std::string& reference :
       {std::string("../home/parts/leg.xml"), (home_ / "parts/leg.xml").string()})
    EXPECT_EQ(find_file(home_, reference, 1000).path, "parts/leg.xml") << reference;
  EXPECT_EQ(find_file("", "../x.xml", 1000).source, "../x.xml");
  EXPECT_EQ(find_file("a/b", "../../../x.xml", 1000).source, "../x.xml");
}

/// As programs of Windows write them, and MuJoCo reads them here: in assets, folders and includes,
/// also where they are gathered for a run.
TEST_F(SafePath, BackslashesStandBetweenFolders) {
  for (const char* reference : {"parts\\leg.xml", ".\\parts\\leg.xml", "no\\..\\parts\\leg.xml"})
    EXPECT_EQ(find_file(home_, reference, 1000).path, "parts/leg.xml") << reference;
  put(home_ / "a:b.stl", test::tetrahedron_stl(0.1f));
  EXPECT_EQ(find_file(home_, "a:b.stl", 1000).path, "a:b.stl") << "a name, and no drive";
  EXPECT_TRUE(has(fault("..\\outside.xml", confined_), "out of reach"));
  put(home_ / "meshes/fine/leg.stl", test::tetrahedron_stl(0.1f));
  put(home_ / "parts/inc.xml",
      "<mujoco><worldbody><body name=\"trunk\"><freejoint/><geom type=\"mesh\" mesh=\"leg\"/>"
      "</body></worldbody></mujoco>");
  for (const std::string named : {"file=\"meshes\\fine\\leg.stl\"/>",
                                  "file=\"fine\\leg.stl\"/></asset><compiler "
                                  "meshdir=\"..\\home\\meshes\"/><asset>"}) {
    const std::string text =
        "<mujoco><asset><mesh " + named + "</asset><include file=\"parts\\inc.xml\"/></mujoco>";
    put(home_ / "robot.xml", text);
    const RobotFiles files = RobotFiles::read(home_ / "robot.xml");
    ASSERT_EQ(files.assets().size(), 1u);
    EXPECT_EQ(files.assets().front().path, "meshes/fine/leg.stl");
    EXPECT_EQ(compile_mjcf(files.text(), files.file())->nmesh, 1) << "as MuJoCo does";
    const RobotFiles gathered = files.gathered();
    EXPECT_EQ(gathered.assets().front().path, "meshes/fine/leg.stl") << gathered.text();
    EXPECT_EQ(compile_mjcf(gathered.text(), gathered.file())->nmesh, 1);
  }
}

/// As archives of repositories have them.
TEST_F(SafePath, PointersOfGitLfsAreNotTheFile) {
  const std::string head = "version https://git-lfs.github.com/spec/v1\n";
  put(home_ / "leg.stl", head + "oid sha256:00\nsize 12345\n");
  EXPECT_TRUE(has(fault("leg.stl"), "is a pointer of Git LFS, not the file: `git lfs install`"));
  put(home_ / "leg.stl", head + std::string(2000, 'x'));
  EXPECT_EQ(find_file(home_, "leg.stl", 10000).fault, "") << "too large for one";
}

TEST_F(SafePath, WordsThatAreNoPathAreRefused) {
  for (const char* windows : {"C:/leg.xml", "C:\\parts\\leg.xml", "\\parts\\leg.xml"})
    EXPECT_TRUE(has(fault(windows), "a path of a Windows computer")) << windows;
  EXPECT_TRUE(has(fault("http://leg.xml"), "names places elsewhere"));
  EXPECT_TRUE(has(fault("leg\n.xml"), "control character"));
  EXPECT_TRUE(has(fault(""), "names no file"));
  EXPECT_TRUE(has(fault("."), "is a folder"));
  EXPECT_TRUE(has(fault("parts/arm.xml"), "is not there"));
  EXPECT_TRUE(has(fault("parts/leg.xml/x"), "cannot be read: Not a directory") ||
              has(fault("parts/leg.xml/x"), "is not there"));
  EXPECT_TRUE(has(fault(std::string(5000, 'x')), "cannot be read"));
}

TEST_F(SafePath, LinksAreFollowed) {
  fs::create_symlink("../outside.xml", home_ / "out.xml");
  fs::create_symlink("parts/leg.xml", home_ / "in.xml");
  fs::create_directory_symlink(folder_.path(), home_ / "up");
  fs::create_symlink("loop.xml", home_ / "loop.xml");
  fs::create_symlink("nowhere.xml", home_ / "dangling.xml");
  for (const char* reference : {"out.xml", "up/outside.xml", "in.xml"}) {
    const FoundFile found = find_file(home_, reference, 1000);
    EXPECT_EQ(found.fault, "") << reference;
    EXPECT_EQ(found.path, reference);
  }
  EXPECT_TRUE(has(fault("loop.xml"), "cannot be read: Too many levels of symbolic links"));
  EXPECT_TRUE(has(fault("../home/loop.xml"), "cannot be read"));
  EXPECT_TRUE(has(fault("dangling.xml"), "is not there"));
}

/// The kernel resolves `link/..` behind the link; MuJoCo and copies do not.
TEST_F(SafePath, BackFromALinkIsWhereTheLinkIs) {
  put(home_ / "deep/er/x.xml", "<mujoco/>");
  put(home_ / "deep/tet.stl", test::tetrahedron_stl(0.3f));
  put(home_ / "tet.stl", test::tetrahedron_stl(0.1f));
  fs::create_directory_symlink("deep/er", home_ / "link");
  EXPECT_EQ(find_file(home_, "link/../tet.stl", 1000).source, home_ / "tet.stl");
  const std::string text =
      "<mujoco><asset><mesh file=\"link/../tet.stl\"/></asset><worldbody>"
      "<geom type=\"mesh\" mesh=\"tet\"/></worldbody></mujoco>";
  EXPECT_LT(compile_mjcf(text, home_ / "robot.xml")->mesh_vert[0], 0.1f);
}

TEST_F(SafePath, ConfinedReadingStaysInTheFolder) {
  const auto refused = [&](const std::string& reference, const std::string& place) {
    const std::string found = fault(reference, confined_);
    return has(found, "lies at " + place) && has(found, "out of reach: a rule");
  };
  const std::string outside = (folder_.path() / "outside.xml").string();
  EXPECT_TRUE(refused("../outside.xml", outside));
  EXPECT_TRUE(refused("parts/../../outside.xml", outside));
  EXPECT_TRUE(refused("/etc/passwd", "/etc/passwd"));
  EXPECT_TRUE(refused("/dev/zero", "/dev/zero"));
  EXPECT_TRUE(refused("../nothing/here.xml", (folder_.path() / "nothing/here.xml").string()))
      << "whether it is there is not told";
  EXPECT_TRUE(refused("../home2/leg.xml", (folder_.path() / "home2/leg.xml").string()));
  fs::create_symlink("../outside.xml", home_ / "out.xml");
  fs::create_symlink("parts/leg.xml", home_ / "in.xml");
  fs::create_directory_symlink(folder_.path(), home_ / "up");
  EXPECT_TRUE(refused("out.xml", fs::canonical(outside).string()));
  EXPECT_TRUE(has(fault("out.xml", confined_), "symbolic link"));
  EXPECT_TRUE(refused("up/outside.xml", fs::canonical(outside).string()));
  for (const std::string& reference :
       {std::string("parts/leg.xml"), std::string("in.xml"), std::string("../home/parts/leg.xml"),
        (home_ / "parts/leg.xml").string()})
    EXPECT_EQ(fault(reference, confined_), "") << reference;
  const std::string text = "<mujoco>\n<include file=\"../outside.xml\"/></mujoco>";
  EXPECT_TRUE(has(refusal(text, confined_), "robot.xml:2: include: '../outside.xml' lies at"));
  EXPECT_EQ(refusal(text), "accepted");
}

TEST_F(SafePath, ReadingBelowSomeFolders) {
  const fs::path real = fs::canonical(folder_.path());
  const FileReach reach = FileReach::below({real / "home", real / "more"}, "a rule");
  put(folder_.path() / "more/x.xml", "<mujoco/>");
  fs::create_symlink("../outside.xml", folder_.path() / "more/out.xml");
  const auto found = [&](const std::string& reference) {
    return find_file(real / "home", reference, 1000, reach).fault;
  };
  EXPECT_EQ(found("parts/leg.xml"), "");
  EXPECT_EQ(found("../more/x.xml"), "");
  EXPECT_EQ(found((real / "more/x.xml").string()), "");
  EXPECT_TRUE(has(found("../outside.xml"), "a rule"));
  EXPECT_TRUE(has(found("../more/out.xml"), "a rule"));
  EXPECT_TRUE(has(found("/etc/passwd"), "lies at /etc/passwd, a rule"));
}

TEST_F(SafePath, WhatIsNoFileIsRefusedWithoutWaiting) {
  ASSERT_EQ(::mkfifo((home_ / "pipe.xml").c_str(), 0600), 0);
  EXPECT_TRUE(has(fault("pipe.xml"), "is a pipe"));
  EXPECT_TRUE(has(fault("parts"), "is a folder"));
  fs::create_symlink("/dev/zero", home_ / "zero.xml");
  EXPECT_TRUE(has(fault("zero.xml"), "is a device"));
  ASSERT_EQ(::mkfifo((folder_.path() / "pipe.xml").c_str(), 0600), 0);
  EXPECT_TRUE(has(fault("../pipe.xml"), "is a pipe; name a regular file"));
  EXPECT_TRUE(has(fault("/dev/zero"), "is a device; name a regular file"));
  EXPECT_TRUE(has(fault(".."), "is a folder"));
  EXPECT_TRUE(has(fault("/"), "is a folder"));
  put(home_ / "empty.xml", "");
  EXPECT_TRUE(has(fault("empty.xml"), "is empty"));
  put(home_ / "large.xml", std::string(1001, ' '));
  EXPECT_TRUE(has(fault("large.xml"), "is larger than"));
  EXPECT_THROW(read_regular_file(home_ / "pipe.xml", 10), InputError);
  EXPECT_THROW(RobotFiles::read(home_ / "pipe.xml"), InputError);
  if (::geteuid() == 0) return;  // who may read everything
  put(home_ / "secret.xml", "x");
  fs::permissions(home_ / "secret.xml", fs::perms::none);
  EXPECT_TRUE(has(fault("secret.xml"), "mend its permissions"));
}

TEST_F(SafePath, CyclesAreReportedWithTheirChain) {
  const std::string main = "<mujoco>\n<include file=\"a.xml\"/></mujoco>";
  put(home_ / "robot.xml", main);
  put(home_ / "a.xml", "<mujoco><include file=\"b.xml\"/></mujoco>");
  put(home_ / "b.xml", "<mujoco>\n\n<include file=\"a.xml\"/></mujoco>");
  std::string message = refusal(main);
  EXPECT_EQ(message.rfind((home_ / "b.xml").string() + ":3: include: ", 0), 0u) << message;
  EXPECT_TRUE(has(message, "includes itself: a.xml > b.xml > a.xml; remove")) << message;
  put(home_ / "b.xml", "<mujoco><include file=\"robot.xml\"/></mujoco>");
  message = refusal(main);
  EXPECT_TRUE(has(message, "robot.xml > a.xml > b.xml > robot.xml")) << message;
  message = refusal("<mujoco><include file=\"robot.xml\"/></mujoco>");
  EXPECT_TRUE(has(message, "robot.xml > robot.xml")) << message;
  fs::create_symlink("a.xml", home_ / "c.xml");  // the same file by another name
  put(home_ / "a.xml", "<mujoco><include file=\"c.xml\"/></mujoco>");
  EXPECT_TRUE(has(refusal(main), "a.xml > a.xml"));
}

TEST_F(SafePath, EachFileIsIncludedOnce) {
  const std::string twice =
      "<mujoco><include file=\"parts/leg.xml\"/>\n<include file=\"./parts/leg.xml\"/></mujoco>";
  const std::string message = refusal(twice);
  EXPECT_TRUE(has(message, "robot.xml:2: include: ")) << message;
  EXPECT_TRUE(has(message, "a second time, first by " + (home_ / "robot.xml").string() + ":1"))
      << message;
}

TEST_F(SafePath, ChainsAndNumbersAreLimited) {
  for (int k = 0; k < 12; ++k)
    put(home_ / fmt::format("c{}.xml", k),
        fmt::format("<mujoco><include file=\"c{}.xml\"/></mujoco>", k + 1));
  EXPECT_TRUE(has(refusal("<mujoco><include file=\"c0.xml\"/></mujoco>"), "more than 8 deep"));
  put(home_ / "c7.xml", "<mujoco><worldbody/></mujoco>");
  EXPECT_EQ(refusal("<mujoco><include file=\"c0.xml\"/></mujoco>"), "accepted");
  std::string many = "<mujoco>";
  for (int k = 0; k < 101; ++k) {
    put(home_ / fmt::format("m{}.xml", k), "<mujoco><worldbody/></mujoco>");
    many += fmt::format("<include file=\"m{}.xml\"/>", k);
  }
  EXPECT_TRUE(has(refusal(many + "</mujoco>"), "at most 100"));
}

TEST_F(SafePath, IncludesAreOfOneForm) {
  EXPECT_TRUE(has(refusal("<mujoco><include file=\"parts/leg.xml\" prefix=\"a\"/></mujoco>"),
                  "attribute prefix"));
  EXPECT_TRUE(has(refusal("<mujoco><include/></mujoco>"), "names no file"));
  EXPECT_TRUE(
      has(refusal("<mujoco><include file=\"parts/leg.xml\"><a/></include></mujoco>"), "nothing"));
  // The root of an included file may have any name.
  put(home_ / "parts/any.xml", "<group>\n<option timestep=\"0.001\"/></group>");
  EXPECT_EQ(refusal("<mujoco><include file=\"parts/any.xml\"/></mujoco>"), "accepted");
  // From the folder of the main file, else beside the file that includes it.
  put(home_ / "parts/outer.xml", "<mujoco>\n<include file=\"leg.xml\"/></mujoco>");
  const std::string outer = "<mujoco><include file=\"parts/outer.xml\"/></mujoco>";
  EXPECT_EQ(refusal(outer), "accepted");
  put(home_ / "leg.xml", "<mujoco/>");  // without elements
  EXPECT_TRUE(has(refusal(outer), "home/leg.xml:1: mujoco: an included file without elements"))
      << refusal(outer);
  fs::remove(home_ / "leg.xml");
  fs::remove(home_ / "parts/leg.xml");
  EXPECT_TRUE(has(refusal(outer), "outer.xml:2: include: 'leg.xml' is not there"))
      << refusal(outer);
}

}  // namespace
}  // namespace legwright
