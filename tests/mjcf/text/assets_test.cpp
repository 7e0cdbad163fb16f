// SPDX-License-Identifier: Apache-2.0
// Meshes, textures and height fields: where they are looked for, how large they may be.
#include "mjcf/text/assets.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/mjcf/text/robot_home.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::put;

class Assets : public test::RobotHome {};

/// Folders and stripping of paths as MuJoCo has them: whatever it would open was looked at.
TEST_F(Assets, AssetsAreThoseThatMujocoReads) {
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

TEST_F(Assets, OtherElementsNameNoFiles) {
  put(home_ / "a.xml", "<mujoco><worldbody/></mujoco>");
  EXPECT_TRUE(has(refusal("<mujoco><asset><model file=\"a.xml\"/></asset></mujoco>"),
                  "m.mj_saveLastXML('"));
  for (const char* text :
       {"<mujoco><asset><mesh file=\"/etc/passwd\"/></asset></mujoco>",
        "<mujoco><compiler meshdir=\"/etc\"/><asset><mesh file=\"passwd\"/></asset></mujoco>",
        "<mujoco><asset><texture type=\"cube\" fileright=\"../r.png\"/></asset></mujoco>"})
    EXPECT_TRUE(has(refusal(text, confined_), "out of reach: a rule")) << text;
  EXPECT_TRUE(has(refusal("<mujoco><asset><mesh file=\"/dev/zero\"/></asset></mujoco>"),
                  "the file '/dev/zero' is a device"));
}

TEST_F(Assets, AllFilesThatAreNotThereAreTold) {
  put(home_ / "tet.stl", test::tetrahedron_stl(0.1f));
  const std::string told = refusal(
      "<mujoco><asset><mesh file=\"a.stl\"/>\n<mesh file=\"tet.stl\"/>\n"
      "<mesh file=\"b.stl\"/>\n<texture type=\"2d\" file=\"c.png\"/></asset></mujoco>");
  EXPECT_TRUE(has(told, "robot.xml:1: mesh: the file 'a.stl' is not there")) << told;
  EXPECT_TRUE(has(told, "robot.xml:3: mesh: the file 'b.stl' is not there")) << told;
  EXPECT_TRUE(has(told, "robot.xml:4: texture: the file 'c.png' is not there")) << told;
  EXPECT_FALSE(has(told, "tet.stl")) << told;
}

/// Sizes are looked at before anything is read.
TEST_F(Assets, LargeFilesAreRefused) {
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

TEST_F(Assets, AFileIsIncludedOrAnAsset) {
  const std::string message = refusal(
      "<mujoco><include file=\"parts/leg.xml\"/>\n<asset><mesh file=\"parts/leg.xml\"/></asset>"
      "</mujoco>");
  EXPECT_TRUE(has(message, "robot.xml:2: mesh: the file 'parts/leg.xml' is included as well"))
      << message;
}

/// A packed picture unpacks to any size.
TEST_F(Assets, HugePicturesAreRefused) {
  std::string png = test::one_pixel_png();
  const std::string text = "<mujoco><asset><texture type=\"2d\" file=\"t.png\"/></asset></mujoco>";
  put(home_ / "t.png", png);
  EXPECT_EQ(refusal(text), "accepted");
  png[17] = '\x10';
  put(home_ / "t.png", png);
  EXPECT_TRUE(has(refusal(text), "more than 16384 pixels"));
}

/// Each is allowed; all of them would take gigabytes.
TEST_F(Assets, PicturesAreLimitedTogether) {
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

}  // namespace
}  // namespace legwright
