// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tools/files/json_file.hpp"
#include "tools/report/html.hpp"
#include "tools/report/run_data.hpp"

namespace legwright {

/// Everything of a page up to its first section: head with content policy and style, title, a line
/// below it.
void open_page(Html& page, const std::string& title, const std::string& line);
/// Closes what open_page() opened, with a footer and the main numbers once more, for programs that
/// read the page.
/// @param id of the script element that holds them @param json a document
void close_page(Html& page, const std::string& footer, const std::string& id,
                const std::string& json);
/// The same for the report of a run.
void close_page(Html& page, const Json& island);
/// What an island says of any run.
Json island_of(const RunData& data);

}  // namespace legwright
