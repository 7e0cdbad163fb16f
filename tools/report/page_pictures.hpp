// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "tools/report/html.hpp"

namespace legwright {

/// How many bytes of pictures a page may still take, so that all of it stays below 5 MB.
class PictureBudget {
 public:
  /// Whether the file is there and still fits; if so it is counted.
  bool take(const std::filesystem::path& file, std::uintmax_t most = kMost);
  /// Whether something was there that did not fit.
  bool refused() const { return refused_; }

 private:
  static constexpr std::uintmax_t kMost = 3'000'000;  // of the files; a third more on the page
  std::uintmax_t left_ = kMost;
  bool refused_ = false;
};

/// A moving picture in a loop, and a still of it for those who want nothing to move, and for paper.
/// @param still may be missing
void add_moving(Html& page, const std::filesystem::path& webp, const std::filesystem::path& still,
                const std::string& title, const std::string& explanation);

/// A strip of pictures with its explanation.
/// @param share of the page's width, so that strips of different widths have the same scale
void add_strip(Html& page, const std::filesystem::path& file, const std::string& title,
               const std::string& explanation, double share = 1.0);

}  // namespace legwright
