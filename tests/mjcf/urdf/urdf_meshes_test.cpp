// SPDX-License-Identifier: Apache-2.0
// Where the meshes of a URDF are looked for.
#include "mjcf/urdf/urdf_meshes.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/tools/files/temporary_folder.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

class UrdfMeshes : public testing::Test {
 protected:
  void add(const std::string& name) {
    const fs::path file = folder_.path() / name;
    fs::create_directories(file.parent_path());
    std::ofstream(file) << "x";
  }
  UrdfMeshFile find(const std::string& name, const std::string& mesh_folder = "") const {
    return find_urdf_mesh(name, folder_.path() / "dog_description" / "urdf", mesh_folder);
  }
  void SetUp() override { fs::create_directories(folder_.path() / "dog_description" / "urdf"); }
  const test::TemporaryFolder folder_;
};

TEST_F(UrdfMeshes, OfPackagesAreLookedForAboveTheUrdf) {
  add("dog_description/meshes/hip.stl");
  add("other/meshes/arm.STL");
  EXPECT_EQ(find("package://dog_description/meshes/hip.stl").path, "../meshes/hip.stl");
  EXPECT_EQ(find("package://renamed/meshes/hip.stl").path, "../meshes/hip.stl");
  EXPECT_EQ(find("package://other/meshes/arm.STL").path, "../../other/meshes/arm.STL");
  EXPECT_EQ(find("../meshes/hip.stl").path, "../meshes/hip.stl");
  EXPECT_EQ(find("hip.stl", "../meshes").path, "../meshes/hip.stl");
  EXPECT_EQ(find("file://" + (folder_.path() / "other/meshes/arm.STL").string()).kind,
            UrdfMeshKind::found);
  EXPECT_EQ(find("package://dog_description/meshes/knee.stl").kind, UrdfMeshKind::missing);
}

TEST_F(UrdfMeshes, OfPackagesThatXacroWouldFindAreLookedForLikewise) {
  add("dog_description/meshes/hip.stl");
  EXPECT_EQ(find("file://$(find dog_description)/meshes/hip.stl").path, "../meshes/hip.stl");
  EXPECT_EQ(find("$(find renamed)/meshes/hip.stl").path, "../meshes/hip.stl");
  EXPECT_EQ(find("$(find dog_description)/meshes/knee.stl").kind, UrdfMeshKind::missing);
  EXPECT_FALSE(behind_find_of_xacro("$(find dog_description"));
  EXPECT_FALSE(behind_find_of_xacro("$(arg meshes)/hip.stl"));
  EXPECT_FALSE(behind_find_of_xacro("package://dog_description/meshes/hip.stl"));
}

TEST_F(UrdfMeshes, ThatAreMissingAreToldWithWhereTheyWereSought) {
  const fs::path urdf = folder_.path() / "dog_description" / "urdf";
  const std::string package =
      where_mesh_was_sought("package://dog_description/meshes/hip.stl", urdf, "");
  EXPECT_EQ(
      package.rfind(
          "package dog_description was looked for in the folder " + urdf.string() + " and the ", 0),
      0u)
      << package;
  EXPECT_EQ(where_mesh_was_sought("parts/hip.stl", urdf, "../meshes"),
            "its file was looked for in " +
                (folder_.path() / "dog_description/meshes/parts").string() + ", " +
                (urdf / "parts").string() + ", " +
                (folder_.path() / "dog_description/meshes").string());
}

TEST_F(UrdfMeshes, ThatDifferInCapitalsAloneAreFound) {
  add("dog_description/Meshes/hip.STL");
  const fs::path urdf = folder_.path() / "dog_description" / "urdf";
  const std::string name = "package://dog_description/meshes/hip.stl";
  EXPECT_EQ(find(name).kind, UrdfMeshKind::missing);
  EXPECT_EQ(mesh_in_other_case(name, urdf, ""), "../Meshes/hip.STL");
  EXPECT_EQ(mesh_in_other_case("../meshes/hip.stl", urdf, ""), "../Meshes/hip.STL");
  EXPECT_EQ(mesh_in_other_case("package://dog_description/meshes/knee.stl", urdf, ""), "");
}

TEST_F(UrdfMeshes, OfWindowsHaveBackslashes) {
  add("dog_description/urdf/meshes/hip.stl");
  EXPECT_EQ(find("meshes\\hip.stl").path, "meshes/hip.stl");
  EXPECT_EQ(find("package://dog_description\\urdf\\meshes\\hip.stl").path, "meshes/hip.stl");
  EXPECT_EQ(find("meshes\\knee.stl").kind, UrdfMeshKind::missing);
}

/// What $(find PACKAGE) became on the machine of whoever expanded the macros.
TEST_F(UrdfMeshes, OfAnotherMachineAreLookedForByTheirPackage) {
  add("dog_description/meshes/hip.stl");
  EXPECT_EQ(find("file:///nowhere/ws/install/share/dog_description/meshes/hip.stl").path,
            "../meshes/hip.stl");
  EXPECT_EQ(find("/nowhere/share/dog_description/meshes/hip.stl").path, "../meshes/hip.stl");
  EXPECT_EQ(find("/nowhere/share/dog_description/meshes/arm.stl").kind, UrdfMeshKind::missing);
  add("dog_description/urdf/knee.stl");
  EXPECT_EQ(find("file:///nowhere/share/none/knee.stl").path, "knee.stl") << "beside the URDF";
  add("share/other/hip.stl");
  const std::string there = (folder_.path() / "share/other/hip.stl").string();
  EXPECT_EQ(find("file://" + there).path, "../../share/other/hip.stl") << "where it is there";
}

TEST_F(UrdfMeshes, OfOtherFormatsHaveATwinOrNone) {
  add("dog_description/meshes/hip.dae");
  EXPECT_EQ(find("package://dog_description/meshes/hip.dae").kind, UrdfMeshKind::collada);
  EXPECT_EQ(find("package://dog_description/meshes/hip.dae").path, "../meshes/hip.dae");
  EXPECT_EQ(find("package://dog_description/meshes/knee.dae").kind, UrdfMeshKind::missing);
  add("dog_description/meshes/hip.glb");
  EXPECT_EQ(find("package://dog_description/meshes/hip.glb").kind, UrdfMeshKind::unreadable);
  add("dog_description/meshes/hip.obj");
  const UrdfMeshFile found = find("package://dog_description/meshes/hip.dae");
  EXPECT_EQ(found.kind, UrdfMeshKind::other_format);
  EXPECT_EQ(found.path, "../meshes/hip.obj");
}

TEST(UrdfMesh, APackageWithoutNameIsTheFolderOfTheFile) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "body.stl") << "solid";
  const UrdfMeshFile found = find_urdf_mesh("package://body.stl", folder.path(), "");
  EXPECT_EQ(found.kind, UrdfMeshKind::found);
  EXPECT_EQ(found.path, "body.stl");
}

}  // namespace
}  // namespace legwright
