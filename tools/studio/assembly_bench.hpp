// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "mjcf/read/read_robot.hpp"
#include "tools/assemble/assembly_desk.hpp"
#include "tools/drawables/drawn_design.hpp"
#include "tools/studio/event_hub.hpp"
#include "tools/studio/kept_sessions.hpp"

namespace legwright {

/// A robot that is being assembled of modules: each change is drawn, told to the hub as `assembly`,
/// and kept in the user's state before it is answered. Any thread may call.
class AssemblyBench {
 public:
  /// Throws InputError as AssemblyDesk does. @param kept, hub and meshes must live longer
  /// @param origin the file that it is from; empty where it is new
  AssemblyBench(AssemblyDesk desk, std::filesystem::path origin, const KeptSessions& kept,
                EventHub& hub, MeshStore& meshes);
  AssemblyBench(const AssemblyBench&) = delete;
  AssemblyBench& operator=(const AssemblyBench&) = delete;

  /// Obeys a command of AssemblyDesk. Throws InputError, also where MuJoCo refuses the body;
  /// nothing changes then. @return {item}
  Json obey(const Json& command);
  /// Tells the hub what is there.
  void tell();
  /// Builds the robot (build_robot()) into the bench's folder. Throws InputError where it is no
  /// robot yet. @param notes gets what build_robot() notes
  RobotModel build(std::vector<std::string>& notes);
  /// Writes the assembly to a file. Throws IoError where that is there and not to be replaced,
  /// InputError for a name without .toml.
  void save(const std::filesystem::path& file, bool replace);

  /// Something else is open: commands that still come are refused (InputError), and nothing more is
  /// told.
  void close();
  /// Has in its folder what may be missed: it stays there until it is saved.
  void keep();
  std::filesystem::path folder() const;
  std::filesystem::path origin() const;

 private:
  Json picture(const AssemblyDesk& desk) const;
  void check_open() const;  // by mutex_

  mutable std::mutex mutex_;
  AssemblyDesk desk_;
  std::filesystem::path origin_;
  const KeptSessions& kept_;
  EventHub& hub_;
  MeshStore& meshes_;
  std::unique_ptr<SessionFolder> folder_;
  int revision_ = 0;
  bool closed_ = false;
  Json drawn_;  // what was told last
};

}  // namespace legwright
