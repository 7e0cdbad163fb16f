// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "tools/files/atomic_file.hpp"

namespace legwright {

/// Keys keep the order in which they were set, so equal results are equal bytes.
using Json = nlohmann::ordered_json;

/// The document as text: two-space indent, final newline; bytes that are no UTF-8 become U+FFFD.
/// Numbers are shortest round trip; one that is not finite becomes null.
std::string to_text(const Json& document);
/// The same in one line without its end.
std::string to_line(const Json& document);

void write_json(const std::filesystem::path& path, const Json& document,
                Durability durability = Durability::power);
/// What mends a damaged file of a run.
inline constexpr const char* kWriteAgain = "run the verb that writes it again";
/// Throws IoError that names the file and the remedy where it is no JSON, std::system_error where
/// it cannot be read.
Json read_json(const std::filesystem::path& path, const std::string& remedy = kWriteAgain);

/// The number, or null where there is none.
inline Json or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

}  // namespace legwright
