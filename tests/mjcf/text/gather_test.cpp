// SPDX-License-Identifier: Apache-2.0
// Robots whose files lie elsewhere are read as MuJoCo reads them, and written below one folder.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/gathered_names.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/robot_files.hpp"
#include "mjcf/write/model_diff.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/mjcf/robots/split_robot.hpp"
#include "tests/tools/files/temporary_folder.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::put;

ModelPointer opened(const fs::path& file) {
  char error[1000] = "";
  ModelPointer model(mj_loadXML(file.c_str(), nullptr, error, sizeof error));
  EXPECT_TRUE(model) << file << ": " << error;
  return model;
}

template <class Number>
std::string bytes_of(const Number* numbers, long count) {
  return {reinterpret_cast<const char*>(numbers), sizeof(Number) * static_cast<std::size_t>(count)};
}

/// All that a model has of meshes and textures, and their names.
std::string assets_of(const mjModel& model) {
  std::string out = bytes_of(model.mesh_vert, 3L * model.nmeshvert) +
                    bytes_of(model.mesh_face, 3L * model.nmeshface) +
                    bytes_of(model.mesh_normal, 3L * model.nmeshnormal) +
                    bytes_of(model.mesh_texcoord, 2L * model.nmeshtexcoord) +
                    bytes_of(model.hfield_data, model.nhfielddata) +
                    bytes_of(model.tex_data, static_cast<long>(model.ntexdata));
  for (int k = 0; k < model.nmesh; ++k) out += name_of(model, mjOBJ_MESH, k) + "\n";
  for (int k = 0; k < model.ntex; ++k) out += name_of(model, mjOBJ_TEXTURE, k) + "\n";
  return out;
}

void expect_same(const fs::path& before, const fs::path& after) {
  const ModelPointer a = opened(before), b = opened(after);
  ASSERT_TRUE(a && b);
  EXPECT_TRUE(model_differences(*a, *b, 0.0).empty());
  EXPECT_TRUE(assets_of(*a) == assets_of(*b));
}

/// What is written of a robot.
void put_all(const fs::path& folder, const RobotFiles& files) {
  const RobotFiles own = files.gathered();
  put(folder / "robot.xml", own.main_text());
  for (const IncludedFile& part : own.includes()) put(folder / part.path, part.text);
  for (const AssetFile& asset : own.assets())
    put(folder / asset.path, test::read_file(asset.source));
}

class Gather : public testing::Test {
 protected:
  /// Writes the robot of a file into a new folder. @return its main file there
  fs::path written(const fs::path& file, const std::string& name) const {
    put_all(folder_.path() / name, RobotFiles::read(file));
    return folder_.path() / name / "robot.xml";
  }
  static std::vector<std::string> files_below(const fs::path& folder) {
    std::vector<std::string> out;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file()) out.push_back(fs::relative(entry.path(), folder).string());
    std::sort(out.begin(), out.end());
    return out;
  }
  test::TemporaryFolder folder_;
  fs::path robot_ = test::write_package_puppy(folder_.path() / "pkg");
};

TEST_F(Gather, APackageIsReadAsMujocoReadsIt) {
  const RobotFiles files = RobotFiles::read(robot_);
  const ModelPointer stock = opened(robot_),
                     ours = compile_mjcf(files.text(), robot_, MeshDetail::triangles);
  ASSERT_TRUE(stock);
  EXPECT_EQ(stock->nmesh, 3);
  EXPECT_TRUE(model_differences(*stock, *ours, 0.0).empty());
  EXPECT_EQ(read_robot(robot_).space.size(), 20);
  EXPECT_EQ(files.main_text(), test::read_file(robot_));
}

TEST_F(Gather, CopiesHoldAllFilesAndAreTheSameModel) {
  const fs::path copy = written(robot_, "copy");
  EXPECT_EQ(
      files_below(folder_.path() / "copy"),
      (std::vector<std::string>{"common/defaults.xml", "common/drives.xml", "common/front_left.xml",
                                "common/shank.xml", "meshes/ear.stl", "meshes/nose-2.obj",
                                "meshes/nose.obj", "robot.xml", "textures/fur.png"}));
  expect_same(robot_, copy);
  const std::string text = test::read_file(copy);
  EXPECT_NE(text.find("<mesh file=\"meshes/nose-2.obj\" name=\"nose\"/>"), std::string::npos);
  EXPECT_NE(text.find("<include file='common/front_left.xml'></include><!-- FL -->"),
            std::string::npos);
  EXPECT_EQ(text.find("../"), std::string::npos);
  EXPECT_EQ(text.find("meshdir"), std::string::npos);
  EXPECT_NE(test::read_file(folder_.path() / "copy/common/front_left.xml")
                .find("file=\"common/shank.xml\""),
            std::string::npos);
  // Others are as they were, to the byte.
  for (const char* name : {"common/defaults.xml", "common/drives.xml", "common/shank.xml",
                           "meshes/ear.stl", "textures/fur.png"})
    EXPECT_EQ(test::read_file(folder_.path() / "copy" / name),
              test::read_file(folder_.path() / "pkg" / name))
        << name;

  // A copy is gathered, wherever it lies, and stands for itself.
  fs::rename(folder_.path() / "pkg", folder_.path() / "away");
  const RobotFiles again = RobotFiles::read(copy, FileReach::own_folder("a rule"));
  EXPECT_EQ(again.gathered().text(), again.text());
  expect_same(folder_.path() / "away/mjcf/robot.xml", copy);
  const fs::path twin = written(folder_.path() / "away/mjcf/robot.xml", "twin");
  for (const std::string& name : files_below(folder_.path() / "copy"))
    EXPECT_EQ(test::read_file(folder_.path() / "copy" / name),
              test::read_file(folder_.path() / "twin" / name));
}

TEST_F(Gather, TheGatheredTextIsThatOfTheCopy) {
  const RobotFiles files = RobotFiles::read(robot_).gathered();
  const RobotFiles copy = RobotFiles::read(written(robot_, "copy"));
  EXPECT_EQ(files.text(), copy.text());
  EXPECT_EQ(files.main_text(), copy.main_text());
  ASSERT_EQ(files.includes().size(), copy.includes().size());
  for (std::size_t k = 0; k < files.includes().size(); ++k) {
    EXPECT_EQ(files.includes()[k].path, copy.includes()[k].path);
    EXPECT_EQ(files.includes()[k].text, copy.includes()[k].text);
  }
  ASSERT_EQ(files.assets().size(), copy.assets().size());
  for (std::size_t k = 0; k < files.assets().size(); ++k)
    EXPECT_EQ(files.assets()[k].path, copy.assets()[k].path);
}

/// Designs are taken apart into the gathered files, lines are found in them.
TEST_F(Gather, DesignsOfAGatheredRobotAreWritten) {
  RobotModel robot = read_robot(robot_);
  gather(robot);
  const fs::path copy = written(robot_, "copy");
  robot.files = robot.files.moved_to(copy);
  robot.file = copy;
  Eigen::VectorXd s = robot.space.initial();
  for (int k = 0; k < s.size(); ++k) s[k] = 0.5 * (s[k] + robot.space.upper()[k]);
  const std::string text = rewrite_robot(robot, s);
  put_all(folder_.path() / "design", robot.files.with_text(text));
  const RobotFiles design = RobotFiles::read(folder_.path() / "design/robot.xml");
  EXPECT_EQ(design.text(), text);
  EXPECT_EQ(opened(design.file())->nmesh, 3);
  const InputError error(copy.string(), 1, "", "");
  EXPECT_EQ(robot.files.located(error).file(), copy.string());
}

TEST_F(Gather, ARobotInItsFolderKeepsEveryByte) {
  const fs::path split = test::write_split_puppy(folder_.path() / "split");
  const fs::path copy = written(split, "copy");
  EXPECT_EQ(test::read_file(copy), test::read_file(split));
  expect_same(split, copy);
}

/// Names of assets, faces of cubes, height fields, stripped and absolute paths.
TEST_F(Gather, EveryKindOfAssetIsTheSameModel) {
  const fs::path home = folder_.path() / "kinds/mjcf", above = folder_.path() / "kinds";
  put(above / "a/tet.stl", test::tetrahedron_stl(0.1f));
  put(above / "b/tet.stl", test::tetrahedron_stl(0.2f));
  put(home / "tet.stl", test::tetrahedron_stl(0.3f));
  put(above / "a/hills.png", test::four_pixel_png());
  put(above / "a/skin.png", test::one_pixel_png());
  fs::create_directory_symlink("a", above / "also_a");
  const std::string abs_b = fs::absolute(above / "b").string();
  const auto text = [&](const std::string& compiler, const std::string& assets) {
    return "<mujoco><compiler " + compiler + "/>\n<asset>" + assets +
           "</asset><worldbody><geom type=\"mesh\" mesh=\"tet\"/></worldbody></mujoco>";
  };
  const std::string cube =
      "<texture name=\"c\" type=\"cube\" fileright=\"../a/skin.png\" "
      "fileleft=\"../also_a/skin.png\"/>";
  const std::string cases[] = {
      text("", "<mesh file=\"../a/tet.stl\"/>"),
      text("", "<mesh file=\"" + abs_b + "/tet.stl\"/>"),
      text("meshdir=\"" + abs_b + "\"", "<mesh file=\"tet.stl\"/>"),
      text("assetdir=\"../a\"",
           "<mesh file='tet.stl'/><hfield file=\"hills.png\" size=\"1 1 1 1\"/>"
           "<texture type=\"2d\" file=\"skin.png\"/>"),
      text("meshdir=\"../a\" strippath=\"true\"", "<mesh file=\"x/y/tet.stl\"/>"),
      text("meshdir=\"../a\"",
           "<mesh file=\"tet.stl\"/><mesh name=\"u\" file=\"../b/tet.stl\"/>"
           "<mesh name=\"v\" file=\"../mjcf/tet.stl\"/>"
           "<mesh name=\"w\" file=\"" +
               abs_b + "/tet.stl\"/>"),
      text("", "<mesh file=\"../a/tet.stl\"/>" + cube),
      text("", "<mesh file=\"../a/tet.stl\"/><mesh name=\"s\" file=\"../also_a/tet.stl\"/>"),
  };
  int number = 0;
  for (const std::string& one : cases) {
    put(home / "robot.xml", one);
    const fs::path copy = written(home / "robot.xml", "kinds_" + std::to_string(number++));
    expect_same(home / "robot.xml", copy);
    const std::string now = test::read_file(copy);
    EXPECT_EQ(now.find("../"), std::string::npos) << now;
    EXPECT_EQ(now.find(folder_.path().string()), std::string::npos) << now;
    EXPECT_NO_THROW(RobotFiles::read(copy, FileReach::own_folder("a rule"))) << now;
  }
  // One file behind a link is copied once.
  EXPECT_EQ(files_below(folder_.path() / ("kinds_" + std::to_string(number - 1))),
            (std::vector<std::string>{"a/tet.stl", "robot.xml"}));
}

TEST_F(Gather, NamesAreToldApart) {
  const auto mention = [](const char* path) { return FileMention{path, path, "", 0, ""}; };
  const auto names = [&](std::vector<FileMention> mentions, std::size_t includes) {
    return gathered_names(mentions, includes);
  };
  using fs::path;
  auto found = names({mention("../common/a.xml"), mention("/opt/x/b.xml"), mention("m/x.stl"),
                      mention("../m/x.stl"), mention("../../m/X.stl"), mention("/one/x.stl"),
                      mention("/two/x.stl")},
                     2);
  EXPECT_EQ(found.at("../common/a.xml"), path("common/a.xml"));
  EXPECT_EQ(found.at("/opt/x/b.xml"), path("parts/b.xml"));
  EXPECT_EQ(found.at("m/x.stl"), path("m/x.stl"));
  EXPECT_EQ(found.at("../m/x.stl"), path("m/x-2.stl"));
  EXPECT_EQ(found.at("../../m/X.stl"), path("m/X-3.stl")) << "disks may know one case only";
  EXPECT_EQ(found.at("/one/x.stl"), path("assets/x.stl"));
  EXPECT_EQ(found.at("/two/x.stl"), path("assets/x-2.stl"));
  // Names of a run's own files and folders, files in the place of folders.
  found =
      names({mention("../scene.xml"), mention("../robot.xml/x.stl"), mention("../still_1/x.stl"),
             mention("../m"), mention("../../m/x.stl"), mention("../m-2")},
            1);
  EXPECT_EQ(found.at("../scene.xml"), path("robot_scene.xml"));
  EXPECT_EQ(found.at("../robot.xml/x.stl"), path("robot_robot.xml/x.stl"));
  EXPECT_EQ(found.at("../still_1/x.stl"), path("robot_still_1/x.stl"));
  EXPECT_EQ(found.at("../m"), path("m"));
  EXPECT_EQ(found.at("../../m/x.stl"), path("m-2/x.stl"));
  EXPECT_EQ(found.at("../m-2"), path("m-2-2"));
  EXPECT_EQ(names({mention("../still"), mention("../../still")}, 0).at("../../still"),
            path("still-2"));
  std::set<path> distinct;
  for (const auto& [from, to] : found) EXPECT_TRUE(distinct.insert(to).second) << from;
}

/// The folder of a run has files of these names.
TEST_F(Gather, FilesThatRunsNeedAreRenamedInCopies) {
  const fs::path home = folder_.path() / "own", robot = home / "dog.xml";
  put(home / "robot_scene.xml", "<mujoco><visual/></mujoco>");
  put(home / "scene.xml",
      "<mujoco><asset><texture type=\"2d\" file=\"frame.png\"/></asset><worldbody>"
      "<geom name=\"floor\" type=\"plane\" size=\"1 1 1\"/></worldbody></mujoco>");
  put(home / "parts/scene.xml", "<mujoco><custom/></mujoco>");
  put(home / "frame.png", test::one_pixel_png());
  put(robot, test::with(test::read_file(test::puppy_file()), "</mujoco>",
                        "<include file=\"scene.xml\"/><include file=\"parts/scene.xml\"/>"
                        "<include file=\"robot_scene.xml\"/></mujoco>"));
  EXPECT_EQ(read_robot(robot).space.size(), read_robot(test::puppy_file()).space.size());
  const fs::path copy = written(robot, "copy");
  EXPECT_EQ(files_below(copy.parent_path()),
            (std::vector<std::string>{"parts/scene.xml", "robot.xml", "robot_frame.png",
                                      "robot_scene-2.xml", "robot_scene.xml"}));
  expect_same(robot, copy);
  EXPECT_EQ(RobotFiles::read(copy).gathered().main_text(), test::read_file(copy));
}

TEST_F(Gather, ErrorsNameTheFileElsewhere) {
  const fs::path shank = folder_.path() / "pkg/common/shank.xml";
  put(shank, test::with(test::read_file(shank), "<geom", "<wheel"));
  try {
    read_robot(robot_);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.file(), shank.string());
    EXPECT_EQ(error.line(), 4);
  }
}

}  // namespace
}  // namespace legwright
