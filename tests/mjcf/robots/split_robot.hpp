// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace legwright::test {

/// Writes bytes, with the folders above them.
void put(const std::filesystem::path& file, const std::string& bytes);
/// A tetrahedron as a binary STL, as an OBJ; PNG pictures of one pixel and of two by two.
std::string tetrahedron_stl(float size);
std::string tetrahedron_obj();
std::string one_pixel_png();
std::string four_pixel_png();

/// The puppy of the examples in several files below a folder: dog.xml, which includes
/// parts/defaults.xml, parts/front_left.xml (in the trunk; includes parts/shank.xml) and
/// parts/drives.xml; meshes and a texture in assets/ and assets/pictures/. Returns dog.xml's path.
std::filesystem::path write_split_puppy(const std::filesystem::path& folder);

/// The same puppy as many robots are published, below a folder: mjcf/robot.xml, with
/// meshdir="../meshes", texturedir="../textures", the included files in ../common (of which one
/// includes another beside itself), and a mesh in mjcf/meshes that is called as one in ../meshes.
/// Returns robot.xml's path.
std::filesystem::path write_package_puppy(const std::filesystem::path& folder);

}  // namespace legwright::test
