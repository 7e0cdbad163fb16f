// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/task_changes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "mjcf/text/input_error.hpp"
#include "tools/task/task_text.hpp"

namespace legwright {
namespace {

/// TOML's basic strings are JSON's.
std::string toml_text_of(const std::string& text) { return to_line(Json(text)); }

/// A JSON value as TOML. Throws InputError for null within a value.
std::string toml_of(const Json& value, const std::string& key) {
  if (value.is_string()) return toml_text_of(value.get<std::string>());
  if (value.is_boolean() || value.is_number_integer()) return value.dump();
  if (value.is_number()) {
    const auto number = value.get<double>();
    if (!std::isfinite(number)) throw InputError(key + ": is no number");
    std::string text = fmt::format("{}", number);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
  }
  std::string out;
  if (value.is_array()) {
    for (const Json& one : value) out += (out.empty() ? "" : ", ") + toml_of(one, key);
    return "[" + out + "]";
  }
  if (value.is_object()) {
    for (const auto& [name, one] : value.items())
      out += (out.empty() ? "" : ", ") + toml_text_of(name) + " = " + toml_of(one, key);
    return out.empty() ? "{}" : "{ " + out + " }";
  }
  throw InputError(key + ": null stands within a value; it takes whole keys out");
}

}  // namespace

std::string with_changes(const std::string& text, int task, const Json& changes) {
  if (!changes.is_object())
    throw InputError(
        "'changes' are no table of keys; expected for instance "
        R"({"travel": {"velocity": [0.1, 0.0]}})");
  const std::vector<std::string> root = path_of_task(text, task);
  std::string out = text;
  const auto set = [&](std::vector<std::string> path, const Json& value) {
    const std::string key = path.back();
    path.insert(path.begin(), root.begin(), root.end());
    out = with_key(out, path, value.is_null() ? std::nullopt : std::optional(toml_of(value, key)));
  };
  for (const auto& [table, values] : changes.items()) {
    if (!values.is_object()) {
      set({table}, values);
      continue;
    }
    for (const auto& [key, value] : values.items()) set({table, key}, value);
  }
  return out;
}

}  // namespace legwright
