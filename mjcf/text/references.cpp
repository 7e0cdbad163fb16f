// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/references.hpp"

#include <map>
#include <vector>

namespace legwright {
namespace {

/// Attributes that do not begin with the kind that they refer to.
const std::vector<const char*>& others(const std::string& kind) {
  static const std::map<std::string, std::vector<const char*>> table = {
      {"body", {"subtree1", "subtree2"}},
      {"site", {"refsite", "sidesite", "cranksite", "slidersite"}}};
  static const std::vector<const char*> none;
  const auto found = table.find(kind);
  return found == table.end() ? none : found->second;
}

bool has_type(const XmlElement& element, const char* attribute, const std::string& kind) {
  return element.Attribute(attribute, kind.c_str()) != nullptr ||
         (kind == "body" && element.Attribute(attribute, "xbody") != nullptr);
}

}  // namespace

void for_each_reference(const XmlElement& element, const std::string& kind,
                        const std::function<void(const char* attribute, const char* name)>& visit) {
  const auto see = [&](const char* attribute) {
    if (const char* const name = element.Attribute(attribute)) visit(attribute, name);
  };
  for (const char* const suffix : {"", "1", "2", "inparent"}) see((kind + suffix).c_str());
  for (const char* const attribute : others(kind)) see(attribute);
  if (has_type(element, "objtype", kind)) see("objname");
  if (has_type(element, "reftype", kind)) see("refname");
}

}  // namespace legwright
