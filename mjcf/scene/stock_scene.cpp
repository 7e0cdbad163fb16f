// SPDX-License-Identifier: Apache-2.0
#include "mjcf/scene/stock_scene.hpp"

#include <tinyxml2.h>

#include <string_view>

#include "mjcf/scene/gait_plugin.hpp"
#include "mjcf/text/input_error.hpp"

namespace legwright {
namespace {

using tinyxml2::XMLElement;

std::string_view plugin_of(const XMLElement& element) {
  const char* const plugin = element.Attribute("plugin");
  return plugin == nullptr ? "" : plugin;
}

/// Drops the plugin elements that are Legwright's, and a section that has no other element.
void drop_ours(XMLElement& root, const char* tag) {
  for (XMLElement* part = root.FirstChildElement(tag); part != nullptr;) {
    XMLElement* const next = part->NextSiblingElement(tag);
    for (XMLElement* each = part->FirstChildElement("plugin"); each != nullptr;) {
      XMLElement* const after = each->NextSiblingElement("plugin");
      if (plugin_of(*each).starts_with("legwright.")) part->DeleteChild(each);
      each = after;
    }
    if (part->FirstChildElement() == nullptr) root.DeleteChild(part);
    part = next;
  }
}

/// What it plays stands in a default class already: a plugin element cannot carry it.
int replace_servos(XMLElement& actuators) {
  int count = 0;
  for (XMLElement* each = actuators.FirstChildElement("plugin"); each != nullptr;) {
    XMLElement* const next = each->NextSiblingElement("plugin");
    if (plugin_of(*each) == kGaitPlugin) {
      each->SetName("general");
      each->DeleteAttribute("plugin");
      each->DeleteAttribute("instance");
      ++count;
    }
    each = next;
  }
  return count;
}

}  // namespace

std::string stock_scene(const std::string& gait_scene, const std::string& name) {
  tinyxml2::XMLDocument dom;
  if (dom.Parse(gait_scene.c_str(), gait_scene.size()) != tinyxml2::XML_SUCCESS)
    throw InputError(name, dom.ErrorLineNum(), "scene", dom.ErrorStr());
  XMLElement* const root = dom.RootElement();
  int servos = 0;
  for (XMLElement* part = root->FirstChildElement("actuator"); part != nullptr;
       part = part->NextSiblingElement("actuator"))
    servos += replace_servos(*part);
  if (servos == 0)
    throw InputError(name, root->GetLineNum(), "actuator",
                     "no actuator is driven by legwright.gait; expected the scene of a gait");
  drop_ours(*root, "sensor");
  drop_ours(*root, "extension");
  tinyxml2::XMLPrinter printer;
  dom.Print(&printer);
  return printer.CStr();
}

}  // namespace legwright
