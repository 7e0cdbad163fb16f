// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/compile.hpp"

#include <array>
#include <atomic>
#include <mutex>
#include <new>
#include <stdexcept>

#include "mjcf/text/engine_limits.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/mesh_hulls.hpp"
#include "mjcf/text/mjcf_words.hpp"
#include "mjcf/text/recent_models.hpp"

namespace legwright {
namespace {

struct EngineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

thread_local bool t_calls_engine = false;                 // this thread is inside call_engine
std::atomic<mjfLogHandler> g_other_threads_log{nullptr};  // the handler before call_engine

/// MuJoCo's own handler prints, writes a log file, and ends the process on errors.
void quiet_log(const mjLogMessage* message) {
  if (t_calls_engine) {
    if (message->level != mjLOG_ERROR) return;
    if (tells_no_memory(message->subject)) throw std::bad_alloc();
    throw EngineError(message->subject);
  } else if (const mjfLogHandler other = g_other_threads_log.load()) {
    other(message);
  }
}

class QuietMujoco {
 public:
  QuietMujoco() {
    t_calls_engine = true;
    // It is ours already where another guard of the process restored handlers in another order.
    const mjfLogHandler previous = mju_setLogHandler(quiet_log);
    if (previous != quiet_log) g_other_threads_log = previous;
  }
  ~QuietMujoco() {
    t_calls_engine = false;
    mju_setLogHandler(g_other_threads_log);
  }
  QuietMujoco(const QuietMujoco&) = delete;
  QuietMujoco& operator=(const QuietMujoco&) = delete;
};

/// MuJoCo writes "… line 12 …" into its message; 0 if it does not.
int line_in(const std::string& message) {
  const std::size_t at = message.find("line ");
  if (at == std::string::npos) return 0;
  int line = 0;
  for (std::size_t i = at + 5;
       i < message.size() && message[i] >= '0' && message[i] <= '9' && line < 10000000; ++i)
    line = 10 * line + (message[i] - '0');
  return line;
}

InputError refusal(const std::filesystem::path& file, std::string message) {
  if (tells_no_memory(message)) throw std::bad_alloc();
  for (char& c : message)
    if (c == '\n') c = ' ';
  while (!message.empty() && message.back() == ' ') message.pop_back();
  return InputError(file.string(), line_in(message), "MuJoCo",
                    message + "; " + cure_of_refusal(message));
}

template <class Visit>
void for_each_texture(mjSpec& spec, const Visit& visit) {
  for (mjsElement* each = mjs_firstElement(&spec, mjOBJ_TEXTURE); each != nullptr;
       each = mjs_nextElement(&spec, each))
    visit(*mjs_asTexture(each));
}

SpecPointer parsed(const std::string& xml, const std::filesystem::path& file) {
  std::array<char, 1000> error{};
  SpecPointer spec(
      mj_parseXMLString(xml.c_str(), nullptr, error.data(), static_cast<int>(error.size())));
  if (!spec) throw refusal(file, error.data());
  return spec;
}

}  // namespace

void call_engine(const std::filesystem::path& file, const std::function<void()>& work) {
  static std::mutex turns;  // the log handler belongs to the process
  const std::lock_guard lock(turns);
  const QuietMujoco quiet;
  try {
    work();
  } catch (const EngineError& error) {
    throw refusal(file, error.what());
  }
}

void shrink_painted_textures(mjSpec& spec) {
  constexpr int kPixels = 2;
  for_each_texture(spec, [](mjsTexture& texture) {
    if (texture.builtin == mjBUILTIN_NONE) return;
    if (texture.width > kPixels) texture.width = kPixels;
    if (texture.height > kPixels) texture.height = kPixels;
  });
}

void paint_over_pictures(mjSpec& spec) {
  for_each_texture(spec, [](mjsTexture& texture) {
    if (texture.builtin != mjBUILTIN_NONE) return;
    mjs_setString(texture.file, "");
    mjs_setString(texture.content_type, "");
    mjs_setStringVec(texture.cubefiles, "");
    texture.builtin = mjBUILTIN_FLAT;
    texture.width = texture.height = 2;
  });
}

ModelPointer compile_mjcf(const std::string& xml, const std::filesystem::path& file,
                          MeshDetail detail) {
  static RecentModels recent;
  // Models with all triangles are large, and asked for once.
  const bool may_be_known = detail == MeshDetail::hulls;
  ModelPointer model;
  if (may_be_known) call_engine(file, [&] { model = recent.find(xml, file); });
  if (model) return model;
  call_engine(file, [&] {
    const SpecPointer spec = parsed(xml, file);
    shrink_painted_textures(*spec);
    compile_without_idle_threads(*spec);
    if (file.has_parent_path())
      mjs_setString(spec->modelfiledir, (file.parent_path().string() + "/").c_str());
    if (detail == MeshDetail::hulls) put_hulls_for_meshes(*spec);
    model.reset(mj_compile(spec.get(), nullptr));
    if (!model) throw refusal(file, mjs_getError(spec.get()));
  });
  if (may_be_known) call_engine(file, [&] { recent.keep(xml, file, *model); });
  return model;
}

mjOption options_of_mjcf(const std::string& xml, const std::filesystem::path& file) {
  mjOption out{};
  call_engine(file, [&] { out = parsed(xml, file)->option; });
  return out;
}

DataPointer kinematics_at(const mjModel& model, const mjtNum* qpos,
                          const std::filesystem::path& file) {
  DataPointer data;
  call_engine(file, [&] {
    data.reset(mj_makeData(&model));
    if (!data) throw std::bad_alloc();
    if (qpos) mju_copy(data->qpos, qpos, static_cast<int>(model.nq));
    mj_kinematics(&model, data.get());
  });
  return data;
}

std::string name_of(const mjModel& model, mjtObj type, int id) {
  const char* name = mj_id2name(&model, type, id);
  return name ? name : "";
}

}  // namespace legwright
