// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "mjcf/read/robot_model.hpp"
#include "tools/run/events.hpp"
#include "tools/session/command.hpp"

namespace legwright {

/// What a session began with.
struct SessionBegin {
  std::filesystem::path robot;  // file that was read
  std::string robot_sha256;     // of its MJCF, all parts in one text
  std::string text;             // of the task file
  std::filesystem::path file;   // its name, for messages
};

/// The begin of a session with this robot.
SessionBegin begin_of(const RobotModel& robot, std::string text, std::filesystem::path file);

/// A journal as it was read.
struct ReadJournal {
  SessionBegin begin;
  std::vector<SessionCommand> commands;
};

/// Reads a journal, whose last line may be torn. A search that was going on counts with the points
/// that it had. Throws InputError for lines that are no session's and for damaged ones before the
/// last, std::system_error where the file cannot be read.
ReadJournal read_journal(const std::filesystem::path& file);

/// Everything that happened in a session, in order; on disk, too, as it happens: each line is one
/// write, so a process that dies has it there. Replayed, it leads to the same state. What solves
/// found stands beside their commands, until it is so much that the file would not be read again.
class SessionJournal {
 public:
  /// @param file to write to, or empty. A journal that is there is replaced.
  /// @param most_found [bytes] so much of what was found is kept: half of what is read again
  /// Throws IoError where something else is there, std::system_error where it cannot be written.
  SessionJournal(const SessionBegin& begin, const std::filesystem::path& file,
                 std::size_t most_found = std::size_t{32} << 20);

  /// Throws std::system_error where the file cannot be written, say on a full disk: it ends there.
  void add(const SessionCommand& command);
  /// The search that goes on has had so many points: for a process that dies meanwhile. Throws
  /// likewise.
  void searching(int points);
  /// The same as the file has it, without what searches told on their way.
  const std::string& text() const { return text_; }

 private:
  void write(const Json& line);
  Json line_of(const SessionCommand& command);

  std::string text_;
  std::unique_ptr<EventLog> log_;
  std::size_t room_;  // for what is found yet [bytes]
};

}  // namespace legwright
