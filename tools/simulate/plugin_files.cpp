// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/plugin_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "mjcf/scene/gait_plugin.hpp"
#include "tools/files/atomic_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPluginFile = "liblegwright.so";
constexpr const char* kOwnFolder = "mujoco_plugin";         // whose files MuJoCo's simulate loads
constexpr const char* kOtherFolders = "legwright_plugins";  // with one folder for each release

const char* named_plugin() {
  const char* named = std::getenv("LEGWRIGHT_PLUGIN");
  return named != nullptr && *named != '\0' ? named : nullptr;
}

fs::path folder_of_program() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path() : program.parent_path();
}

bool is_there(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error);
}

std::string cure(const std::string& version) {
  if (named_plugin() != nullptr)
    return "unset LEGWRIGHT_PLUGIN, or name a plugin for that version in it";
  const std::string build = version == LEGWRIGHT_MUJOCO_VERSION
                                ? "build the target legwright_plugin"
                                : "configure with -DLEGWRIGHT_PLUGIN_VERSIONS=" + version +
                                      " and build the target legwright_gait_plugins";
  return build + ", or name the file in the environment variable LEGWRIGHT_PLUGIN";
}

}  // namespace

std::optional<std::string> served_mujoco(const fs::path& file) {
  std::string bytes;
  try {
    bytes = read_file(file);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    return std::nullopt;
  }
  const std::string words = fmt::format("{} for MuJoCo ", kGaitPlugin);  // plugin/register.cpp
  const std::size_t found = bytes.find(words);
  if (found == std::string::npos) return std::nullopt;
  const std::size_t begin = found + words.size();
  const std::size_t end = std::min(bytes.find_first_not_of("0123456789.", begin), bytes.size());
  if (end == begin) return std::nullopt;
  return bytes.substr(begin, end - begin);
}

std::vector<fs::path> plugin_candidates(const std::string& version) {
  if (const char* named = named_plugin()) return {named};
  std::vector<fs::path> folders{LEGWRIGHT_BUILD_TREE_PROGRAMS};
  if (const fs::path own = folder_of_program(); !own.empty() && own != folders.front())
    folders.insert(folders.begin(), own);
  std::vector<fs::path> candidates;
  for (const fs::path& folder : folders) {
    candidates.push_back(folder / kOwnFolder / kPluginFile);
    candidates.push_back(folder / kOtherFolders / version / kPluginFile);
  }
  return candidates;
}

std::optional<fs::path> find_plugin(const std::string& version) {
  for (const fs::path& candidate : plugin_candidates(version))
    if (is_there(candidate) && served_mujoco(candidate).value_or(version) == version)
      return candidate;
  return std::nullopt;
}

fs::path require_plugin(const std::string& version) {
  if (const auto file = find_plugin(version)) return *file;
  std::string searched;
  for (const fs::path& candidate : plugin_candidates(version)) {
    const auto served = served_mujoco(candidate);
    searched +=
        "\n  " + candidate.string() + (served ? ", which serves MuJoCo " + *served : ", not there");
  }
  throw PluginError(fmt::format("the plugin {} for MuJoCo {} was not found; {}. Searched:{}",
                                kGaitPlugin, version, cure(version), searched));
}

std::vector<std::string> other_served_mujocos() {
  std::vector<std::string> versions;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_of_program() / kOtherFolders, error))
    if (const auto served = served_mujoco(entry.path() / kPluginFile)) versions.push_back(*served);
  std::sort(versions.begin(), versions.end());
  return versions;
}

}  // namespace legwright
