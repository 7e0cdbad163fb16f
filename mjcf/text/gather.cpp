// SPDX-License-Identifier: Apache-2.0
// RobotFiles::gathered(): what lies elsewhere comes below the folder of the main file.
#include <fmt/format.h>

#include <cstddef>
#include <functional>

#include "mjcf/text/assets.hpp"
#include "mjcf/text/gathered_names.hpp"
#include "mjcf/text/robot_files.hpp"
#include "mjcf/text/safe_path.hpp"
#include "mjcf/text/splice.hpp"
#include "mjcf/text/text_edits.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// An asset without a name is called after its file.
void keep_name(const AssetReference& reference, const fs::path& name, TextEdits& edits) {
  const bool names_it = reference.attribute == std::string_view("file") &&
                        attribute(*reference.element, "name").empty();
  const fs::path before = fs::path(reference.path).stem();
  if (names_it && before != name.stem()) edits.set(*reference.element, "name", before.string());
}

}  // namespace

/// Assets are named by their whole paths, without the folders that <compiler> gives.
std::string RobotFiles::text_of_gathered(const PathMap& names) const {
  const auto xml = load_xml(text_, file_);
  const std::vector<AssetReference> references = asset_references(*xml);
  if (references.empty()) return text_;
  TextEdits edits(*xml);
  for_each_element(xml->root(), [&](const XmlElement& element) {
    if (!is_tag(element, "compiler")) return;
    for (const char* name : {"assetdir", "meshdir", "texturedir", "strippath"})
      edits.remove(element, name);
  });
  for (const AssetReference& reference : references) {
    const fs::path& name = names.at(named_path(folder(), reference.path));
    edits.set(*reference.element, reference.attribute, name.generic_string());
    keep_name(reference, name, edits);
  }
  return edits.apply();
}

/// The k-th <include>, each file's in the place where it is included, is that of the k-th part.
void RobotFiles::rename_includes(const PathMap& names) {
  std::size_t next = 0;
  const std::function<void(std::size_t)> rename = [&](std::size_t part) {
    const auto xml = load_xml(parts_[part].text, file_);
    TextEdits edits(*xml);
    std::map<std::size_t, std::ptrdiff_t> longer;  // by the end of an <include>
    for_each_element(xml->root(), [&](const XmlElement& element) {
      if (!is_include(element)) return;
      const std::string name = names.at(parts_[++next].path).generic_string();
      TextEdits alone(*xml);
      alone.set(element, "file", name);
      longer[xml->tag(element).close_end] = static_cast<std::ptrdiff_t>(alone.apply().size()) -
                                            static_cast<std::ptrdiff_t>(xml->text.size());
      edits.set(element, "file", name);
      rename(next);
    });
    parts_[part].text = edits.apply();
    for (TextSegment& segment : segments_) {
      if (segment.part != part) continue;
      std::ptrdiff_t moved = 0;
      for (const auto& [end, bytes] : longer)
        if (end <= segment.source) moved += bytes;
      segment.source =
          static_cast<std::size_t>(static_cast<std::ptrdiff_t>(segment.source) + moved);
    }
  };
  rename(0);
}

RobotFiles RobotFiles::gathered() const {
  if (gathered_) return *this;
  const PathMap names = gathered_names(mentions_, parts_.size() - 1);
  RobotFiles out = with_attributes(text_of_gathered(names));
  out.rename_includes(names);
  for (std::size_t k = 1; k < out.parts_.size(); ++k)
    out.parts_[k].path = names.at(out.parts_[k].path);
  for (AssetFile& asset : out.assets_) asset.path = names.at(asset.path);
  for (FileMention& mention : out.mentions_) mention.path = names.at(mention.path);
  out.sort_assets();
  out.gathered_ = true;
  return out;
}

}  // namespace legwright
