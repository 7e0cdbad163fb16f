// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml2.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "mjcf/text/input_error.hpp"
#include "mjcf/text/text_scan.hpp"

namespace legwright {

using XmlElement = tinyxml2::XMLElement;

/// Limits of what is read at all; far above any robot, far below what hurts.
struct XmlLimits {
  std::size_t bytes = 16u << 20;
  std::size_t attribute_bytes = 1u << 20;
  std::size_t elements = 20000;
  int depth = 90;
};

/// An XML file as text, as DOM, and as byte ranges; the three are known to agree.
struct XmlFile {
  std::filesystem::path file;  // for messages
  std::string text;
  TagScan scan;
  tinyxml2::XMLDocument dom;
  std::unordered_map<const XmlElement*, std::size_t> tag_index;

  const XmlElement& root() const { return *dom.RootElement(); }
  const TagSpan& tag(const XmlElement& element) const { return scan.tags[tag_index.at(&element)]; }
  /// An error that names file, line and element: `file:12: joint 'knee': message`.
  InputError error(const XmlElement& element, const std::string& message) const;
};

/// Reads XML text within the limits: UTF-8 without DOCTYPE, well formed. Throws InputError.
std::unique_ptr<XmlFile> load_xml(std::string text, const std::filesystem::path& file,
                                  const XmlLimits& limits = {});

/// Raw text of an attribute, empty if there is none.
std::string_view attribute(const XmlElement& element, const char* name);
bool has_attribute(const XmlElement& element, const char* name);
bool is_tag(const XmlElement& element, std::string_view name);

/// Visits `element` and everything below it in document order.
void for_each_element(const XmlElement& element,
                      const std::function<void(const XmlElement&)>& visit);
/// First element below `root`, outside of <default>, with this tag and name; nullptr if there is
/// none.
const XmlElement* find_named(const XmlElement& root, std::string_view tag, std::string_view name);

/// Elements of the <custom> sections with this tag whose names begin so, in the order of the file.
std::vector<const XmlElement*> custom_elements(const XmlFile& xml, const char* tag,
                                               std::string_view prefix);

/// The value that holds for an attribute of a body's part (geom, site, joint, camera, light): its
/// own, else that of its default class (`class`, else the nearest `childclass`, else main) or the
/// classes around it. Null if none of them gives it.
const char* inherited_attribute(const XmlFile& xml, const XmlElement& element, const char* name);

}  // namespace legwright
