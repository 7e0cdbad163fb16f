// SPDX-License-Identifier: Apache-2.0
#include "tools/session/journal.hpp"

#include <system_error>
#include <utility>

#include "mjcf/text/input_error.hpp"
#include "tools/files/checksum.hpp"
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

}  // namespace

SessionBegin begin_of(const RobotModel& robot, std::string text, fs::path file) {
  return {robot.file, sha256_hex(robot.files.text()), std::move(text), std::move(file)};
}

ReadJournal read_journal(const fs::path& file) {
  const std::vector<Json> lines = read_events(file);
  if (lines.empty())
    throw InputError(file.string(), 0, "", "has no whole line; expected the journal of a session");
  ReadJournal out;
  out.begin = begin_of(lines[0], file.string());
  int going_on = 0;  // points of a search that has not ended
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const int line = static_cast<int>(k) + 1;
    if (lines[k].value("do", "") == kSearching) {
      Json told = lines[k];
      told["do"] = "searched";
      going_on = std::get<session::Searched>(command_of(told, file.string(), line)).points;
      continue;
    }
    out.commands.push_back(command_of(lines[k], file.string(), line));
    going_on = 0;  // the line that ends a search has all its points
  }
  if (going_on > 0) out.commands.emplace_back(session::Searched{going_on});
  return out;
}

SessionJournal::SessionJournal(const SessionBegin& begin, const fs::path& file) : begin_(begin) {
  if (file.empty()) return;
  std::error_code none;
  fs::remove(file, none);  // where there is none, or it cannot be: the log says so
  log_ = std::make_unique<EventLog>(file);
  log_->append(json_of(begin_));
}

void SessionJournal::add(const SessionCommand& command) {
  commands_.push_back(command);
  if (log_) log_->append(json_of(command));
}

void SessionJournal::searching(int points) {
  if (log_) log_->append({{"do", kSearching}, {"points", points}});
}

std::string SessionJournal::text() const {
  std::string text = event_line(json_of(begin_)) + "\n";
  for (const SessionCommand& command : commands_) text += event_line(json_of(command)) + "\n";
  return text;
}

}  // namespace legwright
