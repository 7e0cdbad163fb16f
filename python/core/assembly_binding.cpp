// SPDX-License-Identifier: Apache-2.0
#include "python/core/assembly_binding.hpp"

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mjcf/assembly/build_robot.hpp"
#include "mjcf/assembly/overlap_words.hpp"
#include "mjcf/text/input_error.hpp"
#include "python/core/calls.hpp"
#include "python/core/python_errors.hpp"
#include "tools/modules/assembly_file.hpp"
#include "tools/modules/doubtful_assembly.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// What comes of an assembly.
struct PythonAssembly {
  std::string xml;                    // empty where it is refused
  std::optional<InputError> refusal;  // why these modules make no robot
  bool tells_lines = false;           // the refusal is of lines of the assembly, not of the robot
  std::vector<std::string> doubts;    // what `legwright build` warns of, and modules that overlap
};

/// Throws InputError for what is wrong with the text.
PythonAssembly build(const std::string& text, const fs::path& file,
                     const std::vector<fs::path>& modules, const fs::path& output) {
  const ModuleLibrary library(modules);
  const Assembly assembly = parse_assembly(text, file, library);
  PythonAssembly out;
  out.doubts = doubts_on_assembly(assembly, text, file, library);
  try {
    const BuiltRobot built = build_robot(assembly, output);
    out.tells_lines = true;
    refuse_overlaps(assembly, built.overlaps, file);
    for (const std::string& overlap : overlap_notes(assembly, built.overlaps))
      out.doubts.push_back(file.string() + ": " + overlap);
    out.xml = built.xml;
  } catch (const InputError& error) {
    out.refusal = error;
  }
  return out;
}

}  // namespace

void bind_assembly(nb::module_& module) {
  nb::class_<PythonAssembly>(module, "BuiltAssembly", "What comes of an assembly.")
      .def_ro("xml", &PythonAssembly::xml, "The robot's MJCF; empty where it is refused.")
      .def_prop_ro(
          "refusal",
          [](const PythonAssembly& built) {
            return built.refusal ? python_error(*built.refusal) : nb::none();
          },
          "Why these modules make no robot, an InputError; or None.")
      .def_ro("tells_lines", &PythonAssembly::tells_lines,
              "Whether the refusal is of lines of the assembly, not of the robot.")
      .def_ro("doubts", &PythonAssembly::doubts, "What can be and is hardly meant, a line each.");
  module.def("build_robot", &build, "text"_a, "file"_a, "modules"_a, "output"_a,
             nb::call_guard<Released>(),
             "Builds the robot of an assembly, of the modules in these folders; messages call the "
             "robot `output`. Raises InputError for what is wrong with the text, IoError for a "
             "folder.");
}

}  // namespace legwright
