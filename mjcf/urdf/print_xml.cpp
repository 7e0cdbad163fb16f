// SPDX-License-Identifier: Apache-2.0
#include "mjcf/urdf/print_xml.hpp"

namespace legwright {

void open_element(tinyxml2::XMLPrinter& out, const char* name, const XmlAttributes& attributes) {
  out.OpenElement(name);
  for (const auto& [key, value] : attributes) out.PushAttribute(key, value.c_str());
}

void add_element(tinyxml2::XMLPrinter& out, const char* name, const XmlAttributes& attributes) {
  open_element(out, name, attributes);
  out.CloseElement();
}

}  // namespace legwright
