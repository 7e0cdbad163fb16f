// SPDX-License-Identifier: Apache-2.0
#include "tools/modules/module_library.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "mjcf/text/input_error.hpp"
#include "mjcf/text/nearest_word.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/io_error.hpp"
#include "tools/run/install.hpp"
#include "tools/task/toml_text.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr const char* kModuleFolder = "share/legwright/modules";  // beside the program's bin

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Whether a file without a kind is evidently an assembly, a task or a study, which may lie beside
/// modules.
bool is_of_a_robot(const toml::table& toml) {
  const auto table = [&](const char* key) { return toml[key].is_table(); };
  return toml["limb"].is_array() || table("trunk") || toml.contains("robot") || table("gait") ||
         (table("base") && table("grid"));
}

int line_of_name(const toml::table& toml) {
  const toml::node* name = toml.get("name");
  return name ? static_cast<int>(name->source().begin.line) : 0;
}

}  // namespace

ModuleLibrary::ModuleLibrary(const std::vector<fs::path>& folders) {
  for (const fs::path& folder : folders) read_folder(folder);
  std::sort(modules_.begin(), modules_.end(), [](const ModuleFile& a, const ModuleFile& b) {
    return std::pair(a.module.kind, lower(a.module.name)) <
           std::pair(b.module.kind, lower(b.module.name));
  });
}

void ModuleLibrary::read_folder(const fs::path& folder) {
  if (!fs::is_directory(folder))
    throw IoError(folder.string() + ": is no folder; name one that holds modules (*.toml)");
  std::set<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".toml") files.insert(entry.path());
  std::map<std::string, fs::path> here;
  for (const fs::path& file : files) {
    const std::string text = read_file(file);
    const toml::table toml = parse_toml(text, file);
    if (!toml.contains("kind") && is_of_a_robot(toml)) continue;
    if (!toml.contains("kind"))
      throw InputError(file.string(), 0, "kind",
                       "is missing, so this is no module; take the file out of the folder, or "
                       "say what it is: kind = \"servo\"");
    ModuleFile read = parse_module(text, file);
    const std::string& name = read.module.name;
    const auto [twin, first] = here.emplace(lower(name), file);
    if (!first)
      throw InputError(file.string(), line_of_name(toml), "name",
                       fmt::format("is \"{}\", which {} has, too; give one of them another name",
                                   name, twin->second.string()));
    std::erase_if(modules_,
                  [&](const ModuleFile& other) { return lower(other.module.name) == lower(name); });
    modules_.push_back(std::move(read));
  }
  if (here.empty())
    throw IoError(folder.string() +
                  ": holds no module (*.toml); `legwright modules --keys` tells "
                  "what one says");
}

const ModuleFile* ModuleLibrary::find_or_null(const std::string& name) const {
  const auto found = std::find_if(modules_.begin(), modules_.end(), [&](const ModuleFile& file) {
    return lower(file.module.name) == lower(name);
  });
  return found == modules_.end() ? nullptr : &*found;
}

const ModuleFile& ModuleLibrary::find(const std::string& name) const {
  if (const ModuleFile* found = find_or_null(name)) return *found;
  const std::string guess = nearest(name, names());
  throw InputError(fmt::format("module '{}' is not in the library; {}there are {}", name,
                               guess.empty() ? "" : fmt::format("did you mean '{}'? ", guess),
                               fmt::join(names(), ", ")));
}

std::vector<std::string> ModuleLibrary::names() const {
  std::vector<std::string> out;
  for (const ModuleFile& file : modules_) out.push_back(file.module.name);
  return out;
}

fs::path installed_modules() {
  fs::path folder = program_file().parent_path().parent_path() / kModuleFolder;
  if (fs::is_directory(folder)) return folder;
  throw IoError(folder.string() +
                ": the modules that come with the program are not there; install "
                "it anew");
}

ModuleLibrary library_with(const std::vector<std::string>& own_folders) {
  std::vector<fs::path> folders{installed_modules()};
  folders.insert(folders.end(), own_folders.begin(), own_folders.end());
  return ModuleLibrary(folders);
}

}  // namespace legwright
