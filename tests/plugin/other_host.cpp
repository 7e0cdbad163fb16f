// SPDX-License-Identifier: Apache-2.0
// A host without MuJoCo of its own: loads the plugin beside the engine it is told to load, if any,
// and prints what a person would see. Usage: other_host PLUGIN [ENGINE VERSION]
#include <dlfcn.h>
#include <mujoco/mujoco.h>

#include <cstdio>
#include <cstdlib>

int main(int count, char** arguments) {
  void* const engine = count > 2 ? dlopen(arguments[2], RTLD_NOW | RTLD_GLOBAL) : nullptr;
  if (count > 2 && engine == nullptr) return std::printf("no engine: %s\n", dlerror()), 3;
  if (dlopen(arguments[1], RTLD_LAZY | RTLD_LOCAL) == nullptr)
    return std::printf("not loaded: %s\n", dlerror()), 1;
  if (engine == nullptr) return std::printf("loaded without an engine\n"), 3;
  const auto function = [engine](const char* name) { return dlsym(engine, name); };
  const auto set_version = reinterpret_cast<void (*)(int)>(function("other_set_version"));
  const auto plugin_count = reinterpret_cast<int (*)()>(function("other_plugin_count"));
  const auto plugin = reinterpret_cast<const mjpPlugin* (*)(int)>(function("other_plugin"));
  const auto warning = reinterpret_cast<const char* (*)()>(function("other_warning"));
  set_version(std::atoi(arguments[3]));
  static mjModel model;
  static mjData data;
  std::uintptr_t kept[1] = {};
  data.plugin_data = kept;
  for (int i = 0; i < plugin_count(); ++i)
    std::printf("%s: init %d: %s\n", plugin(i)->name, plugin(i)->init(&model, &data, 0), warning());
  return 0;
}
