// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace legwright {

/// A file of the page, as it is in the program.
struct PageFile {
  std::string_view bytes;
  const char* type;  // media type
};

/// A file of tools/studio/page/dist by its name there; nothing where there is none. Of a program
/// that was built without it "index.html" says so.
std::optional<PageFile> page_file(const std::string& name);

}  // namespace legwright
