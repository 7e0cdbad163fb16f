// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <string_view>

#include "mjcf/read/robot_model.hpp"
#include "mjcf/text/refusals.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// Elements that declare a design parameter are called so, and then like the parameter.
inline constexpr std::string_view kDeclarationPrefix = "legwright/";

/// What the <custom> section declares.
struct Declarations {
  DesignSpace space;
  std::vector<Binding> bindings;
};

/// Reads the pairs <numeric name="legwright/NAME"> and <text name="legwright/NAME"> and resolves
/// what they name in the compiled model. Those that are not understood or do not fit are left out,
/// each with a reason.
Declarations read_declarations(const XmlFile& xml, const mjModel& model, const Structure& structure,
                               Refusals& reasons);

/// What of read_declarations() the text alone tells: form, values and bounds, names that no element
/// has. Told together with other faults of the file, before a model is there. Throws nothing.
void check_declarations(const XmlFile& xml, Refusals& reasons);

/// Elements of a declared parameter; both null if it is not declared.
struct DeclarationElements {
  const XmlElement* numeric = nullptr;
  const XmlElement* text = nullptr;
};
DeclarationElements find_declaration(const XmlFile& xml, const std::string& name);

}  // namespace legwright
