// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace legwright {

/// A table of numbers with named columns, as `validate` and `optimize` write them.
struct CsvTable {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
};

/// Throws InputError for a table that is not as its writer leaves it.
struct DamagedTable {
  const std::string& file;  // its path
  const std::string& verb;  // that writes it anew
  [[noreturn]] void operator()(int line, const std::string& what) const;
};

/// Reads such a table, strictly: every row as long as the header, every cell a finite number.
/// @param file its path, for messages. @param verb that writes such files, for messages.
/// Throws InputError that names the line.
CsvTable parse_csv_table(std::string_view text, const std::string& file, const std::string& verb);

}  // namespace legwright
