// SPDX-License-Identifier: Apache-2.0
// What a robot's files may name, and what not: paths, links, pipes, sizes, chains of includes.
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
#include "tests/tools/files/temporary_folder.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::put;

class SafePath : public testing::Test {
 protected:
  SafePath() {
    put(home_ / "parts/leg.xml", "<mujoco><worldbody/></mujoco>");
    put(folder_.path() / "outside.xml", "<mujoco><worldbody/></mujoco>");
  }
  /// What is wrong with a path that stands in home/robot.xml.
  std::string fault(const std::string& reference) const {
    return find_in_folder(home_, reference, 1000).fault;
  }
  std::string refusal(const std::string& text) const {
    try {
      RobotFiles::from_text(text, home_ / "robot.xml");
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }
  static bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }

  test::TemporaryFolder folder_;
  fs::path home_ = folder_.path() / "home";
};

TEST_F(SafePath, FilesBelowTheFolderAreFound) {
  for (const char* reference :
       {"parts/leg.xml", "./parts/leg.xml", "parts/../parts//leg.xml", "no/../parts/leg.xml"}) {
    const FoundFile found = find_in_folder(home_, reference, 1000);
    EXPECT_EQ(found.fault, "") << reference;
    EXPECT_EQ(found.path, "parts/leg.xml");
    EXPECT_EQ(found.bytes, 29u);
  }
}

TEST_F(SafePath, WhatIsElsewhereIsRefused) {
  EXPECT_TRUE(has(fault("/etc/passwd"), "absolute path"));
  EXPECT_TRUE(has(fault((home_ / "parts/leg.xml").string()), "absolute path"));
  EXPECT_TRUE(has(fault("../outside.xml"), "leads out of the folder"));
  EXPECT_TRUE(has(fault("parts/../../outside.xml"), "leads out of the folder"));
  EXPECT_TRUE(has(fault("../home/parts/leg.xml"), "leads out of the folder"));
  EXPECT_TRUE(has(fault("parts\\leg.xml"), "write / between folders"));
  EXPECT_TRUE(has(fault("C:/leg.xml"), "colon"));
  EXPECT_TRUE(has(fault("http://leg.xml"), "colon"));
  EXPECT_TRUE(has(fault("leg\n.xml"), "control character"));
  EXPECT_TRUE(has(fault(""), "names no file"));
  EXPECT_TRUE(has(fault("."), "leads out"));
  EXPECT_TRUE(has(fault("parts/arm.xml"), "is not there"));
  EXPECT_TRUE(has(fault("parts/leg.xml/x"), "cannot be read: Not a directory") ||
              has(fault("parts/leg.xml/x"), "is not there"));
  EXPECT_TRUE(has(fault(std::string(5000, 'x')), "cannot be read"));
}

TEST_F(SafePath, LinksMayNotLeadOut) {
  fs::create_symlink("../outside.xml", home_ / "out.xml");
  fs::create_symlink("parts/leg.xml", home_ / "in.xml");
  fs::create_directory_symlink(folder_.path(), home_ / "up");
  fs::create_symlink("loop.xml", home_ / "loop.xml");
  fs::create_symlink("nowhere.xml", home_ / "dangling.xml");
  EXPECT_TRUE(has(fault("out.xml"), "symbolic link that leads out"));
  EXPECT_TRUE(has(fault("up/outside.xml"), "symbolic link that leads out"));
  EXPECT_TRUE(has(fault("loop.xml"), "cannot be read"));
  EXPECT_TRUE(has(fault("dangling.xml"), "is not there"));
  EXPECT_EQ(fault("in.xml"), "");
  EXPECT_EQ(find_in_folder(home_, "in.xml", 1000).path, "in.xml");
}

/// The kernel resolves `link/..` behind the link; MuJoCo and copies do not.
TEST_F(SafePath, BackThroughALinkIsRefused) {
  put(home_ / "deep/er/x.xml", "<mujoco/>");
  put(home_ / "deep/leg.xml", "<another/>");
  put(home_ / "leg.xml", "<mujoco/>");
  fs::create_directory_symlink("deep/er", home_ / "link");
  EXPECT_TRUE(has(fault("link/../leg.xml"), "write the path without .."));
  EXPECT_EQ(fault("link/x.xml"), "");
}

TEST_F(SafePath, WhatIsNoFileIsRefusedWithoutWaiting) {
  ASSERT_EQ(::mkfifo((home_ / "pipe.xml").c_str(), 0600), 0);
  EXPECT_TRUE(has(fault("pipe.xml"), "is a pipe"));
  EXPECT_TRUE(has(fault("parts"), "is a folder"));
  fs::create_symlink("/dev/zero", home_ / "zero.xml");
  EXPECT_TRUE(has(fault("zero.xml"), "is a device"));
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
  // MuJoCo looks beside the including file for some spellings of the main file's path only.
  put(home_ / "parts/outer.xml", "<mujoco>\n<include file=\"leg.xml\"/></mujoco>");
  const std::string message = refusal("<mujoco><include file=\"parts/outer.xml\"/></mujoco>");
  EXPECT_TRUE(has(message, "outer.xml:2: include: ")) << message;
  EXPECT_TRUE(has(message, "write 'parts/leg.xml'")) << message;
}

/// Folders and stripping of paths as MuJoCo has them: whatever it would open was looked at.
TEST_F(SafePath, AssetsAreThoseThatMujocoReads) {
  put(home_ / "shapes/tet.stl", test::tetrahedron_stl(0.1f));
  put(home_ / "tet.stl", test::tetrahedron_stl(0.3f));
  put(home_ / "skin/t.png", test::one_pixel_png());
  put(home_ / "shapes/hills.png", test::four_pixel_png());
  const struct {
    const char *compiler, *mesh, *path;
    double radius;
  } cases[] = {
      {"", "tet.stl", "tet.stl", 0.3},
      {"<compiler meshdir=\"shapes\"/>", "tet.stl", "shapes/tet.stl", 0.1},
      {"<compiler assetdir=\"shapes/\"/>", "./tet.stl", "shapes/tet.stl", 0.1},
      {"<compiler assetdir=\"skin\" meshdir=\"shapes\"/>", "tet.stl", "shapes/tet.stl", 0.1},
      {"<compiler meshdir=\"skin\"/><compiler assetdir=\"shapes\"/>", "tet.stl", "shapes/tet.stl",
       0.1},
      {"<compiler meshdir=\"skin\"/>", "../shapes/tet.stl", "shapes/tet.stl", 0.1},
      {"<compiler meshdir=\"shapes\" strippath=\"true\"/>", "x/y/tet.stl", "shapes/tet.stl", 0.1},
  };
  for (const auto& c : cases) {
    const std::string text = std::string("<mujoco>") + c.compiler + "<asset><mesh file=\"" +
                             c.mesh +
                             "\"/></asset><worldbody><geom type=\"mesh\" mesh=\"tet\"/></worldbody>"
                             "</mujoco>";
    const RobotFiles files = RobotFiles::from_text(text, home_ / "robot.xml");
    ASSERT_EQ(files.assets().size(), 1u) << text;
    EXPECT_EQ(files.assets()[0].path, c.path) << text;
    const ModelPointer model = compile_mjcf(text, home_ / "robot.xml");
    double largest = 0.0;
    for (int k = 0; k < 3 * model->nmeshvert; ++k)
      largest = std::max(largest, static_cast<double>(model->mesh_vert[k]));
    EXPECT_NEAR(largest, 0.75 * c.radius, 0.3 * c.radius) << text;
  }
  const std::string both =
      "<mujoco><compiler meshdir=\"shapes\" texturedir=\"skin\"/><asset>"
      "<hfield name=\"h\" file=\"hills.png\" size=\"1 1 1 1\"/>"
      "<texture name=\"t\" type=\"2d\" file=\"t.png\"/></asset></mujoco>";
  const RobotFiles files = RobotFiles::from_text(both, home_ / "robot.xml");
  ASSERT_EQ(files.assets().size(), 2u);
  EXPECT_EQ(files.assets()[0].path, "shapes/hills.png");
  EXPECT_EQ(files.assets()[1].path, "skin/t.png");
  EXPECT_EQ(compile_mjcf(both, home_ / "robot.xml")->ntex, 1);
}

TEST_F(SafePath, OtherElementsNameNoFiles) {
  put(home_ / "a.xml", "<mujoco><worldbody/></mujoco>");
  EXPECT_TRUE(
      has(refusal("<mujoco><asset><model file=\"a.xml\"/></asset></mujoco>"), "write it out here"));
  EXPECT_TRUE(has(refusal("<mujoco><asset><mesh file=\"/etc/passwd\"/></asset></mujoco>"),
                  "absolute path"));
  EXPECT_TRUE(has(refusal("<mujoco><compiler meshdir=\"/etc\"/><asset><mesh file=\"passwd\"/>"
                          "</asset></mujoco>"),
                  "absolute path"));
  EXPECT_TRUE(has(refusal("<mujoco><asset><texture type=\"cube\" fileright=\"../r.png\"/></asset>"
                          "</mujoco>"),
                  "leads out"));
}

/// Sizes are looked at before anything is read.
TEST_F(SafePath, LargeFilesAreRefused) {
  std::string text = "<mujoco><asset>";
  for (int k = 0; k < 5; ++k) {
    const fs::path file = home_ / fmt::format("m{}.stl", k);
    put(file, "x");
    fs::resize_file(file, std::uintmax_t{250} << 20);  // holes: they take no space
    text += fmt::format("<mesh file=\"m{}.stl\"/>", k);
    if (k == 3) {
      EXPECT_EQ(refusal(text + "</asset></mujoco>"), "accepted");
    }
  }
  text += "</asset></mujoco>";
  EXPECT_TRUE(has(refusal(text), "together larger than 1024 MB")) << refusal(text);
  fs::resize_file(home_ / "m0.stl", (std::uintmax_t{256} << 20) + 1);
  EXPECT_TRUE(has(refusal(text), "'m0.stl' is larger than 256 MB")) << refusal(text);

  std::string many = "<mujoco>";
  for (int k = 0; k < 5; ++k) {
    std::string part = "<mujoco><worldbody/>";
    part.append(std::size_t{4} << 20, ' ').append("</mujoco>");
    put(home_ / fmt::format("p{}.xml", k), part);
    many += fmt::format("<include file=\"p{}.xml\"/>", k);
  }
  many += "</mujoco>";
  EXPECT_TRUE(has(refusal(many), "16777216 bytes together")) << refusal(many);
  fs::resize_file(home_ / "p0.xml", (std::uintmax_t{16} << 20) + 1);
  EXPECT_TRUE(has(refusal(many), "'p0.xml' is larger than 16 MB")) << refusal(many);
}

TEST_F(SafePath, AFileIsIncludedOrAnAsset) {
  const std::string message = refusal(
      "<mujoco><include file=\"parts/leg.xml\"/>\n<asset><mesh file=\"parts/leg.xml\"/></asset>"
      "</mujoco>");
  EXPECT_TRUE(has(message, "robot.xml:2: mesh: the file 'parts/leg.xml' is included as well"))
      << message;
}

/// A packed picture unpacks to any size.
TEST_F(SafePath, HugePicturesAreRefused) {
  std::string png = test::one_pixel_png();
  const std::string text = "<mujoco><asset><texture type=\"2d\" file=\"t.png\"/></asset></mujoco>";
  put(home_ / "t.png", png);
  EXPECT_EQ(refusal(text), "accepted");
  png[17] = '\x10';
  put(home_ / "t.png", png);
  EXPECT_TRUE(has(refusal(text), "more than 16384 pixels"));
}

/// Each is allowed; all of them would take gigabytes.
TEST_F(SafePath, PicturesAreLimitedTogether) {
  const auto textures = [](int count, const std::string& what) {
    std::string text = "<mujoco><asset>";
    for (int k = 0; k < count; ++k) text += fmt::format("\n<texture name=\"t{}\" {}/>", k, what);
    return text + "</asset></mujoco>";
  };
  const std::string flat = "type=\"2d\" builtin=\"flat\" width=\"8192\" height=\"8192\"";
  EXPECT_EQ(refusal(textures(2, flat)), "accepted");
  EXPECT_TRUE(has(refusal(textures(3, flat)),
                  "robot.xml:4: texture 't2': the textures and height fields of the robot together "
                  "take more than 512 MB unpacked; make them smaller"))
      << refusal(textures(3, flat));
  const std::string sky = "type=\"skybox\" builtin=\"gradient\" width=\"4096\" height=\"4096\"";
  EXPECT_EQ(refusal(textures(1, sky)), "accepted");  // six faces
  EXPECT_TRUE(has(refusal(textures(2, sky)), "texture 't1': the textures"));
  const std::string grey =
      "type=\"2d\" builtin=\"flat\" nchannel=\"1\" width=\"8192\" height=\"8192\"";
  EXPECT_EQ(refusal(textures(8, grey)), "accepted");
  EXPECT_NE(refusal(textures(9, grey)), "accepted");
  // Pictures that are packed, and height fields.
  std::string png = test::one_pixel_png();
  png[18] = png[22] = '\x30';  // 12288 pixels a side and some
  put(home_ / "t.png", png);
  EXPECT_EQ(refusal(textures(1, "type=\"2d\" file=\"t.png\"")), "accepted");
  EXPECT_TRUE(has(refusal(textures(2, "type=\"2d\" file=\"t.png\"")), "'t1': the textures"));
  const std::string field = "<hfield name=\"h\" nrow=\"10000\" ncol=\"10000\" size=\"1 1 1 1\"/>";
  EXPECT_EQ(refusal("<mujoco><asset>" + field + "</asset></mujoco>"), "accepted");
  EXPECT_TRUE(has(refusal("<mujoco><asset>" + field + field + "</asset></mujoco>"), "hfield 'h'"));
  // A grid of faces is that of a picture in a file, and no size makes room for others.
  const std::string cube = "type=\"cube\" builtin=\"flat\" width=\"12288\" height=\"12288\"";
  EXPECT_NE(refusal(textures(1, cube)), "accepted");
  EXPECT_EQ(refusal(textures(1, cube + " gridsize=\"1 12\"")), refusal(textures(1, cube)));
  const std::string negative = "<hfield name=\"n\" nrow=\"-9999\" ncol=\"9999\" size=\"1 1 1 1\"/>";
  EXPECT_TRUE(has(refusal("<mujoco><asset>" + negative + field + field + "</asset></mujoco>"),
                  "hfield 'h'"));
}

/// The folder of a run has files of these names.
TEST_F(SafePath, NamesOfRunsAreNotForParts) {
  const std::string robot = test::read_file(test::puppy_file());
  const auto message = [&](const std::string& path) -> std::string {
    put(home_ / path, "<mujoco><custom/><worldbody/></mujoco>");
    try {
      parse_robot(test::with(robot, "</mujoco>", "<include file=\"" + path + "\"/></mujoco>"),
                  home_ / "dog.xml");
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_TRUE(has(message("scene.xml"), "named scene.xml; name this one otherwise"));
  EXPECT_TRUE(has(message("robot.xml"), "named robot.xml"));
  EXPECT_EQ(message("parts/scene.xml"), "accepted");
}

}  // namespace
}  // namespace legwright
