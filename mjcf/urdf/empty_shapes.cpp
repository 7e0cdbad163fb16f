// SPDX-License-Identifier: Apache-2.0
#include "mjcf/urdf/empty_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mjcf/text/listed.hpp"
#include "mjcf/text/numbers.hpp"
#include "mjcf/urdf/urdf_schema.hpp"

namespace legwright {
namespace {

constexpr const char* kPointRadius = "0.001";  // [m]

/// Whether one of a shape's lengths is zero.
bool is_empty(const XmlElement& shape) {
  for (const char* const name : {"size", "radius", "length"})
    if (const auto numbers = parse_numbers(attribute(shape, name)))
      if (std::find(numbers->begin(), numbers->end(), 0.0) != numbers->end()) return true;
  return false;
}

void add_once(std::vector<std::string>& names, std::string name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
}

}  // namespace

bool EmptyShapes::mend(XmlElement& shape, const XmlElement& link, bool only_seen) {
  XmlElement* const geometry = shape.FirstChildElement("geometry");
  if (geometry == nullptr) return false;
  for (const std::string& tag : urdf_shape_tags()) {
    XmlElement* const found = geometry->FirstChildElement(tag.c_str());
    if (found == nullptr) continue;
    if (!is_empty(*found)) return false;
    const std::string name(attribute(link, "name"));
    if (!only_seen && tag == "sphere") {
      found->SetAttribute("radius", kPointRadius);
      add_once(points_, name);
      return false;
    }
    add_once(left_out_, name);
    return true;
  }
  return false;
}

void EmptyShapes::tell(std::vector<std::string>& notes) const {
  if (!points_.empty())
    notes.push_back(
        fmt::format("points of contact, which are balls without radius, are balls of a "
                    "millimetre: of {}",
                    listed(points_)));
  if (!left_out_.empty())
    notes.push_back(
        fmt::format("left out, as their size is zero: shapes of {}", listed(left_out_)));
}

}  // namespace legwright
