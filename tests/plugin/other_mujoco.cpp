// SPDX-License-Identifier: Apache-2.0
// Stands in for the engine of another version under the name of the right one: the only way in
// which the plugin can meet another engine, because another name keeps the loader from loading it
// at all.
#include <mujoco/mujoco.h>

#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace {
int g_version = mjVERSION_HEADER;
mjpPlugin g_plugins[4];
int g_count = 0;
char g_warning[1024];
}  // namespace

extern "C" {
void other_set_version(int version) { g_version = version; }
int other_plugin_count() { return g_count; }
const mjpPlugin* other_plugin(int i) { return &g_plugins[i]; }
const char* other_warning() { return g_warning; }

int mj_version(void) { return g_version; }
void mjp_defaultPlugin(mjpPlugin* plugin) { std::memset(plugin, 0, sizeof *plugin); }
int mjp_registerPlugin(const mjpPlugin* plugin) {
  g_plugins[g_count] = *plugin;
  return g_count++;
}
const mjpPlugin* mjp_getPlugin(const char*, int* slot) {
  if (slot != nullptr) *slot = 0;
  return &g_plugins[0];
}
const char* mj_id2name(const mjModel*, int, int) { return "gait"; }
const char* mj_getPluginConfig(const mjModel*, int, const char*) { return ""; }
void mju_warning(const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(g_warning, sizeof g_warning, format, arguments);
  va_end(arguments);
}
}
