// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml2.h>

#include <string>
#include <utility>
#include <vector>

namespace legwright {

using XmlAttributes = std::vector<std::pair<const char*, std::string>>;

/// Opens an element with its attributes; the caller closes it.
void open_element(tinyxml2::XMLPrinter& out, const char* name, const XmlAttributes& attributes);
/// The same without content.
void add_element(tinyxml2::XMLPrinter& out, const char* name, const XmlAttributes& attributes);

}  // namespace legwright
