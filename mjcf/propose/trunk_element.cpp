// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/trunk_element.hpp"

#include "mjcf/text/text_edits.hpp"
#include "mjcf/text/unused_name.hpp"

namespace legwright {
namespace {

bool has_hinges(const XmlElement& body) {
  bool found = false;
  for_each_element(body, [&](const XmlElement& part) {
    found = found || is_tag(part, "include") || (is_tag(part, "joint") && !is_free_joint(part));
  });
  return found;
}

}  // namespace

bool is_free_joint(const XmlElement& element) {
  return is_tag(element, "freejoint") ||
         (is_tag(element, "joint") && attribute(element, "type") == "free");
}

const XmlElement* trunk_element(const XmlFile& xml) {
  const XmlElement* trunk = nullptr;
  for_each_element(xml.root(), [&](const XmlElement& element) {
    const XmlElement* const body = is_free_joint(element) ? element.Parent()->ToElement() : nullptr;
    if (trunk == nullptr && body != nullptr && is_tag(*body, "body") && has_hinges(*body))
      trunk = body;
  });
  return trunk;
}

RobotFiles with_named_trunk(const RobotFiles& files, std::string* name) {
  name->clear();
  const auto xml = load_xml(files.main_text(), files.file());
  const XmlElement* const trunk = trunk_element(*xml);
  if (trunk == nullptr || !attribute(*trunk, "name").empty()) return files;
  const auto all = load_xml(files.text(), files.file());
  *name = unused_name("trunk", [&](const std::string& each) {
    return find_named(all->root(), "body", each) != nullptr;
  });
  TextEdits edits(*xml);
  edits.set(*trunk, "name", *name);
  return files.with_main(edits.apply());
}

}  // namespace legwright
