// SPDX-License-Identifier: Apache-2.0
// Rows of the tables of keys of modules and assemblies.
#pragma once

#include <limits>
#include <string_view>
#include <vector>

#include "tools/task/key_table.hpp"

namespace legwright {

inline constexpr Range kAnyValue{-std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::infinity(), false, false, ""};
inline constexpr Range kDirectionRange{-1000.0, 1000.0, false, false, ""};
inline constexpr Range kAngleRangeOfJoint{-100.0, 100.0, false, false, "rad"};

inline TaskKey key_row(std::string_view path, KeyForm form, std::string_view fallback,
                       std::string_view example, std::string_view meaning) {
  return {path, {form}, KeyScope::file, fallback, example, meaning};
}

inline TaskKey text_key(std::string_view path, std::string_view fallback, std::string_view example,
                        std::string_view meaning) {
  return key_row(path, {KeyKind::text, kAnyValue}, fallback, example, meaning);
}

inline TaskKey number_key(std::string_view path, const Range& range, std::string_view fallback,
                          std::string_view example, std::string_view meaning) {
  return key_row(path, {KeyKind::number, range}, fallback, example, meaning);
}

inline TaskKey integer_key(std::string_view path, const Range& range, std::string_view fallback,
                           std::string_view example, std::string_view meaning) {
  return key_row(path, {KeyKind::integer, range}, fallback, example, meaning);
}

inline TaskKey numbers_key(std::string_view path, const Range& range, std::size_t count,
                           std::string_view fallback, std::string_view example,
                           std::string_view meaning) {
  return key_row(path, {KeyKind::numbers, range, count}, fallback, example, meaning);
}

inline TaskKey tables_key(std::string_view path, std::string_view fallback,
                          std::string_view example, std::string_view meaning) {
  return key_row(path, {KeyKind::tables, kAnyValue}, fallback, example, meaning);
}

inline TaskKey names_key(std::string_view path, std::string_view fallback, std::string_view example,
                         std::string_view meaning) {
  return key_row(path, {KeyKind::names, kAnyValue}, fallback, example, meaning);
}

}  // namespace legwright
