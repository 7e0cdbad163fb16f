// SPDX-License-Identifier: Apache-2.0
// Collada files that a URDF names are written into its MJCF.
#include "mjcf/urdf/collada_meshes.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/robot_files.hpp"
#include "mjcf/urdf/read_urdf.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/mjcf/urdf/collada_box.hpp"
#include "tests/mjcf/urdf/hopper.hpp"
#include "tests/tools/files/temporary_folder.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::kHopper;

class ColladaOfUrdf : public testing::Test {
 protected:
  ColladaOfUrdf() { fs::create_directory(home_); }
  void add(const fs::path& file, const std::string& text) const { std::ofstream(file) << text; }
  /// Hopper with a mesh as the trunk's picture, or as what collides.
  static std::string hopper(const char* kind, const char* mesh) {
    return test::with(kHopper, std::string("<") + kind + "><geometry><box size=\"0.2 0.1 0.04\"/>",
                      std::string("<") + kind + "><geometry><mesh filename=\"" + mesh +
                          "\" scale=\"0.2 0.1 0.04\"/>");
  }
  const test::TemporaryFolder folder_;
  const fs::path home_ = folder_.path() / "home", urdf_ = home_ / "hopper.urdf";
  const std::string box_ = test::collada(test::kPolylist, test::kShown);
};

TEST_F(ColladaOfUrdf, IsWrittenIntoTheMjcf) {
  add(home_ / "box.dae", box_);
  const std::string urdf = test::with(hopper("visual", "package://dog/box.dae"),
                                      "<collision name=\"shell\">", "<collision>");
  const MjcfOfUrdf made = mjcf_of_urdf(urdf, urdf_);
  EXPECT_TRUE(test::tells(made.notes[0], "of Collada, which MuJoCo cannot read")) << made.notes[0];
  const ModelPointer model = compile_mjcf(made.text, home_ / "robot.xml", MeshDetail::triangles);
  ASSERT_EQ(model->nmesh, 1);
  EXPECT_EQ(model->mesh_facenum[0], 12);
  const int geom = model->body_geomadr[mj_name2id(model.get(), mjOBJ_BODY, "trunk")];
  ASSERT_EQ(model->geom_type[geom], mjGEOM_MESH);
  EXPECT_NEAR(model->geom_aabb[6 * geom + 3] * model->geom_aabb[6 * geom + 4] *
                  model->geom_aabb[6 * geom + 5],
              0.1 * 0.05 * 0.02, 1e-9)
      << "half sizes, scaled";
  EXPECT_EQ(made.text.find(".dae"), std::string::npos);
}

TEST_F(ColladaOfUrdf, MayCollide) {
  add(home_ / "box.dae", box_);
  const std::string urdf =
      test::with(kHopper, "<collision name=\"shell\"><geometry><box size=\"0.2 0.1 0.04\"/>",
                 "<collision name=\"shell\"><geometry><mesh filename=\"box.dae\"/>");
  const ModelPointer model = compile_mjcf(mjcf_of_urdf(urdf, urdf_).text, home_ / "robot.xml");
  const int shell = mj_name2id(model.get(), mjOBJ_GEOM, "shell");
  ASSERT_GE(shell, 0);
  EXPECT_EQ(model->geom_type[shell], mjGEOM_MESH);
  EXPECT_NE(model->geom_contype[shell], 0);
}

TEST_F(ColladaOfUrdf, WhatIsNoMeshIsLeftOutAndTold) {
  add(home_ / "broken.dae", box_.substr(0, 300));
  add(home_ / "flat.dae", test::with(box_, "0 0 1 1 0 1 1 1 1 0 1 1", "0 0 0 1 0 0 1 1 0 0 1 0"));
  for (const char* name : {"broken.dae", "flat.dae"}) {
    const MjcfOfUrdf made = mjcf_of_urdf(hopper("visual", name), urdf_);
    EXPECT_EQ(compile_mjcf(made.text, home_ / "robot.xml")->nmesh, 0) << name;
    ASSERT_EQ(made.left_out.size(), 1u) << name;
    EXPECT_TRUE(test::tells(made.left_out[0], name)) << made.left_out[0];
  }
}

TEST_F(ColladaOfUrdf, LiesWithinReach) {
  add(folder_.path() / "box.dae", box_);
  const std::string urdf = hopper("visual", "../box.dae");
  EXPECT_EQ(compile_mjcf(UrdfReader(urdf, urdf_).read().text, home_ / "robot.xml")->nmesh, 1);
  UrdfReader confined(urdf, urdf_, FileReach::own_folder("a rule"));
  EXPECT_EQ(compile_mjcf(confined.read().text, home_ / "robot.xml")->nmesh, 0);
}

TEST_F(ColladaOfUrdf, OneThatCollidesAndIsNotThereIsRefused) {
  const std::string urdf =
      test::with(kHopper, "<collision name=\"shell\"><geometry><box size=\"0.2 0.1 0.04\"/>",
                 "<collision name=\"shell\"><geometry><mesh filename=\"box.dae\"/>");
  try {
    mjcf_of_urdf(urdf, urdf_);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_TRUE(test::tells(error.what(), "the mesh 'box.dae' of its <collision> is not there"))
        << error.what();
  }
}

/// MuJoCo's reader calls meshes by their files without folder and ending.
TEST_F(ColladaOfUrdf, MeshesOfOneNameInTwoFoldersAreTwo) {
  fs::create_directories(home_ / "visual");
  fs::create_directories(home_ / "collision");
  add(home_ / "visual/box.dae", box_);
  add(home_ / "collision/box.obj",
      "v 0 0 0\nv 3 0 0\nv 0 3 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  std::string urdf = test::with(kHopper, "<visual><geometry><box size=\"0.2 0.1 0.04\"/>",
                                "<visual><geometry><mesh filename=\"visual/box.dae\"/>");
  urdf = test::with(urdf, "<collision name=\"shell\"><geometry><box size=\"0.2 0.1 0.04\"/>",
                    "<collision name=\"shell\"><geometry><mesh filename=\"collision/box.obj\"/>");
  const ModelPointer model =
      compile_mjcf(mjcf_of_urdf(urdf, urdf_).text, home_ / "robot.xml", MeshDetail::triangles);
  ASSERT_EQ(model->nmesh, 2);
  const int shell = mj_name2id(model.get(), mjOBJ_GEOM, "shell");
  EXPECT_EQ(model->mesh_facenum[model->geom_dataid[shell]], 4) << "the one that collides";
}

TEST_F(ColladaOfUrdf, PointersOfGitLfsAreToldOrRefused) {
  add(home_ / "box.dae", "version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 1\n");
  const MjcfOfUrdf made = mjcf_of_urdf(hopper("visual", "box.dae"), urdf_);
  ASSERT_EQ(made.left_out.size(), 1u);
  EXPECT_TRUE(test::tells(made.left_out[0], "pointer of Git LFS")) << made.left_out[0];
  const std::string colliding =
      test::with(kHopper, "<collision name=\"shell\"><geometry><box size=\"0.2 0.1 0.04\"/>",
                 "<collision name=\"shell\"><geometry><mesh filename=\"box.dae\"/>");
  try {
    mjcf_of_urdf(colliding, urdf_);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_TRUE(test::tells(error.what(),
                            "link 'trunk': the file 'box.dae', which may touch, is a "
                            "pointer of Git LFS"))
        << error.what();
  }
}

/// As scans and CAD programs leave them.
TEST_F(ColladaOfUrdf, ManyTrianglesBecomeFewer) {
  std::string corners, faces;
  constexpr int kSide = 60;
  for (int i = 0; i <= kSide; ++i)
    for (int j = 0; j <= kSide; ++j)
      corners += fmt::format("{} {} {} ", i, j, (i * j) % 7 == 0 ? 1 : 0);
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      const int a = i * (kSide + 1) + j, b = a + kSide + 1;
      faces += fmt::format("{} {} {} {} ", a, b, b + 1, a + 1);
    }
  std::string counts;
  for (int k = 0; k < kSide * kSide; ++k) counts += "4 ";
  std::string text = test::with(box_, test::kCorners, corners);
  text = test::with(text, "4 4 4 4 4 4", counts);
  text = test::with(text, "0 3 2 1 4 5 6 7 0 1 5 4 1 2 6 5 2 3 7 6 3 0 4 7", faces);
  add(home_ / "box.dae", text);
  ColladaMeshes meshes(home_, {});
  const ColladaMesh* const mesh = meshes.find("box.dae");
  ASSERT_NE(mesh, nullptr);
  EXPECT_LE(mesh->mesh.triangles(), 1.3 * kColladaTriangles);
  EXPECT_GT(mesh->mesh.triangles(), 1000u);
  EXPECT_EQ(meshes.find("box.dae"), mesh) << "read once";
  EXPECT_EQ(meshes.find("box.stl"), nullptr);
}

}  // namespace
}  // namespace legwright
