// SPDX-License-Identifier: Apache-2.0
#include "tools/modules/module_library.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
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
  if (files.empty())
    throw IoError(folder.string() +
                  ": holds no module (*.toml); `legwright modules --keys` tells "
                  "what one says");
  std::set<std::string> here;
  for (const fs::path& file : files) {
    const std::string text = read_file(file);
    if (!parse_toml(text, file).contains("kind"))
      throw InputError(file.string(), 0, "kind",
                       "is missing, so this is no module; take the file out of the folder, or "
                       "say what it is: kind = \"servo\"");
    ModuleFile read = parse_module(text, file);
    const std::string& name = read.module.name;
    if (!here.insert(lower(name)).second)
      throw InputError(file.string(), 0, "name",
                       fmt::format("is \"{}\", as of another module of this folder; give it a "
                                   "name of its own",
                                   name));
    std::erase_if(modules_,
                  [&](const ModuleFile& other) { return lower(other.module.name) == lower(name); });
    modules_.push_back(std::move(read));
  }
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
