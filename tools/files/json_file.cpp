// SPDX-License-Identifier: Apache-2.0
#include "tools/files/json_file.hpp"

#include "tools/files/io_error.hpp"

namespace legwright {

std::string to_text(const Json& document) {
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_json(const std::filesystem::path& path, const Json& document, Durability durability) {
  write_file(path, to_text(document), durability);
}

Json read_json(const std::filesystem::path& path, const std::string& remedy) {
  const std::string text = read_file(path);
  Json document = Json::parse(text, nullptr, false);
  if (document.is_discarded())
    throw IoError(path.string() + ": not a JSON document; the file is damaged, " + remedy);
  return document;
}

}  // namespace legwright
