// SPDX-License-Identifier: Apache-2.0
#include "mjcf/urdf/urdf_schema.hpp"

#include <algorithm>

namespace legwright {
namespace {

constexpr auto kRequired = UrdfAttribute::Need::required;
constexpr auto kOptional = UrdfAttribute::Need::optional;
constexpr auto kLength = UrdfAttribute::Range::length;
constexpr auto kAnyRange = UrdfAttribute::Range::any;

UrdfAttribute needed_number(const char* name) { return {name, 1, kRequired}; }
UrdfAttribute needed_text(const char* name) { return {name, 0, kRequired}; }
UrdfAttribute needed_length(const char* name) { return {name, 1, kRequired, kLength}; }
/// Exporters write limits of infinity.
UrdfAttribute limit_of_joint(const char* name) { return {name, 1, kOptional, kAnyRange}; }

const std::vector<UrdfElement>& urdf_schema() {
  static const std::vector<UrdfElement> kSchema{
      {"link",
       {needed_text("name")},
       {"inertial", "visual", "collision"},
       {},
       {"material", "contact", "sensor", "gazebo", "verbose", "type"}},
      {"joint",
       {needed_text("name"), needed_text("type")},
       {"origin", "parent", "child", "axis", "limit", "dynamics", "mimic"},
       {"parent", "child"},
       {"calibration", "safety_controller", "children"}},
      {"inertial", {}, {"origin", "mass", "inertia"}, {"mass", "inertia"}, {"name", "inertial"}},
      {"visual",
       {{"name", 0}},
       {"origin", "geometry", "material"},
       {"geometry"},
       {"verbose", "meta", "texture"}},
      {"collision",
       {{"name", 0}},
       {"origin", "geometry", "material"},
       {"geometry"},
       {"verbose", "contact_coefficients", "group"}},
      {"geometry", {}, urdf_shape_tags(), {}, {"name", "plane", "ellipsoid", "cone", "convex"}},
      {"material", {{"name", 0}}, {"color"}, {}, {"texture", "colour"}},
      {"color", {{"rgba", 4, kRequired}}, {}, {}, {"rgb"}},
      {"origin", {{"xyz", 3}, {"rpy", 3}}, {}, {}, {"quat", "quat_xyzw"}},
      {"axis", {{"xyz", 3, kRequired}}, {}, {}, {"rpy"}},
      {"limit",
       {limit_of_joint("lower"), limit_of_joint("upper"), limit_of_joint("effort"),
        limit_of_joint("velocity")},
       {},
       {},
       {"acceleration", "deceleration", "jerk"}},
      {"dynamics", {{"damping", 1}, {"friction", 1}}, {}, {}, {"stiction", "stiffness"}},
      {"mimic", {needed_text("joint"), {"multiplier", 1}, {"offset", 1}}, {}, {}, {}},
      {"mass", {needed_number("value")}, {}, {}, {}},
      {"inertia",
       {needed_number("ixx"), needed_number("ixy"), needed_number("ixz"), needed_number("iyy"),
        needed_number("iyz"), needed_number("izz")},
       {},
       {},
       {"iyx", "izx", "izy"}},
      {"parent", {needed_text("link")}, {}, {}, {}},
      {"child", {needed_text("link")}, {}, {}, {}},
      {"mesh", {needed_text("filename"), {"scale", 3}}, {}, {}, {}},
      {"box", {{"size", 3, kRequired, kLength}}, {}, {}, {}},
      {"sphere", {needed_length("radius")}, {}, {}, {}},
      {"cylinder", {needed_length("radius"), needed_length("length")}, {}, {}, {}},
      {"capsule", {needed_length("radius"), needed_length("length")}, {}, {}, {}},
  };
  return kSchema;
}

}  // namespace

const UrdfAttribute* UrdfElement::attribute(std::string_view name) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const UrdfAttribute& each) { return each.name == name; });
  return found == attributes.end() ? nullptr : &*found;
}

bool UrdfElement::has_child(std::string_view child) const {
  return std::find(children.begin(), children.end(), child) != children.end();
}

const UrdfElement* urdf_element(std::string_view tag) {
  for (const UrdfElement& element : urdf_schema())
    if (element.tag == tag) return &element;
  return nullptr;
}

const std::vector<std::string>& urdf_shape_tags() {
  static const std::vector<std::string> kShapes{"box", "cylinder", "sphere", "capsule", "mesh"};
  return kShapes;
}

std::string sample_of(const UrdfElement& element) {
  std::string text = "<" + element.tag;
  for (const UrdfAttribute& each : element.attributes)
    if (each.need == kRequired) text += " " + each.name + "=\"…\"";
  return text + (element.children.empty() ? "/>" : ">");
}

}  // namespace legwright
