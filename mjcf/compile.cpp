// SPDX-License-Identifier: Apache-2.0
#include "mjcf/compile.hpp"

#include <array>
#include <mutex>
#include <stdexcept>

#include "mjcf/input_error.hpp"

namespace legwright {
namespace {

/// MuJoCo's own handler prints, writes a log file, and ends the process on errors.
void quiet_log(const mjLogMessage* message) {
  if (message->level == mjLOG_ERROR)
    throw std::runtime_error(std::string("MuJoCo: ") + message->subject);
}

class QuietMujoco {
 public:
  QuietMujoco() : previous_(mju_setLogHandler(quiet_log)) {}
  ~QuietMujoco() { mju_setLogHandler(previous_); }
  QuietMujoco(const QuietMujoco&) = delete;
  QuietMujoco& operator=(const QuietMujoco&) = delete;

 private:
  mjfLogHandler previous_;
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
  for (char& c : message)
    if (c == '\n') c = ' ';
  while (!message.empty() && message.back() == ' ') message.pop_back();
  return InputError(file.string(), line_in(message), "MuJoCo",
                    message + "; mend the file so that MuJoCo opens it without Legwright");
}

}  // namespace

ModelPointer compile_mjcf(const std::string& xml, const std::filesystem::path& file) {
  static std::mutex turns;  // the log handler belongs to the process
  const std::lock_guard lock(turns);
  const QuietMujoco quiet;
  std::array<char, 1000> error{};
  const std::unique_ptr<mjSpec, MujocoDeleter> spec(
      mj_parseXMLString(xml.c_str(), nullptr, error.data(), static_cast<int>(error.size())));
  if (!spec) throw refusal(file, error.data());
  ModelPointer model(mj_compile(spec.get(), nullptr));
  if (!model) throw refusal(file, mjs_getError(spec.get()));
  return model;
}

std::string name_of(const mjModel& model, mjtObj type, int id) {
  const char* name = mj_id2name(&model, type, id);
  return name ? name : "";
}

}  // namespace legwright
