// SPDX-License-Identifier: Apache-2.0
#include "tools/run/robot_label.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// Whether a name would be any robot's.
bool is_anyones(std::string name) {
  constexpr std::array<std::string_view, 8> kAnyones{"",     "robot",        "model",  "scene",
                                                     "main", "mujoco model", "inputs", "mjcf"};
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(kAnyones.begin(), kAnyones.end(), name) != kAnyones.end();
}

/// A folder that the studio keeps, named by the time: 20260301-140500-puppy-0.
bool is_kept_folder(const std::string& name) {
  return name.size() > 16 && name[8] == '-' && name[15] == '-' &&
         name.substr(0, 8).find_first_not_of("0123456789") == std::string::npos;
}

/// The name of a file, else of the nearest two folders above it; empty where they say nothing.
std::string name_by_path(const fs::path& file) {
  if (std::string stem = file.stem().string(); !is_anyones(stem)) return stem;
  fs::path above = file.parent_path();
  for (int k = 0; k < 2; ++k, above = above.parent_path()) {
    std::string folder = above.filename().string();
    if (is_kept_folder(folder)) break;
    if (!is_anyones(folder)) return folder;
  }
  return {};
}

}  // namespace

std::string robot_label(const std::string& model, const fs::path& origin, const fs::path& robot) {
  if (!is_anyones(model)) return model;
  std::string name;
  if (origin.extension() == ".xml")
    name = name_by_path(origin);
  else if (origin.extension() == ".toml")
    name = name_by_path(robot);
  else
    name = origin.filename().string();
  if (is_anyones(name)) name = origin.parent_path().filename().string();
  return is_anyones(name) || is_kept_folder(name) ? "robot" : name;
}

}  // namespace legwright
