// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>

#include "tools/files/json_file.hpp"

namespace legwright::test {

inline bool has_type(const Json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number();
  return type == "null" && value.is_null();
}

/// Why a value is not what a JSON Schema says, with the path to it; empty where it is. Of the
/// standard it knows what docs/schema/ uses, and refuses any other keyword.
inline std::string schema_fault(const Json& schema, const Json& value, const std::string& at = "") {
  for (const auto& [key, rule] : schema.items()) {
    const auto fault = [&, &name = key] {
      return at + ": " + name + " " + value.dump().substr(0, 80);
    };
    const bool list = value.is_array();
    if (key == "type") {
      const Json types = rule.is_array() ? rule : Json::array({rule});
      if (std::none_of(types.begin(), types.end(),
                       [&](const Json& t) { return has_type(value, t); }))
        return fault();
    } else if (key == "const") {
      if (value != rule) return fault();
    } else if (key == "enum") {
      if (std::find(rule.begin(), rule.end(), value) == rule.end()) return fault();
    } else if (key == "minimum") {
      if (value.is_number() && value.get<double>() < rule.get<double>()) return fault();
    } else if (key == "minItems" || key == "maxItems") {
      const auto size = rule.get<std::size_t>();
      if (list && (key == "minItems" ? value.size() < size : value.size() > size)) return fault();
    } else if (key == "items") {
      for (std::size_t k = 0; list && k < value.size(); ++k)
        if (const auto found = schema_fault(rule, value[k], at + "[" + std::to_string(k) + "]");
            !found.empty())
          return found;
    } else if (key == "required") {
      for (const Json& name : rule)
        if (value.is_object() && !value.contains(name.get<std::string>()))
          return at + ": without " + name.dump();
    } else if (key == "properties" || key == "additionalProperties") {
      if (!value.is_object()) continue;
      for (const auto& [name, member] : value.items()) {
        const bool own = schema.contains("properties") && schema["properties"].contains(name);
        if (own != (key == "properties")) continue;
        if (rule.is_boolean()) return at + ": " + name + " is not known";
        if (const auto found = schema_fault(own ? rule[name] : rule, member, at + "." + name);
            !found.empty())
          return found;
      }
    } else if (key != "$schema" && key != "title" && key != "description") {
      return "the schema has an unknown keyword " + key;
    }
  }
  return "";
}

}  // namespace legwright::test
