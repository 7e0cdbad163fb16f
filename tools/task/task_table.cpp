// SPDX-License-Identifier: Apache-2.0
#include "tools/task/task_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace legwright {
namespace {

constexpr std::string_view kAnyName = "NAME";  // of the user's

[[noreturn]] void refuse_unlisted(const std::string& path) {
  throw std::logic_error(
      fmt::format("the reader reads {}, which its table of keys does not list so", path));
}

const KeyForm& form_in(const std::vector<TaskKey>& keys, const std::string& table,
                       std::string_view key, KeyKind kind) {
  if (const TaskKey* row = find_key(keys, table, key))
    for (const KeyForm& form : row->forms)
      if (form.kind == kind) return form;
  refuse_unlisted(fmt::format("{}.{}", table, key));
}

}  // namespace

void TaskTable::check_listed(std::string_view key) const {
  if (find_key(keys_, path_, key) == nullptr && !has_keys(keys_, full(key)))
    refuse_unlisted(full(key));
}

const KeyForm& TaskTable::form(std::string_view key, KeyKind kind) const {
  return form_in(keys_, path_, key, kind);
}

const KeyForm& TaskTable::form_of_names(std::string_view key, KeyKind kind) const {
  return form_in(keys_, full(key), kAnyName, kind);
}

bool TaskTable::has(std::string_view key) { return node(key) != nullptr; }

const toml::node* TaskTable::node(std::string_view key) {
  check_listed(key);
  return TableReader::node(key);
}

int TaskTable::line_of(std::string_view key) {
  check_listed(key);
  return TableReader::line_of(key);
}

void TaskTable::require(bool present, std::string_view key, const std::string& example) {
  check_listed(key);
  TableReader::require(present, key, example);
}

std::optional<double> TaskTable::number(std::string_view key) {
  return TableReader::number(key, form(key, KeyKind::number).range);
}

std::optional<int> TaskTable::integer(std::string_view key) {
  const Range& range = form(key, KeyKind::integer).range;
  return TableReader::integer(key, static_cast<int>(range.low), static_cast<int>(range.high));
}

std::optional<std::string> TaskTable::text(std::string_view key) {
  (void)form(key, KeyKind::text);
  return TableReader::text(key);
}

std::optional<std::vector<double>> TaskTable::numbers(std::string_view key) {
  const KeyForm& listed = form(key, KeyKind::numbers);
  return TableReader::numbers(key, listed.range, listed.count);
}

std::optional<std::vector<std::vector<double>>> TaskTable::pairs(std::string_view key) {
  return TableReader::pairs(key, form(key, KeyKind::pairs).range);
}

std::optional<std::vector<std::string>> TaskTable::names(std::string_view key) {
  (void)form(key, KeyKind::names);
  return TableReader::names(key);
}

const toml::table* TaskTable::table(std::string_view key) {
  check_listed(key);
  return TableReader::table(key);
}

std::vector<const toml::table*> TaskTable::tables(std::string_view key) {
  (void)form(key, KeyKind::tables);
  return TableReader::tables(key);
}

std::map<std::string, double> TaskTable::numbers_by_name(std::string_view key) {
  return TableReader::numbers_by_name(key, form_of_names(key, KeyKind::number).range);
}

std::map<std::string, std::vector<double>> TaskTable::numbers_of_names(std::string_view key) {
  const KeyForm& listed = form_of_names(key, KeyKind::numbers);
  return TableReader::numbers_of_names(key, listed.range, listed.count);
}

std::map<std::string, std::vector<std::vector<double>>> TaskTable::pairs_by_name(
    std::string_view key) {
  return TableReader::pairs_by_name(key, form_of_names(key, KeyKind::pairs).range);
}

std::map<std::string, CycleTarget> TaskTable::targets_by_name(std::string_view key) {
  const Range& range = form_of_names(key, KeyKind::target).range;
  const TaskKey* row = find_key(keys_, full(key), kAnyName);
  (void)form_in(keys_, std::string(row->path), "over_cycle", KeyKind::target);
  return TableReader::targets_by_name(
      key, range, form_in(keys_, std::string(row->path), "weight", KeyKind::number).range);
}

}  // namespace legwright
