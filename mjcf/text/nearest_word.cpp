// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/nearest_word.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace legwright {
namespace {

/// @param wild whether `*` and `?` in `a` stand for others
int edit_distance(std::string_view a, std::string_view b, bool wild = false) {
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const bool any = wild && a[i] == '*', one = wild && a[i] == '?';
    int diagonal = row[0];
    if (!any) ++row[0];
    for (std::size_t j = 0; j < b.size(); ++j) {
      const int above = row[j + 1];
      row[j + 1] = any ? std::min(above, row[j])
                       : std::min({above + 1, row[j] + 1, diagonal + (a[i] != b[j] && !one)});
      diagonal = above;
    }
  }
  return row[b.size()];
}

char small_letter(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// The edit distance with two neighbours exchanged as one edit; capitals are small letters.
int slips_between(std::string_view a, std::string_view b) {
  std::vector<int> before, above, row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  const auto same = [&](std::size_t i, std::size_t j) {
    return small_letter(a[i]) == small_letter(b[j]);
  };
  for (std::size_t i = 0; i < a.size(); ++i) {
    before = std::exchange(above, row);
    row[0] = static_cast<int>(i) + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      row[j + 1] = std::min({above[j + 1] + 1, row[j] + 1, above[j] + !same(i, j)});
      if (i > 0 && j > 0 && same(i, j - 1) && same(i - 1, j))
        row[j + 1] = std::min(row[j + 1], before[j - 1] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

std::string slip_of(std::string_view word, const std::vector<std::string>& candidates) {
  constexpr std::size_t kLong = 8;     // [letters], of words in which two slips are likely
  constexpr std::size_t kLonger = 40;  // of words that are none of these
  if (word.size() > kLonger) return "";
  std::string best;
  int least = 0;
  for (const std::string& candidate : candidates) {
    const int slips = slips_between(word, candidate);
    const int most = candidate.size() < kLong ? 1 : 2;
    if (slips <= most && (best.empty() || slips < least)) best = candidate, least = slips;
  }
  return best;
}

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

std::vector<std::string> nearest_to_pattern(std::string_view pattern,
                                            const std::vector<std::string>& candidates) {
  constexpr std::size_t kMost = 3;
  std::vector<std::pair<int, std::string>> found;
  found.reserve(candidates.size());
  for (const std::string& candidate : candidates)
    found.emplace_back(edit_distance(pattern, candidate, true), candidate);
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> out;
  for (const auto& [distance, name] : found)
    if (out.size() < kMost && distance == found.front().first) out.push_back(name);
  return out;
}

}  // namespace legwright
