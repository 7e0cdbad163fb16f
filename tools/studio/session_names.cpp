// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/session_names.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace legwright {

namespace fs = std::filesystem;

std::string session_name(const std::string& label, const fs::path& origin) {
  if (origin.extension() == ".toml") {
    std::string own = origin.stem().string();
    if (own == label) return label;
    std::replace(own.begin(), own.end(), '_', ' ');
    return label + ", " + own;
  }
  if (origin.extension() == ".xml" || origin.empty()) return label;
  const std::string run = origin.filename().string();
  return run == label ? label : label + ", run " + run;
}

std::string clock_words() {
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%d %H:%M}", fmt::localtime(now));
}

}  // namespace legwright
