// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "mjcf/text/robot_files.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {

/// A session that was left behind, by a program that ended or died.
struct KeptSession {
  std::filesystem::path folder;
  std::string origin;  // what was opened: a file or a run
  std::string name;    // session_name()
  std::string begun;   // "2026-03-01 14:05"
};

/// In such a folder the assembly that was worked on, where that is what was left.
inline constexpr const char* kKeptAssembly = "assembly.toml";

/// A folder in the user's state in which a session's robot and journal are kept as it goes, locked
/// for as long as this lives; the lock goes with the process, however it ends.
class SessionFolder {
 public:
  SessionFolder(std::filesystem::path path, int lock) : path_(std::move(path)), lock_(lock) {}
  ~SessionFolder();
  SessionFolder(const SessionFolder&) = delete;
  SessionFolder& operator=(const SessionFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path robot() const { return path_ / "robot" / "robot.xml"; }
  std::filesystem::path journal() const { return path_ / "session.jsonl"; }
  std::filesystem::path assembly() const { return path_ / kKeptAssembly; }
  /// Something is in it that may be missed: it stays when this goes.
  void keep() { kept_ = true; }
  void forget() { kept_ = false; }

 private:
  std::filesystem::path path_;
  int lock_;
  bool kept_ = false;
};

/// Where the studio keeps what must outlive it: $XDG_STATE_HOME/legwright/studio, else
/// ~/.local/state/legwright/studio.
std::filesystem::path studio_state_folder();

/// Sessions and recent files in the user's state. Throws std::system_error where that cannot be
/// written.
class KeptSessions {
 public:
  explicit KeptSessions(std::filesystem::path root) : root_(std::move(root)) {}

  const std::filesystem::path& root() const { return root_; }
  /// A new folder with a copy of the robot.
  std::unique_ptr<SessionFolder> begin(const RobotFiles& robot, const std::string& origin,
                                       const std::string& name) const;
  /// A new folder with an assembly's text.
  std::unique_ptr<SessionFolder> begin_assembly(const std::string& text, const std::string& origin,
                                                const std::string& name) const;
  /// A new folder for work in the background, which goes with this; those of programs that died go
  /// now.
  std::unique_ptr<SessionFolder> begin_work(const std::string& name) const;
  /// Those that no program works on, the newest first.
  std::vector<KeptSession> left_behind() const;
  /// Whether a folder is one of these sessions, not a copy.
  bool owns(const std::filesystem::path& folder) const;
  /// Takes one away that was taken up; a copy that somebody keeps elsewhere stays.
  void remove(const std::filesystem::path& folder) const;
  /// Whether a program works on a session, or another user's may.
  static bool is_held(const std::filesystem::path& folder);
  /// A new folder for a robot that comes without one.
  std::filesystem::path new_robot_folder() const;

  void note_recent(const std::filesystem::path& path, const std::string& words) const;
  /// [{path, words, opened}], the newest first, as far as they are still there.
  Json recent() const;

 private:
  /// A new folder, locked, with `about.json`.
  std::unique_ptr<SessionFolder> new_session(const std::string& origin,
                                             const std::string& name) const;

  std::filesystem::path root_;
  mutable std::mutex recent_mutex_;  // of its file: requests and jobs both note
};

/// The origin of a kept session, or nothing where the folder is none.
std::optional<KeptSession> kept_session(const std::filesystem::path& folder);

}  // namespace legwright
