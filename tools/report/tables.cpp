// SPDX-License-Identifier: Apache-2.0
#include "tools/report/tables.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

#include "mjcf/input_error.hpp"
#include "tools/io/atomic_file.hpp"

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

/// What is wrong with one table, and which verb writes it anew.
struct Complaint {
  const std::string& file;
  const std::string& verb;
  [[noreturn]] void operator()(int line, const std::string& what) const {
    throw InputError(file, line, "",
                     what + "; the file is damaged: run `legwright " + verb + "` again");
  }
};

double number(std::string_view token, int line, const Complaint& complain) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (error != std::errc() || end != token.data() + token.size() || !std::isfinite(value)) {
    complain(line, "not a finite number: '" + std::string(token.substr(0, 40)) + "'");
  }
  return value;
}

}  // namespace

CsvTable parse_csv_table(std::string_view text, const std::string& file, const std::string& verb) {
  const Complaint complain{file, verb};
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

Trajectory read_motion_csv(const std::filesystem::path& file) {
  const std::string text = read_file(file);
  const std::string name = file.string(), verb = "optimize";
  const Complaint complain{name, verb};
  const CsvTable table = parse_csv_table(text, name, verb);
  if (table.rows.size() < 2) complain(0, "a single row");
  std::string rows;  // the plugin's format: blanks, and no row for the knot that closes the cycle
  std::size_t left = table.rows.size();
  for (auto line : split(text, '\n')) {
    if (line.empty() || left == 0) continue;
    rows += line;
    rows += '\n';
    --left;
  }
  for (char& c : rows) c = c == ',' || c == '\r' ? ' ' : c;
  const auto& first = table.rows.front();
  const auto& last = table.rows.back();
  CycleSettings cycle;
  cycle.period = last[0] - first[0];
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const std::string& column = table.columns[c];
    if (column == "root_x_m") cycle.travel[0] = last[c] - first[c];
    if (column == "root_y_m") cycle.travel[1] = last[c] - first[c];
    if (column == "root_z_m") cycle.travel[2] = last[c] - first[c];
    if (column == "root_rz_rad") cycle.turn = last[c] - first[c];
  }
  try {
    return parse_trajectory(rows, cycle);
  } catch (const TrajectoryError& error) {
    complain(0, error.what());
  }
}

}  // namespace legwright
