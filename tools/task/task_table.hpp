// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/task/key_table.hpp"
#include "tools/task/toml_reader.hpp"

namespace legwright {

/// Reads one table of a task file, or of another file, by its table of keys (key_table.hpp), from
/// which types and ranges are: what is not listed there cannot be read. Each function throws
/// std::logic_error for a key that is not listed with that type. Else as TableReader.
class TaskTable : private TableReader {
 public:
  /// @param path of the table, "" for the root and for a [[task]]
  /// @param keys of the file; they must outlive this
  TaskTable(const toml::table* table, const std::string& path, Problems& problems,
            std::map<std::string, int>& lines, const std::vector<TaskKey>& keys = task_keys())
      : TableReader(table, path, problems, lines), path_(path), keys_(keys) {}

  bool has(std::string_view key);
  const toml::node* node(std::string_view key);
  int line_of(std::string_view key);
  void require(bool present, std::string_view key, const std::string& example);

  std::optional<double> number(std::string_view key);
  std::optional<int> integer(std::string_view key);
  std::optional<std::string> text(std::string_view key);
  std::optional<std::vector<double>> numbers(std::string_view key);
  std::optional<std::vector<std::vector<double>>> pairs(std::string_view key);
  std::optional<std::vector<std::string>> names(std::string_view key);
  const toml::table* table(std::string_view key);
  std::vector<const toml::table*> tables(std::string_view key);

  // Tables whose keys are names of the user's.
  std::map<std::string, double> numbers_by_name(std::string_view key);
  std::map<std::string, std::vector<double>> numbers_of_names(std::string_view key);
  std::map<std::string, std::vector<std::vector<double>>> pairs_by_name(std::string_view key);
  std::map<std::string, CycleTarget> targets_by_name(std::string_view key);

  using TableReader::finish;
  using TableReader::full;

 private:
  /// Throws where neither this key nor one below it is listed.
  void check_listed(std::string_view key) const;
  const KeyForm& form(std::string_view key, KeyKind kind) const;
  /// Of what stands below `key` under names of the user's.
  const KeyForm& form_of_names(std::string_view key, KeyKind kind) const;

  std::string path_;
  const std::vector<TaskKey>& keys_;
};

}  // namespace legwright
