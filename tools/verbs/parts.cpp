// SPDX-License-Identifier: Apache-2.0
// `legwright parts` is the Python module legwright.parts: the solids are manifold3d's.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <vector>

#include "tools/files/clean_text.hpp"
#include "tools/render/gl_context.hpp"
#include "tools/render/portrait.hpp"
#include "tools/verbs/python_module.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

/// An option that is handed on as it is; legwright.parts reads and checks it.
struct HandedOn {
  const char* name;
  const char* meaning;
};

constexpr std::array kHandedOn{
    HandedOn{"--fit", "play between a part and the modules it holds, mm; default: 0.15"},
    HandedOn{"--wall", "least thickness, and least material around a hole, mm; default: 1.2"},
    HandedOn{"--gap", "least distance between what moves past each other, mm; default: 0.5"},
    HandedOn{"--strength", "that the printed material bears across its layers, MPa; default: 25"},
    HandedOn{"--safety", "least safety factor under the gait's forces; default: 2"},
    HandedOn{"--press", "by how much a foot's socket is narrower than its peg, mm; default: 0.1"},
    HandedOn{"--bed",
             "of the printer, mm; default: that of [print] in its assembly, else 220x220x250"},
    HandedOn{"--margin", "left free at each side of the bed, mm; default: that of [print], else 4"},
};

struct PartsOptions {
  std::string robot, folder = "parts";
  std::array<std::string, kHandedOn.size()> values;  // empty: not given
  bool step = false, quiet = false, json = false;
};

/// Pictures of the scenes that the module wrote: exploded.xml, those of the assembly sheet. Parts
/// are there without them, too.
void draw_exploded(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder)) return;  // it ended before it wrote any
  std::vector<std::filesystem::path> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::filesystem::path& file = entry.path();
    if (file.extension() == ".xml" && file.filename().string().starts_with("exploded"))
      scenes.push_back(file);
  }
  std::ranges::sort(scenes);
  pin_rasteriser();
  for (std::filesystem::path file : scenes) {
    const std::filesystem::path scene = file;
    try {
      draw_portrait(scene, file.replace_extension(".png"));
    } catch (const std::exception& error) {  // a picture changes no exit code
      fmt::print(stderr, "legwright: no {}: {}\n", file.filename().string(),
                 terminal_text(error.what()));
      return;
    }
  }
}

int parts(const PartsOptions& options) {
  std::vector<std::string> words{"--output", options.folder};
  for (std::size_t k = 0; k < kHandedOn.size(); ++k)
    if (!options.values[k].empty())
      words.insert(words.end(), {kHandedOn[k].name, options.values[k]});
  if (options.step) words.emplace_back("--step");
  if (options.quiet) words.emplace_back("--quiet");
  if (options.json) words.emplace_back("--json");
  words.insert(words.end(), {"--", options.robot});
  const int code = run_python_module(parts_part(), words);
  if (code == kOk || code == kInfeasible) draw_exploded(options.folder);
  return code;
}

}  // namespace

void add_parts(CLI::App& program, Action& action) {
  const auto [verb, options] =
      add_verb(program, action, "parts",
               "The printable parts of a robot that `build` made: STL, 3MF, tables, checks", parts);
  verb->add_option("ROBOT", options->robot, "run folder, or MJCF of a robot of modules")
      ->required();
  verb->add_option("-o,--output", options->folder, "folder of the parts")->capture_default_str();
  for (std::size_t k = 0; k < kHandedOn.size(); ++k)
    verb->add_option(kHandedOn[k].name, options->values[k], kHandedOn[k].meaning);
  verb->add_flag("--step", options->step, "each part as STEP, too, for CAD");
  verb->add_flag("--quiet", options->quiet, "say nothing but errors");
  verb->add_flag("--json", options->json, "print checks.json instead of a table");
  verb->footer(
      "Needs Python with the package: pip install \".[parts]\" in a clone; LEGWRIGHT_PYTHON names "
      "the interpreter,\n"
      "default python3. docs/parts.md tells what is cut, checked and left out.\n"
      "Exit code: 0 every check passes, 1 one fails, 2 bad input, 3 files or Python.");
}

}  // namespace legwright
