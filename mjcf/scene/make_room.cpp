// SPDX-License-Identifier: Apache-2.0
#include "mjcf/scene/make_room.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>
#include <vector>

#include "mjcf/text/references.hpp"
#include "mjcf/text/unused_name.hpp"

namespace legwright {
namespace {

using tinyxml2::XMLElement;

XMLElement& writable(const XmlElement& element) { return const_cast<XMLElement&>(element); }

/// Elements of one kind, whose names must differ.
struct Kind {
  const char* name;
  bool (*has)(const XmlElement& element);
  bool (*is_looked_up)(std::string_view name);
};

bool begins(std::string_view name, std::string_view with) {
  return name.substr(0, with.size()) == with;
}

bool stands_in(const XmlElement& element, std::string_view section) {
  const XmlElement* const parent = element.Parent() ? element.Parent()->ToElement() : nullptr;
  return parent != nullptr && is_tag(*parent, section);
}

const Kind kKinds[] = {
    {"key", [](const XmlElement& element) { return is_tag(element, "key"); },
     [](std::string_view name) { return name == "gait"; }},
    {"sensor", [](const XmlElement& element) { return stands_in(element, "sensor"); },
     [](std::string_view name) {
       return name == "tracking" || begins(name, "gait:") || begins(name, "contact:");
     }},
    {"site", [](const XmlElement& element) { return is_tag(element, "site"); },
     [](std::string_view name) { return begins(name, "foot:"); }},
    {"camera", [](const XmlElement& element) { return is_tag(element, "camera"); },
     [](std::string_view name) { return name == "side" || name == "track"; }}};

/// Whether the text has the beginning of such a name in quotes, or & by which one may be written:
/// designs are drawn many times a second, and few robots have one.
bool may_have_to(const std::string& text) {
  constexpr std::string_view kBeginnings[] = {"gait", "track", "contact:", "foot:", "side"};
  if (text.find('&') != std::string::npos) return true;
  return std::any_of(std::begin(kBeginnings), std::end(kBeginnings), [&](std::string_view begin) {
    for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1))
      if (at > 0 && (text[at - 1] == '"' || text[at - 1] == '\'')) return true;
    return false;
  });
}

/// @return whether there was one to rename
bool rename(XMLElement& root, const Kind& kind) {
  std::set<std::string> taken;
  std::vector<XMLElement*> renamed;
  for_each_element(root, [&](const XmlElement& element) {
    const char* const name = element.Attribute("name");
    if (name == nullptr || !kind.has(element)) return;
    taken.insert(name);
    if (kind.is_looked_up(name)) renamed.push_back(&writable(element));
  });
  for (XMLElement* const element : renamed) {
    const std::string old = element->Attribute("name");
    const std::string own = unused_name(
        "robot_" + old, [&](const std::string& name) { return !taken.insert(name).second; });
    element->SetAttribute("name", own.c_str());
    for_each_element(root, [&](const XmlElement& other) {
      std::vector<std::string> attributes;
      for_each_reference(other, kind.name, [&](const char* attribute, const char* name) {
        if (name == old) attributes.emplace_back(attribute);
      });
      for (const std::string& attribute : attributes)
        writable(other).SetAttribute(attribute.c_str(), own.c_str());
    });
  }
  return !renamed.empty();
}

}  // namespace

std::string make_room(const std::string& robot_xml, const std::filesystem::path& file) {
  if (!may_have_to(robot_xml)) return robot_xml;
  const auto xml = load_xml(robot_xml, file);
  bool any = false;
  for (const Kind& kind : kKinds) any = rename(*xml->dom.RootElement(), kind) || any;
  if (!any) return robot_xml;
  tinyxml2::XMLPrinter printer;
  xml->dom.Print(&printer);
  return printer.CStr();
}

}  // namespace legwright
