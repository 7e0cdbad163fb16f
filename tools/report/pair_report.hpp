// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tools/report/html.hpp"
#include "tools/report/run_data.hpp"

namespace legwright {

/// Two single runs to be read beside each other.
struct RunPair {
  RunData a, b;
};

/// Throws IoError where there is no run, InputError where one is a joint run: its tasks' folders
/// are runs that can be compared.
RunPair read_pair(const std::filesystem::path& a, const std::filesystem::path& b);

/// Both runs on one self-contained page: verdicts, strips, numbers, bodies, limits, margins, terms.
std::string pair_page(const RunPair& pair);

/// Where the page goes unless it is told: A/compare_NAME.html, with the name of B's folder.
std::filesystem::path pair_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// Reads both runs and writes their page. @param output empty: pair_file @return where it is
/// Throws what read_pair does, std::system_error where the file cannot be written.
std::filesystem::path write_pair_report(const std::filesystem::path& a,
                                        const std::filesystem::path& b,
                                        const std::filesystem::path& output);

/// Both lists joined by name, in the order in which they come, with nothing where one has no such.
template <class Row>
std::vector<std::pair<const Row*, const Row*>> joined_by_name(const std::vector<Row>& a,
                                                              const std::vector<Row>& b) {
  std::vector<std::pair<const Row*, const Row*>> out;
  out.reserve(a.size() + b.size());
  for (const Row& row : a) out.emplace_back(&row, find_named(b, row.name));
  for (const Row& row : b)
    if (find_named(a, row.name) == nullptr) out.emplace_back(nullptr, &row);
  return out;
}

// One part of the page each, in its order.
void add_pair_verdicts(Html& page, const RunPair& pair);
void add_pair_pictures(Html& page, const RunPair& pair);
void add_pair_numbers(Html& page, const RunPair& pair);
void add_pair_bodies(Html& page, const RunPair& pair);
void add_pair_limits(Html& page, const RunPair& pair);
void add_pair_margins(Html& page, const RunPair& pair);
void add_pair_terms(Html& page, const RunPair& pair);
void add_pair_origin(Html& page, const RunPair& pair);

}  // namespace legwright
