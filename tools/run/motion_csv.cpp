// SPDX-License-Identifier: Apache-2.0
#include "tools/run/motion_csv.hpp"

#include <sstream>

#include "mjcf/text/input_error.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/csv_table.hpp"

namespace legwright {

Trajectory read_motion_csv(const std::filesystem::path& file) {
  const std::string text = read_file(file);
  const std::string name = file.string(), verb = "optimize";
  const DamagedTable complain{name, verb};
  const CsvTable table = parse_csv_table(text, name, verb);
  if (table.rows.size() < 2) complain(0, "a single row");
  std::string rows;  // the plugin's format: blanks, and no row for the knot that closes the cycle
  std::size_t left = table.rows.size();
  std::istringstream lines(text);
  for (std::string line; left > 0 && std::getline(lines, line);) {
    if (line.empty()) continue;
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
