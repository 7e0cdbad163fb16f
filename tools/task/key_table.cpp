// SPDX-License-Identifier: Apache-2.0
#include "tools/task/key_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace legwright {
namespace {

bool is_placeholder(std::string_view word) {
  return std::all_of(word.begin(), word.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
}

std::string_view last_word(std::string_view path) { return path.substr(path.rfind('.') + 1); }

}  // namespace

std::string_view TaskKey::table() const {
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? std::string_view() : path.substr(0, dot);
}

const TaskKey* find_key(const std::vector<TaskKey>& keys, std::string_view table,
                        std::string_view key) {
  for (const TaskKey& row : keys)
    if (row.table() == table && (last_word(row.path) == key || is_placeholder(last_word(row.path))))
      return &row;
  return nullptr;
}

const TaskKey* find_task_key(std::string_view table, std::string_view key) {
  return find_key(task_keys(), table, key);
}

bool has_keys(const std::vector<TaskKey>& keys, std::string_view table) {
  const std::string below = std::string(table) + ".";
  return std::any_of(keys.begin(), keys.end(),
                     [&](const TaskKey& row) { return row.path.starts_with(below); });
}

std::string form_text(const KeyForm& form) {
  switch (form.kind) {
    case KeyKind::text:
      return "text";
    case KeyKind::number:
      return "number";
    case KeyKind::integer:
      return "whole number";
    case KeyKind::numbers:
      return form.count == 0 ? "list of numbers" : fmt::format("list of {} numbers", form.count);
    case KeyKind::pairs:
      return "list of pairs of numbers";
    case KeyKind::target:
      return "list of numbers, or of pairs of phase and number";
    case KeyKind::names:
      return "list of texts";
    case KeyKind::name_pairs:
      return "list of pairs of texts";
    case KeyKind::tables:
      return "tables";
  }
  return "";
}

std::string bounds_text(const KeyForm& form) {
  const Range& range = form.range;
  if (!std::isfinite(range.low) && !std::isfinite(range.high)) return "";
  const std::string name =
      form.kind == KeyKind::number || form.kind == KeyKind::integer ? "value" : "each";
  return range_text({range.low, range.high, range.low_open, range.high_open, ""}, name);
}

}  // namespace legwright
