// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tools/report/html.hpp"
#include "tools/report/run_data.hpp"

namespace legwright {

/// Everything of a page up to its first section: head with content policy and style, title, a line
/// below it.
void open_page(Html& page, const std::string& title, const std::string& line);
/// Footer, and `island`: the main numbers once more, for programs that read the page.
void close_page(Html& page, const Json& island);
/// What an island says of any run.
Json island_of(const RunData& data);

}  // namespace legwright
