// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "mjcf/text/file_reach.hpp"
#include "mjcf/text/robot_parts.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// An attribute that names a file.
struct AssetReference {
  const XmlElement* element;
  const char* attribute;
  bool may;          // only meshes, textures, height fields and skins may name files
  std::string path;  // with the folder that <compiler> gives for such
  bool in_folder;    // it gives one, or strips paths
};

/// All of a text, in its order, with the folders and the stripping of paths that <compiler> asks
/// for.
std::vector<AssetReference> asset_references(const XmlFile& xml);

/// A file that an element of a model names.
struct FoundAsset {
  const XmlElement* element;
  AssetFile file;
  bool gathered;  // the reference is the file's path, below the folder
};

/// The text in which a file that is not where its path leads from the folder of the main file, but
/// beside the included file that names it, is named by its path from that folder, or by its whole
/// path where <compiler> gives a folder: so MuJoCo finds it, too, which looks for it there as well.
/// @param beside the folder, from that of the main file, of the included file that has these bytes
/// of the text; empty for those of the main file
std::string named_from_main_folder(const XmlFile& xml, const std::filesystem::path& folder,
                                   const FileReach& reach,
                                   const std::function<std::filesystem::path(std::size_t)>& beside);

/// The files of all asset_references(). Throws one InputError for all elements whose files
/// find_file() refuses, that bring all together over 1 GB, or are PNG pictures of more than 16384
/// pixels a side; where textures and height fields take too much memory (PictureMemory); and that
/// must not name a file.
std::vector<FoundAsset> find_assets(const XmlFile& xml, const std::filesystem::path& folder,
                                    const FileReach& reach);

}  // namespace legwright
