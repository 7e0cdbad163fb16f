// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "mjcf/text/robot_parts.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// A file that an element of a model names.
struct FoundAsset {
  const XmlElement* element;
  AssetFile file;
};

/// The files of meshes, textures, height fields and skins, in the order of the text, with the
/// folders and the stripping of paths that <compiler> asks for. Throws InputError at the element
/// whose file find_in_folder() refuses, that is larger than 256 MB, that brings all together over
/// 1 GB, or that is a PNG picture of more than 16384 pixels a side; where textures and height
/// fields take too much memory (PictureMemory); and at any other element that names a file.
std::vector<FoundAsset> find_assets(const XmlFile& xml, const std::filesystem::path& folder);

}  // namespace legwright
