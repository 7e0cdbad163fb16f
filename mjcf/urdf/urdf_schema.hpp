// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace legwright {

/// An attribute of a URDF that is read.
struct UrdfAttribute {
  std::string name;
  int numbers;  // how many it holds; 0: a text
  enum class Need { optional, required } need = Need::optional;
  enum class Range { finite, length, any } range = Range::finite;
};

/// An element of a URDF: what is read of it, and words of others that are near to these.
struct UrdfElement {
  std::string tag;
  std::vector<UrdfAttribute> attributes;
  std::vector<std::string> children;  // each an element of the schema
  std::vector<std::string> required;  // of the children
  std::vector<std::string> others;    // attributes and elements that are no slips

  const UrdfAttribute* attribute(std::string_view name) const;
  bool has_child(std::string_view child) const;
};

/// What stands in <link>, <joint> and <material>, and these; null for what has another's meaning.
const UrdfElement* urdf_element(std::string_view tag);

/// The kinds of shape in a <geometry>, of which the first that is there is read.
const std::vector<std::string>& urdf_shape_tags();

/// An element as an example: <mass value="…"/>, with what it must have.
std::string sample_of(const UrdfElement& element);

}  // namespace legwright
