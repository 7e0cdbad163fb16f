// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tools/report/html.hpp"

namespace legwright {

/// Opens a self-contained page: policy, style sheet, heading and a line under it; <html>, <body> and
/// <main> stay open.
void open_page(Html& page, const std::string& title, const std::string& subtitle);

/// Closes what open_page() opened, with a footer and the main numbers as JSON for programs.
/// @param id of the script element that holds them @param json a document
void close_page(Html& page, const std::string& footer, const std::string& id,
                const std::string& json);

}  // namespace legwright
