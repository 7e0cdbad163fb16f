// SPDX-License-Identifier: Apache-2.0
#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>

#include "tools/files/json_file.hpp"
#include "tools/run/install.hpp"
#include "tools/simulate/plugin_files.hpp"
#include "tools/verbs/python_module.hpp"
#include "tools/verbs/verbs.hpp"
#include "tools/verbs/viewer_programs.hpp"

namespace legwright {
namespace {

struct DoctorOptions {
  bool json = false;
};

/// One line of the diagnosis.
struct Item {
  std::string name;
  bool found;
  bool required;
  std::string detail;
  std::string fix;  // where it is not found
};

Item check_plugin() {
  const std::string version = versions()["mujoco"];
  Item item{"plugin", false, true, "",
            "build the target legwright_plugin, or name the file in LEGWRIGHT_PLUGIN"};
  const auto plugin = find_plugin(version);
  if (!plugin) {
    item.detail = "none for MuJoCo " + version;
    for (const auto& candidate : plugin_candidates(version)) {
      const auto served = served_mujoco(candidate);
      item.detail += (served ? ", that for " + *served + " at " : ", not at ") + candidate.string();
    }
    return item;
  }
  // By hand first: where dlopen fails MuJoCo would tell less.
  if (!::dlopen(plugin->c_str(), RTLD_NOW | RTLD_LOCAL)) {
    const char* reason = ::dlerror();
    item.detail = plugin->string() + ": " + (reason ? reason : "cannot be loaded");
    return item;
  }
  item.found = true;
  item.detail = std::filesystem::absolute(*plugin).string() + ", loadable, for MuJoCo " + version;
  for (const std::string& other : other_served_mujocos()) item.detail += ", another for " + other;
  return item;
}

Item check_opengl() {
  Item item{"OpenGL", false, false, "",
            "apt-get install libosmesa6; without it there are no pictures"};
  // By the names that GlContext opens, in its order: another version is of no use.
  for (const char* library : {"libOSMesa.so.8", "libEGL.so.1"}) {
    if (::dlopen(library, RTLD_NOW | RTLD_LOCAL) == nullptr) continue;
    item.found = true;
    item.detail = std::string(library) + ", draws without a display";
    return item;
  }
  item.detail = "neither libOSMesa.so.8 nor libEGL.so.1 found";
  return item;
}

Item check_viewer() {
  Item item{"viewer", true, false, "", viewer_cure()};
  for (const char* program : {kViewerProgram, kSimulateProgram}) {
    const auto file = find_beside(program);
    item.found = item.found && file;
    item.detail +=
        (item.detail.empty() ? "" : ", ") + (file ? file->string() : std::string("no ") + program);
  }
  return item;
}

Item check_python() {
  Item item{"python", false, false, "",
            viewer_python_cure() + " and name its python in LEGWRIGHT_PYTHON"};
  const auto python = find_viewer_python();
  item.found = python && find_plugin(python->mujoco_version);
  item.detail = python ? fmt::format("{} has mujoco {}{}", python->command, python->mujoco_version,
                                     item.found ? "" : ", for which there is no plugin")
                       : "no Python with mujoco.viewer, which `play --viewer python` wants";
  return item;
}

/// What a verb needs that Python does.
Item check_python_part(const PythonPart& part) {
  const PythonFound found = look_for_python(part);
  const bool there = !found.python.empty();
  return {
      part.extra, there, false,
      there ? fmt::format("{} has legwright with {}", found.python, fmt::join(part.libraries, ", "))
            : found.lacks,
      python_cure(part)};
}

Item check_display() {
  const char* display =
      std::getenv("DISPLAY") ? std::getenv("DISPLAY") : std::getenv("WAYLAND_DISPLAY");
  return {"display", display != nullptr, false, display ? display : "none; only `play` needs one",
          "run under a desktop, or xvfb-run"};
}

std::vector<Item> diagnose() {
  std::vector<Item> items;
  const Json known = versions();  // must outlive the loop over its items
  for (const auto& [name, version] : known.items()) {
    const std::string text = version;
    items.push_back(
        {name, text != "not loaded", true, text, "the program was built without it; build again"});
  }
  items.push_back({"program", true, true, program_file().string(), ""});
  items.push_back(check_plugin());
  items.push_back(check_opengl());
  items.push_back(check_viewer());
  items.push_back(check_python());
  for (const PythonPart& part : {study_part(), drake_part(), parts_part()})
    items.push_back(check_python_part(part));
  items.push_back(check_display());
  return items;
}

int doctor(const DoctorOptions& options) {
  const std::vector<Item> items = diagnose();
  bool healthy = true;
  for (const Item& item : items) healthy = healthy && (item.found || !item.required);
  if (options.json) {
    Json list = Json::array();
    for (const Item& item : items)
      list.push_back({{"name", item.name},
                      {"found", item.found},
                      {"required", item.required},
                      {"detail", item.detail},
                      {"fix", item.found ? "" : item.fix}});
    fmt::print("{}", to_text({{"schema", "legwright/doctor"},
                              {"version", 1},
                              {"healthy", healthy},
                              {"items", list}}));
  } else {
    for (const Item& item : items)
      fmt::print("{:8} {:10} {}{}\n",
                 item.found      ? "ok"
                 : item.required ? "MISSING"
                                 : "absent",
                 item.name, item.detail,
                 item.found ? "" : fmt::format("\n{:20}fix: {}", "", item.fix));
  }
  return healthy ? kOk : kIoError;
}

}  // namespace

void add_doctor(CLI::App& program, Action& action) {
  const auto [verb, options] =
      add_verb(program, action, "doctor",
               "Say what is installed, found and missing, and how to mend it", doctor);
  verb->add_flag("--json", options->json, "print one JSON document");
}

}  // namespace legwright
