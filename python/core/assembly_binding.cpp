// SPDX-License-Identifier: Apache-2.0
#include "python/core/assembly_binding.hpp"

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "mjcf/assembly/build_robot.hpp"
#include "mjcf/assembly/overlap_words.hpp"
#include "mjcf/text/input_error.hpp"
#include "python/core/calls.hpp"
#include "tools/modules/assembly_file.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// The MJCF, or why there is no such robot. Throws InputError for what is wrong with the text.
std::pair<std::string, std::string> build(const std::string& text, const fs::path& file,
                                          const std::vector<fs::path>& modules) {
  const Assembly assembly = parse_assembly(text, file, ModuleLibrary(modules));
  try {
    const BuiltRobot built = build_robot(assembly, file);
    refuse_deep_overlaps(assembly, built.overlaps, file);
    return {built.xml, ""};
  } catch (const InputError& error) {
    return {"", error.what()};
  }
}

}  // namespace

void bind_assembly(nb::module_& module) {
  module.def("build_robot", &build, "text"_a, "file"_a, "modules"_a, nb::call_guard<Released>(),
             "Builds the robot of an assembly, of the modules in these folders. Returns its MJCF, "
             "or nothing and why these modules make no robot that stands on legs. Raises "
             "InputError for what is wrong with the text, IoError for a folder.");
}

}  // namespace legwright
