// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/mujoco_host.hpp"

#include <dlfcn.h>

#include <array>
#include <mutex>
#include <new>
#include <utility>

#include "mjcf/text/compile.hpp"
#include "mjcf/text/engine_limits.hpp"
#include "mjcf/text/mesh_hulls.hpp"

namespace legwright {
namespace {

thread_local MujocoMessages* messages_of_thread = nullptr;
bool others_keep_their_messages = false;    // set before there are threads
mjfLogHandler handler_of_others = nullptr;  // likewise

void handle(const mjLogMessage* message) {
  if (messages_of_thread == nullptr) {
    if (handler_of_others != nullptr) handler_of_others(message);
    return;
  }
  if (message->level == mjLOG_WARNING) messages_of_thread->add(message->subject);
  // Leaving by exception is the only way not to return into mju_error, which would end the process.
  // What MuJoCo was working on is given up by the caller.
  if (message->level != mjLOG_ERROR) return;
  if (tells_no_memory(message->subject)) throw std::bad_alloc();
  throw MujocoError(message->subject);
}

bool plugin_known() {
  int slot = -1;
  return mjp_getPlugin(kGaitPlugin, &slot) != nullptr;
}

// MuJoCo's own words, without a line break at the end, with the warnings that came before (a
// plugin's reason).
std::string reason(const char* error, const MujocoMessages& messages) {
  std::string text = error;
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  for (const auto& warning : messages.warnings()) text += (text.empty() ? "" : "; ") + warning;
  return text;
}

}  // namespace

void take_over_mujoco_messages() {
  static std::once_flag once;
  std::call_once(once, [] {
    if (others_keep_their_messages) {
      handler_of_others = mju_setLogHandler(handle);
      return;
    }
    mjLogConfig config = mju_getLogConfig();
    config.logto_console = 0;
    config.logto_file = 0;
    mju_setLogConfig(config);
    mju_setLogHandler(handle);
  });
}

void leave_others_their_messages() {
  others_keep_their_messages = true;
  take_over_mujoco_messages();
}

MujocoMessages::MujocoMessages() : outer_(messages_of_thread) {
  take_over_mujoco_messages();
  messages_of_thread = this;
}

MujocoMessages::~MujocoMessages() { messages_of_thread = outer_; }

void load_gait_plugin() {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  take_over_mujoco_messages();
  if (plugin_known()) return;
  const std::filesystem::path file = require_plugin(mj_versionString());
  // Opened here instead of by mj_loadPluginLibrary, whose only answer to a faulty file is to end
  // the process. The library registers itself as it is loaded and stays for good.
  if (dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL) == nullptr) {
    const char* why = dlerror();
    throw PluginError("the MuJoCo plugin " + file.string() + " cannot be loaded: " +
                      (why ? why : "unknown reason") + "; it needs exactly MuJoCo " +
                      mj_versionString() + ", build it with this program");
  }
  if (!plugin_known())
    throw PluginError("the library " + file.string() + " is no " + kGaitPlugin + " plugin");
}

ModelPointer compile_model(const std::string& xml, const std::string& name,
                           const std::filesystem::path& folder, MeshDetail detail) {
  MujocoMessages messages;
  std::array<char, 1000> error{};
  const SpecPointer spec(
      mj_parseXMLString(xml.c_str(), nullptr, error.data(), static_cast<int>(error.size())));
  if (!spec && tells_no_memory(error.data())) throw std::bad_alloc();
  if (!spec) throw MujocoError(name + ": MuJoCo cannot read it: " + reason(error.data(), messages));
  if (detail == MeshDetail::hulls) paint_over_pictures(*spec);
  shrink_painted_textures(*spec);
  compile_without_idle_threads(*spec);
  if (!folder.empty()) mjs_setString(spec->modelfiledir, (folder.string() + "/").c_str());
  if (detail == MeshDetail::hulls) {
    spec->compiler.discardvisual = 1;
    put_hulls_for_meshes(*spec);
  }
  ModelPointer model(mj_compile(spec.get(), nullptr));
  if (!model) {
    if (tells_no_memory(mjs_getError(spec.get()))) throw std::bad_alloc();
    throw MujocoError(name +
                      ": MuJoCo cannot compile it: " + reason(mjs_getError(spec.get()), messages));
  }
  return model;
}

void require_gait_plugin(const mjModel& model, const std::string& name) {
  int slot = -1;
  mjp_getPlugin(kGaitPlugin, &slot);
  for (int i = 0; i < model.nplugin; ++i) {
    if (slot >= 0 && model.plugin[i] == slot) return;
  }
  throw MujocoError(
      name + ": the scene has no instance of the plugin " + kGaitPlugin +
      ": nothing would move the robot; play the scene.xml that `legwright optimize` writes");
}

DataPointer make_data(const mjModel& model) {
  const MujocoMessages messages;
  DataPointer data(mj_makeData(&model));
  if (!data) throw std::bad_alloc();
  return data;
}

}  // namespace legwright
