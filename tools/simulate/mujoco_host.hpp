// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "mjcf/scene/gait_plugin.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/mujoco_pointers.hpp"
#include "tools/simulate/plugin_files.hpp"

namespace legwright {

/// MuJoCo refused something or failed; the message is its own, with what to do where that is known.
class MujocoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Takes over MuJoCo's messages for this process: nothing is printed, no MUJOCO_LOG.TXT is written.
/// While a MujocoMessages lives on a thread, warnings of that thread are kept there and an error
/// becomes a MujocoError instead of the end of the process. Idempotent; every function below calls
/// it.
void take_over_mujoco_messages();

/// For a host that has other users of MuJoCo, like Python: what threads without a MujocoMessages
/// say goes where it went before. To be called before all else.
void leave_others_their_messages();

/// Collects the warnings that MuJoCo gives on this thread while it lives; nests.
class MujocoMessages {
 public:
  MujocoMessages();
  ~MujocoMessages();
  MujocoMessages(const MujocoMessages&) = delete;
  MujocoMessages& operator=(const MujocoMessages&) = delete;
  const std::vector<std::string>& warnings() const { return warnings_; }
  void add(std::string warning) { warnings_.push_back(std::move(warning)); }

 private:
  MujocoMessages* outer_;
  std::vector<std::string> warnings_;
};

/// Makes legwright.gait known to MuJoCo, once per process. Throws PluginError which lists the
/// places where it was looked for, or why it could not be loaded.
void load_gait_plugin();

/// Compiles MJCF text. Throws MujocoError with MuJoCo's reason, led by `name`.
/// @param folder against which the text's asset paths are meant; may be empty.
/// @param detail hulls: of a model that nobody looks at, without what is only to be seen
ModelPointer compile_model(const std::string& xml, const std::string& name,
                           const std::filesystem::path& folder = {},
                           MeshDetail detail = MeshDetail::hulls);

/// Throws MujocoError unless `xml` asks for the plugin legwright.gait: a robot alone has no gait to
/// play.
/// @param name of the scene, for the message.
void require_gait_plugin(const mjModel& model, const std::string& name);

/// Throws MujocoError where MuJoCo cannot make it.
DataPointer make_data(const mjModel& model);

}  // namespace legwright
