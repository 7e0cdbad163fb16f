// SPDX-License-Identifier: Apache-2.0
#include "tools/session/journal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "mjcf/text/input_error.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/checksum.hpp"
#include "tools/files/io_error.hpp"
#include "tools/run/install.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBegin = "begin";
constexpr const char* kSearching = "searching";

Json json_of(const SessionBegin& begin) {
  return {{"do", kBegin},
          {"legwright", program_version()},
          {"robot", begin.robot.string()},
          {"robot_sha256", begin.robot_sha256},
          {"task", begin.file.string()},
          {"text", begin.text}};
}

SessionBegin begin_of(const Json& json, const std::string& file) {
  try {
    if (json.at("do") != kBegin) throw std::invalid_argument("is no begin");
    return {json.at("robot").get<std::string>(), json.at("robot_sha256").get<std::string>(),
            json.at("text").get<std::string>(), json.at("task").get<std::string>()};
  } catch (const std::exception&) {
    throw InputError(file, 1, "", "is no begin of a session; expected the journal of one");
  }
}

/// All lines of a journal, but a torn one at its end.
std::vector<Json> whole_lines(const fs::path& file) {
  std::vector<Json> lines = read_events(file);
  if (lines.empty())
    throw InputError(file.string(), 0, "", "has no whole line; expected the journal of a session");
  const std::string text = read_file(file);
  const auto there = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  if (lines.size() + 1 < there)
    throw InputError(file.string(), static_cast<int>(lines.size()) + 1, "",
                     fmt::format("is damaged, and {} lines follow; to have what comes before it, "
                                 "keep the first {} lines alone",
                                 there - lines.size() - 1, lines.size()));
  return lines;
}

bool is_journal(const fs::path& file) {
  if (!fs::is_regular_file(fs::symlink_status(file))) return false;
  const std::vector<Json> lines = read_events(file);
  return !lines.empty() && lines[0].contains("do") && lines[0]["do"] == kBegin;
}

}  // namespace

SessionBegin begin_of(const RobotModel& robot, std::string text, fs::path file) {
  return {robot.file, sha256_hex(robot.files.gathered().text()), std::move(text), std::move(file)};
}

ReadJournal read_journal(const fs::path& file) {
  const std::vector<Json> lines = whole_lines(file);
  ReadJournal out;
  out.begin = begin_of(lines[0], file.string());
  std::optional<session::Searched> going_on;  // a search that has not ended
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const int line = static_cast<int>(k) + 1;
    if (lines[k].contains("do") && lines[k]["do"] == kSearching) {
      Json told = lines[k];
      told["do"] = "searched";
      going_on = std::get<session::Searched>(command_of(told, file.string(), line));
      continue;
    }
    out.commands.push_back(command_of(lines[k], file.string(), line));
    going_on.reset();  // the line that ends a search has all its points
  }
  if (going_on) out.commands.emplace_back(*std::move(going_on));
  return out;
}

SessionJournal::SessionJournal(const SessionBegin& begin, const fs::path& file,
                               std::size_t most_found)
    : text_(event_line(json_of(begin)) + "\n"), room_(most_found) {
  if (file.empty()) return;
  if (fs::exists(fs::symlink_status(file))) {
    if (!is_journal(file))
      throw IoError(file.string() + ": is there and is no journal of a session; name a new file");
    fs::remove(file);
  }
  log_ = std::make_unique<EventLog>(file);
  log_->append(json_of(begin));
}

void SessionJournal::add(const SessionCommand& command) {
  const Json line = line_of(command);
  text_ += event_line(line) + "\n";
  write(line);
}

void SessionJournal::searching(int points) { write({{"do", kSearching}, {"points", points}}); }

/// The command's line, without what it found where there is no room for more.
Json SessionJournal::line_of(const SessionCommand& command) {
  Json line = json_of(command);
  const auto found = line.find("found");
  if (found == line.end()) return line;
  const std::size_t size = found->dump().size();
  if (size <= room_) {
    room_ -= size;
    return line;
  }
  line.erase("found");
  // Where a state is missing, those behind it are not come to without a solve.
  if (!std::holds_alternative<session::WorkedOut>(command)) room_ = 0;
  return line;
}

// Nothing is written behind a line that was torn.
void SessionJournal::write(const Json& line) {
  if (!log_) return;
  try {
    log_->append(line);
  } catch (...) {
    log_.reset();
    throw;
  }
}

}  // namespace legwright
