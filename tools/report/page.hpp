// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "tools/files/json_file.hpp"
#include "tools/report/html.hpp"

namespace legwright {

/// A page's style sheet: system fonts, light and dark, print.
std::string_view report_style();

/// What a page has around its sections.
struct PageFrame {
  std::string title, line;  // at the top
  std::string footer;
  std::string id = "legwright-report";  // of the script element that holds the island
  Json island = {};         // the main numbers once more, for programs that read the page
  std::string scenes = {};  // that the viewer shows; empty: there is none
};

/// A page, self-contained: head with content policy and style, the frame and what `sections` adds.
std::string framed_page(const PageFrame& frame, const std::function<void(Html&)>& sections);

}  // namespace legwright
