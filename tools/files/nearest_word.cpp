// SPDX-License-Identifier: Apache-2.0
#include "tools/files/nearest_word.hpp"

#include <algorithm>
#include <numeric>

namespace legwright {
namespace {

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    int diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const int above = row[j + 1];
      row[j + 1] = std::min({above + 1, row[j] + 1, diagonal + (a[i] != b[j])});
      diagonal = above;
    }
  }
  return row[b.size()];
}

}  // namespace

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  std::string best;
  int least = 0;
  for (const std::string& candidate : candidates) {
    const int distance = edit_distance(word, candidate);
    if (best.empty() || distance < least) best = candidate, least = distance;
  }
  const auto longest = static_cast<int>(std::max(word.size(), best.size()));
  return 2 * least <= longest ? best : "";
}

}  // namespace legwright
