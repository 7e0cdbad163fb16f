// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/assets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "mjcf/text/refusals.hpp"
#include "mjcf/text/safe_path.hpp"
#include "mjcf/text/size_limits.hpp"
#include "mjcf/text/text_edits.hpp"
#include "mjcf/text/written_out.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostBytes = std::uintmax_t{256} << 20;
constexpr std::uintmax_t kMostBytesTogether = std::uintmax_t{1} << 30;
constexpr unsigned kMostPixels = 16384;  // a side; packed pictures unpack to any size

/// Where MuJoCo looks for the files of a model: what is said last holds.
struct AssetFolders {
  std::string meshes, textures;
  bool strips = false;  // of a path only the last part counts
};

AssetFolders asset_folders(const XmlFile& xml) {
  AssetFolders folders;
  for_each_element(xml.root(), [&](const XmlElement& element) {
    if (!is_tag(element, "compiler")) return;
    const auto take = [&](const char* name, std::string& folder) {
      if (has_attribute(element, name)) folder = attribute(element, name);
    };
    take("assetdir", folders.meshes);
    take("assetdir", folders.textures);
    take("meshdir", folders.meshes);
    take("texturedir", folders.textures);
    if (has_attribute(element, "strippath"))
      folders.strips = attribute(element, "strippath") == "true";
  });
  return folders;
}

unsigned big_endian(std::string_view bytes, std::size_t at) {
  unsigned value = 0;
  for (std::size_t k = 0; k < 4; ++k)
    value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

/// Of a PNG file; nothing for others, which are not packed.
std::optional<PictureSize> picture_size(const fs::path& file) {
  const std::string head = read_regular_file(file, 32);
  if (head.size() < 24 || head.compare(1, 3, "PNG") != 0) return std::nullopt;
  return PictureSize{1.0 * big_endian(head, 16), 1.0 * big_endian(head, 20)};
}

}  // namespace

std::vector<AssetReference> asset_references(const XmlFile& xml) {
  const AssetFolders folders = asset_folders(xml);
  std::vector<AssetReference> out;
  for_each_element(xml.root(), [&](const XmlElement& element) {
    const bool is_texture = is_tag(element, "texture");
    const bool is_asset = is_texture || is_tag(element, "mesh") || is_tag(element, "hfield") ||
                          is_tag(element, "skin");
    const std::string& folder = is_texture ? folders.textures : folders.meshes;
    for (const tinyxml2::XMLAttribute* a = element.FirstAttribute(); a; a = a->Next()) {
      if (std::string_view(a->Name()).substr(0, 4) != "file" || a->Value()[0] == '\0') continue;
      std::string path = a->Value();
      if (folders.strips) path.erase(0, path.find_last_of("/\\") + 1);
      if (!folder.empty() && !fs::path(path).is_absolute() && !is_windows_root(path))
        path.insert(0, folder + "/");
      path = slashed(std::move(path));
      const bool in_folder = !folder.empty() || folders.strips;
      out.push_back({&element, a->Name(), is_asset, std::move(path), in_folder});
    }
  });
  return out;
}

std::string named_from_main_folder(const XmlFile& xml, const fs::path& folder,
                                   const FileReach& reach,
                                   const std::function<fs::path(std::size_t)>& beside) {
  TextEdits edits(xml);
  for (const AssetReference& reference : asset_references(xml)) {
    const fs::path own = beside(xml.tag(*reference.element).begin);
    const fs::path words = slashed(std::string(attribute(*reference.element, reference.attribute)));
    if (own.empty() || words.is_absolute() ||
        !find_file(folder, reference.path, kMostBytes, reach).missing)
      continue;
    const FoundFile found = find_file(folder, (own / words).string(), kMostBytes, reach);
    if (found.missing) continue;
    const fs::path name = reference.in_folder ? fs::absolute(found.source) : found.path;
    edits.set(*reference.element, reference.attribute, name.generic_string());
  }
  return edits.apply();
}

std::vector<FoundAsset> find_assets(const XmlFile& xml, const fs::path& folder,
                                    const FileReach& reach) {
  const std::vector<AssetReference> references = asset_references(xml);
  std::vector<FoundAsset> out;
  std::uintmax_t together = 0;
  PictureMemory pictures;
  Refusals reasons;
  const auto add = [&](const AssetReference& reference) {
    const XmlElement& element = *reference.element;
    const std::string& path = reference.path;
    const FoundFile found = find_file(folder, path, kMostBytes, reach);
    if (!found.fault.empty())
      return reasons.add(xml.error(element, fmt::format("the file '{}' {}", path, found.fault)));
    together += found.bytes;
    if (together > kMostBytesTogether)
      throw xml.error(element, fmt::format("the file '{}': the files of the robot are together "
                                           "larger than {} MB; make them smaller",
                                           path, kMostBytesTogether >> 20));
    if (auto picture = picture_size(found.source)) {
      if (std::max(picture->width, picture->height) > kMostPixels)
        throw xml.error(element,
                        fmt::format("the file '{}': a picture of more than {} pixels a side; make "
                                    "it smaller",
                                    path, kMostPixels));
      picture->is_face = reference.attribute != std::string_view("file");
      pictures.add(xml, element, *picture);
    }
    out.push_back(
        {&element, {found.path, found.source, found.bytes, false}, path_below(path) == found.path});
  };
  const auto told = [&](const auto& work) {
    try {
      work();
    } catch (const InputError& error) {
      reasons.add(error);
    }
  };
  auto next = references.begin();
  for_each_element(xml.root(), [&](const XmlElement& element) {
    told([&] { pictures.add(xml, element); });
    for (; next != references.end() && next->element == &element; ++next) {
      if (next->may)
        told([&] { add(*next); });
      else
        reasons.add(xml.error(
            element, fmt::format("refers to the file '{}'; only <include>, meshes, textures and "
                                 "height fields may: {}",
                                 attribute(element, next->attribute), written_out_cure(xml.file))));
    }
  });
  reasons.throw_if_any();
  return out;
}

}  // namespace legwright
