// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/xml.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace legwright {
namespace {

/// Offset of the first byte that is not UTF-8, or npos. Overlong forms and surrogates count as
/// wrong.
std::size_t find_invalid_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = [&](std::size_t k) {
      return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u;
    };
    const unsigned first = byte(i);
    if (first < 0x80) {
      // A NUL would end the text for C readers; other control characters are no XML.
      if (first < 0x20 && first != '\t' && first != '\n' && first != '\r') return i;
      ++i;
      continue;
    }
    const int length = first >= 0xF0 && first < 0xF5 ? 4
                       : first >= 0xE0               ? 3
                       : first >= 0xC2               ? 2
                                                     : 0;
    if (length == 0 || first >= 0xF5) return i;
    for (int k = 1; k < length; ++k)
      if ((byte(i + k) & 0xC0) != 0x80) return i;
    const unsigned second = byte(i + 1);
    const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
    const bool beyond = (first == 0xED && second > 0x9F) || (first == 0xF4 && second > 0x8F);
    if (overlong || beyond) return i;
    i += length;
  }
  return std::string_view::npos;
}

void check_scan(const XmlFile& xml, const XmlLimits& limits) {
  const std::string name = xml.file.string();
  if (xml.scan.doctype_line > 0)
    throw InputError(name, xml.scan.doctype_line, "<!DOCTYPE>",
                     "document type declarations are not read; remove it");
  if (xml.scan.tags.size() > limits.elements)
    throw InputError(
        name, xml.scan.tags[limits.elements].line, "",
        fmt::format(
            "more than {} elements; a robot needs far fewer, remove what does not belong to it",
            limits.elements));
  for (const TagSpan& tag : xml.scan.tags) {
    if (tag.depth > limits.depth)
      throw InputError(
          name, tag.line, std::string(tag.name),
          fmt::format("elements are nested deeper than {}; make the tree flatter", limits.depth));
    for (const AttributeSpan& span : tag.attributes)
      if (span.value_end - span.value_begin > limits.attribute_bytes)
        throw InputError(name, tag.line, std::string(tag.name),
                         fmt::format("attribute '{}' is longer than {} bytes; shorten it",
                                     span.name.substr(0, 40), limits.attribute_bytes));
  }
}

std::string parse_failure(const tinyxml2::XMLDocument& dom) {
  switch (dom.ErrorID()) {
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return "the file holds no XML; expected <mujoco> … </mujoco>";
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "an element is not closed, or closed by another name; is the file complete?";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "an attribute is malformed; write name=\"value\" with both quotes, each name once; is "
             "the file complete?";
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      return "a comment is not closed by -->";
    case tinyxml2::XML_ERROR_PARSING_CDATA:
      return "a CDATA section is not closed by ]]>";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return "elements are nested too deeply; make the tree flatter";
    default:
      return "not well-formed XML; is the file complete?";
  }
}

/// Pairs DOM elements with scanned tags; both walk the document in the same order.
void pair_tags(XmlFile& xml) {
  const auto disagree = [&](int line) {
    return InputError(
        xml.file.string(), line, "XML",
        "markup that readers understand differently; write plain elements with quoted attributes");
  };
  std::size_t next = 0;
  for_each_element(xml.root(), [&](const XmlElement& element) {
    if (next >= xml.scan.tags.size()) throw disagree(element.GetLineNum());
    const TagSpan& tag = xml.scan.tags[next];
    bool same = tag.name == element.Name();
    const tinyxml2::XMLAttribute* attribute = element.FirstAttribute();
    for (const AttributeSpan& span : tag.attributes) {
      same = same && attribute && span.name == attribute->Name();
      if (attribute) attribute = attribute->Next();
    }
    if (!same || attribute) throw disagree(tag.line);
    xml.tag_index.emplace(&element, next++);
  });
  if (next != xml.scan.tags.size()) throw disagree(xml.scan.tags[next].line);
}

}  // namespace

InputError XmlFile::error(const XmlElement& element, const std::string& message) const {
  std::string where = element.Name();
  if (has_attribute(element, "name"))
    where += fmt::format(" '{}'", attribute(element, "name"));
  else if (is_tag(element, "position") || is_tag(element, "motor") || is_tag(element, "inertial"))
    if (const XmlElement* parent = element.Parent() ? element.Parent()->ToElement() : nullptr)
      if (has_attribute(*parent, "name"))
        where += fmt::format(" in {} '{}'", parent->Name(), attribute(*parent, "name"));
  return InputError(file.string(), element.GetLineNum(), where, message);
}

std::unique_ptr<XmlFile> load_xml(std::string text, const std::filesystem::path& file,
                                  const XmlLimits& limits) {
  auto xml = std::make_unique<XmlFile>();
  xml->file = file;
  if (text.size() > limits.bytes)
    throw InputError(file.string(), 0, "",
                     fmt::format("larger than {} bytes; this is no robot", limits.bytes));
  if (const std::size_t bad = find_invalid_utf8(text); bad != std::string_view::npos) {
    const int line = 1 + static_cast<int>(std::count(
                             text.begin(), text.begin() + static_cast<std::ptrdiff_t>(bad), '\n'));
    throw InputError(file.string(), line, "",
                     "a byte that is no UTF-8 text; save the file as UTF-8");
  }
  xml->text = std::move(text);
  xml->scan = scan_tags(xml->text);
  check_scan(*xml, limits);
  if (xml->dom.Parse(xml->text.data(), xml->text.size()) != tinyxml2::XML_SUCCESS)
    throw InputError(file.string(), std::max(xml->dom.ErrorLineNum(), 0), "XML",
                     parse_failure(xml->dom));
  if (!xml->dom.RootElement())
    throw InputError(file.string(), 0, "XML", "no root element; expected <mujoco>");
  pair_tags(*xml);
  return xml;
}

std::string_view attribute(const XmlElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value ? value : "";
}

bool has_attribute(const XmlElement& element, const char* name) {
  return element.Attribute(name) != nullptr;
}

bool is_tag(const XmlElement& element, std::string_view name) { return name == element.Name(); }

void for_each_element(const XmlElement& element,
                      const std::function<void(const XmlElement&)>& visit) {
  visit(element);
  for (const XmlElement* child = element.FirstChildElement(); child;
       child = child->NextSiblingElement())
    for_each_element(*child, visit);
}

std::vector<const XmlElement*> custom_elements(const XmlFile& xml, const char* tag,
                                               std::string_view prefix) {
  std::vector<const XmlElement*> out;
  for (const XmlElement* section = xml.root().FirstChildElement("custom"); section;
       section = section->NextSiblingElement("custom"))
    for (const XmlElement* each = section->FirstChildElement(tag); each;
         each = each->NextSiblingElement(tag))
      if (attribute(*each, "name").substr(0, prefix.size()) == prefix) out.push_back(each);
  return out;
}

const XmlElement* find_named(const XmlElement& root, std::string_view tag, std::string_view name) {
  for (const XmlElement* child = root.FirstChildElement(); child;
       child = child->NextSiblingElement()) {
    if (is_tag(*child, "default")) continue;
    if (is_tag(*child, tag) && has_attribute(*child, "name") && attribute(*child, "name") == name)
      return child;
    if (const XmlElement* found = find_named(*child, tag, name)) return found;
  }
  return nullptr;
}

namespace {

const XmlElement* parent_element(const XmlElement& element) {
  return element.Parent() ? element.Parent()->ToElement() : nullptr;
}

std::string class_name(const XmlElement& default_element) {
  if (has_attribute(default_element, "class"))
    return std::string(attribute(default_element, "class"));
  return "main";  // only the outermost may do without a name
}

std::string class_of(const XmlElement& element) {
  if (has_attribute(element, "class")) return std::string(attribute(element, "class"));
  for (const XmlElement* above = parent_element(element); above; above = parent_element(*above))
    if (has_attribute(*above, "childclass")) return std::string(attribute(*above, "childclass"));
  return {};
}

}  // namespace

const char* inherited_attribute(const XmlFile& xml, const XmlElement& element, const char* name) {
  if (const char* own = element.Attribute(name)) return own;
  // A class may be told in several places; what comes last holds. Walk outwards through the
  // classes.
  std::string class_wanted = class_of(element);
  for (int guard = 0; guard < 100; ++guard) {
    const char* value = nullptr;
    std::string outer;
    bool found = false;
    for_each_element(xml.root(), [&](const XmlElement& candidate) {
      if (!is_tag(candidate, "default")) return;
      const XmlElement* above = parent_element(candidate);
      const bool outermost = !above || !is_tag(*above, "default");
      if (class_wanted.empty() ? !outermost : class_name(candidate) != class_wanted) return;
      found = true;
      if (!outermost) outer = class_name(*above);
      for (const XmlElement* part = candidate.FirstChildElement(element.Name()); part;
           part = part->NextSiblingElement(element.Name()))
        if (const char* here = part->Attribute(name)) value = here;
    });
    if (value) return value;
    if (!found || outer.empty()) return nullptr;
    class_wanted = outer;
  }
  return nullptr;
}

}  // namespace legwright
