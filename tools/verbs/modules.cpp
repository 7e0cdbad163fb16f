// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>

#include "tools/files/atomic_file.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/files/io_error.hpp"
#include "tools/modules/module_library.hpp"
#include "tools/render/gl_context.hpp"
#include "tools/render/portrait.hpp"
#include "tools/verbs/key_words.hpp"
#include "tools/verbs/module_text.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

struct ModulesOptions {
  std::string name, draw;
  std::vector<std::string> library;
  bool json = false, keys = false;
};

/// A picture of each module, DRAWINGS/NAME.png. @return the files
std::vector<std::string> draw_modules(const std::vector<ModuleFile>& modules,
                                      const fs::path& folder) {
  fs::create_directories(folder);
  std::vector<std::string> drawn;
  pin_rasteriser();
  try {
    for (const ModuleFile& file : modules) {
      const fs::path scene = folder / ("." + file.module.name + ".xml"),
                     png = folder / (file.module.name + ".png");
      write_file(scene, module_scene(file.module), Durability::process);
      draw_portrait(scene, png);
      fs::remove(scene);
      drawn.push_back(png.string());
    }
  } catch (const GlError& error) {
    throw IoError(error.what());  // exit 3: pictures cannot be made on this machine
  }
  return drawn;
}

int print_keys(bool json) {
  if (json)
    fmt::print("{}", to_text({{"schema", "legwright/module_keys"},
                              {"version", 1},
                              {"keys", key_list_json(module_keys())}}));
  else
    fmt::print("Keys of a module file (TOML, SI units).\n{}", key_list_text(module_keys(), false));
  return kOk;
}

int modules(const ModulesOptions& options) {
  if (options.keys) return print_keys(options.json);
  const ModuleLibrary library = library_with(options.library);
  std::vector<ModuleFile> chosen = library.modules();
  if (!options.name.empty()) chosen = {library.find(options.name)};
  const std::vector<std::string> drawn =
      options.draw.empty() ? std::vector<std::string>{} : draw_modules(chosen, options.draw);
  if (options.json) {
    Json list = Json::array();
    for (const ModuleFile& file : chosen) list.push_back(to_json(file));
    fmt::print("{}", to_text({{"schema", "legwright/modules"},
                              {"version", 1},
                              {"modules", list},
                              {"drawn", drawn}}));
    return kOk;
  }
  if (!options.name.empty())
    fmt::print("{}", terminal_text(module_page(chosen.front())));
  else
    fmt::print("{}\n`legwright modules NAME` tells where each figure is from.\n",
               terminal_text(module_table(chosen)));
  for (const ModuleFile& file : chosen)
    for (const std::string& doubt : file.doubts) fmt::print("warning  {}\n", terminal_text(doubt));
  for (const std::string& png : drawn) fmt::print("drawn    {}\n", terminal_text(png));
  return kOk;
}

}  // namespace

void add_modules(CLI::App& program, Action& action) {
  const auto [verb, options] =
      add_verb(program, action, "modules",
               "List the servos, feet and parts of which robots are assembled", modules);
  verb->add_option("NAME", options->name, "one module, with the source of each figure");
  verb->add_option("--library", options->library,
                   "a folder of modules of your own (*.toml), which take the place of those of the "
                   "same name; may be given several times")
      ->allow_extra_args(false);
  verb->add_option("--draw", options->draw, "draw each into this folder, NAME.png");
  verb->add_flag("--keys", options->keys, "tell every key of a module file");
  verb->add_flag("--json", options->json, "print one JSON document");
  verb->footer(
      "Columns of servos: mass, size, voltage, stall (or peak) torque, continuous torque, no-load "
      "speed, gear ratio,\nreflected inertia. '-' where no source tells. Red is the output axis, "
      "orange and blue are attachments on horn and body.");
}

}  // namespace legwright
