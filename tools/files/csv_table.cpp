// SPDX-License-Identifier: Apache-2.0
#include "tools/files/csv_table.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

#include "mjcf/text/input_error.hpp"

namespace legwright {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t start = 0;;) {
    const std::size_t end = text.find(separator, start);
    parts.push_back(text.substr(start, end - start));
    if (end == std::string_view::npos) return parts;
    start = end + 1;
  }
}

double number(std::string_view token, int line, const DamagedTable& complain) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (error != std::errc() || end != token.data() + token.size() || !std::isfinite(value)) {
    complain(line, "not a finite number: '" + std::string(token.substr(0, 40)) + "'");
  }
  return value;
}

}  // namespace

void DamagedTable::operator()(int line, const std::string& what) const {
  throw InputError(file, line, "",
                   what + "; the file is damaged: run `legwright " + verb + "` again");
}

CsvTable parse_csv_table(std::string_view text, const std::string& file, const std::string& verb) {
  const DamagedTable complain{file, verb};
  CsvTable table;
  int line_number = 0;
  for (std::string_view line : split(text, '\n')) {
    ++line_number;
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty()) continue;
    const auto cells = split(line, ',');
    if (table.columns.empty()) {
      for (auto cell : cells) {
        while (cell.starts_with(' ')) cell.remove_prefix(1);
        table.columns.emplace_back(cell);
      }
      continue;
    }
    if (cells.size() != table.columns.size()) {
      complain(line_number, std::to_string(cells.size()) + " cells where the header has " +
                                std::to_string(table.columns.size()));
    }
    auto& row = table.rows.emplace_back();
    for (auto cell : cells) {
      while (cell.starts_with(' ')) cell.remove_prefix(1);
      row.push_back(number(cell, line_number, complain));
    }
  }
  if (table.rows.empty()) complain(0, "no rows");
  return table;
}

}  // namespace legwright
