// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <tinyxml2.h>

#include <cmath>
#include <cstring>
#include <set>
#include <string>
#include <vector>

#include "plugin/number_text.hpp"
#include "tools/simulate/scene.hpp"

namespace legwright {
namespace {

using tinyxml2::XMLElement;

// Multiplies each number of the attribute by the factor at its place; the last factor serves all
// that follow.
void scale_numbers(XMLElement& element, const char* attribute, const std::vector<double>& factors,
                   const std::string& name) {
  const char* text = element.Attribute(attribute);
  std::string out;
  std::size_t place = 0;
  for (const auto token : split_blanks(text == nullptr ? "" : text)) {
    const auto number = read_number(token);
    if (!number) {
      throw MujocoError(fmt::format("{}:{}: <{} {}>: {} is no number", name, element.GetLineNum(),
                                    element.Name(), attribute, quoted(token)));
    }
    out += fmt::format("{}{}", out.empty() ? "" : " ",
                       *number * factors[std::min(place++, factors.size() - 1)]);
  }
  element.SetAttribute(attribute, out.c_str());
}

bool attribute_is(const XMLElement& element, const char* attribute, const char* value) {
  const char* text = element.Attribute(attribute);
  return text != nullptr && std::strcmp(text, value) == 0;
}

template <typename Visit>
void for_each_element(XMLElement* element, const Visit& visit) {
  for (; element != nullptr; element = element->NextSiblingElement()) {
    visit(*element);
    for_each_element(element->FirstChildElement(), visit);
  }
}

}  // namespace

std::string scale_gains(const std::string& scene_xml, double scale, const std::string& name) {
  return scale_gains(scene_xml, scale, std::sqrt(scale), name);
}

std::string scale_gains(const std::string& scene_xml, double stiffness, double damping,
                        const std::string& name) {
  if (stiffness == 1.0 && damping == 1.0) return scene_xml;
  tinyxml2::XMLDocument document;
  if (document.Parse(scene_xml.data(), scene_xml.size()) != tinyxml2::XML_SUCCESS) {
    throw MujocoError(name + ": cannot read it: " + document.ErrorStr());
  }
  std::set<std::string> classes;
  int scaled_keys = 0, scaled_classes = 0;
  for_each_element(document.RootElement(), [&](XMLElement& element) {
    if (std::strcmp(element.Name(), "plugin") != 0 || !attribute_is(element, "plugin", kGaitPlugin))
      return;
    if (const char* used = element.Attribute("class")) classes.insert(used);
    for_each_element(element.FirstChildElement(), [&](XMLElement& config) {
      const bool kp = attribute_is(config, "key", "kp"), kd = attribute_is(config, "key", "kd");
      if (!kp && !kd) return;
      scale_numbers(config, "value", {kp ? stiffness : damping}, name);
      ++scaled_keys;
    });
  });
  for_each_element(document.RootElement(), [&](XMLElement& element) {
    const char* own = element.Attribute("class");
    if (std::strcmp(element.Name(), "default") != 0 || own == nullptr || !classes.contains(own))
      return;
    if (auto* general = element.FirstChildElement("general");
        general && general->Attribute("biasprm")) {
      scale_numbers(*general, "biasprm", {1.0, stiffness, damping}, name);
      ++scaled_classes;
    }
  });
  if (scaled_keys == 0) {
    throw MujocoError(name + ": the scene has no instance of the plugin " + kGaitPlugin +
                      " with gains kp and kd: nothing would move the robot; play the scene.xml " +
                      "that `legwright optimize` writes");
  }
  if (scaled_keys < 2 || scaled_classes == 0) {
    throw MujocoError(name +
                      ": the gains cannot be scaled: expected both keys kp and kd, and "
                      "default classes with biasprm for the actuators (plugin/README.md)");
  }
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return printer.CStr();
}

}  // namespace legwright
