// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "mjcf/shape/simpler_mesh.hpp"

namespace legwright {

/// The triangles of a Collada file (.dae, 1.4 and 1.5), those of all its geometries where the scene
/// puts them [m]. As RViz and Gazebo read it for a URDF: <unit> counts, <up_axis> does not, as the
/// link's frame says what is up. Polygons become fans; colours, textures, skins and lines are left
/// out. Throws InputError for what is no such file, at the element.
DrawnMesh read_collada(std::string text, const std::filesystem::path& file);

}  // namespace legwright
