// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "plugin/trajectory.hpp"

namespace legwright {

/// A table of numbers with named columns, as `validate` and `optimize` write them.
struct CsvTable {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
};

/// Reads such a table, strictly: every row as long as the header, every cell a finite number.
/// @param file its path, for messages. @param verb that writes such files, for messages.
/// Throws InputError that names the line.
CsvTable parse_csv_table(std::string_view text, const std::string& file, const std::string& verb);

/// The plan of a motion.csv; travel and turn of a cycle are the last row minus the first.
/// Throws InputError for anything else, std::system_error if unreadable.
Trajectory read_motion_csv(const std::filesystem::path& file);

}  // namespace legwright
