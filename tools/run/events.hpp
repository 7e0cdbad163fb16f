// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/files/json_file.hpp"

namespace legwright {

/// One line of events.jsonl without its newline: the event's JSON with a last field "crc", the
/// CRC-32 of the line as it would be without that field.
std::string event_line(const Json& event);

/// The file events.jsonl, append-only. Each line is one write, so a reader beside us sees whole
/// lines.
class EventLog {
 public:
  /// Creates the file. Throws std::system_error where it exists already or cannot be written.
  explicit EventLog(const std::filesystem::path& path);
  ~EventLog();
  EventLog(const EventLog&) = delete;
  EventLog& operator=(const EventLog&) = delete;

  /// Throws std::system_error, for instance on a full disk.
  void append(const Json& event);
  /// Flushes to the disk. Throws std::system_error.
  void sync();

 private:
  std::filesystem::path path_;
  int descriptor_;
};

/// The events of a log up to the first line that is torn or fails its CRC; their "crc" fields
/// removed. Throws std::system_error where the file cannot be read.
std::vector<Json> read_events(const std::filesystem::path& path);

}  // namespace legwright
