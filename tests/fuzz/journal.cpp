// SPDX-License-Identifier: Apache-2.0
#include "tools/session/journal.hpp"

#include <algorithm>

#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/promises.hpp"
#include "tests/fuzz/targets.hpp"
#include "tools/files/checksum.hpp"
#include "tools/files/parse_json.hpp"

namespace legwright::test {
namespace {

/// The line with the checksum that an event has, which no chance would find.
std::string summed(std::string_view line) {
  const std::string body(line);
  return body.substr(0, body.size() - 1) + R"(,"crc":")" + crc32_hex(body) + "\"}";
}

std::string file_of(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    const bool as_is = line.starts_with('!');
    out += as_is ? std::string(line.substr(1)) : line.ends_with('}') ? summed(line) : line;
    if (end < text.size()) out += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

void check_command(const Json& event) {
  const std::string file = "journal";
  SessionCommand command;
  if (!accepted(file, [&] { command = command_of(event, file, 1); })) return;
  const Json written = json_of(command);
  promise(json_of(command_of(written, file, 1)) == written, "a command is another when read again");
}

void check_commands(const ReadJournal& journal, const ReadJournal& again) {
  promise(journal.commands.size() == again.commands.size(), "a journal has other commands");
  for (std::size_t k = 0; k < journal.commands.size(); ++k)
    promise(json_of(journal.commands[k]) == json_of(again.commands[k]),
            "a journal is another when read again");
}

}  // namespace

bool fuzz_journal(std::string_view text) {
  static MemoryFile file;
  file.put(file_of(text));
  const std::vector<Json> events = read_events(file.path());
  std::string again;
  for (const Json& event : events) {
    check_command(event);
    if (event.is_object() && !event.empty()) again += event_line(event) + "\n";
  }
  ReadJournal journal;
  const bool read = accepted(file.path(), [&] { journal = read_journal(file.path()); });
  file.put(again);
  if (std::all_of(events.begin(), events.end(),
                  [](const Json& e) { return e.is_object() && !e.empty(); }))
    promise(read_events(file.path()) == events, "events are others when read again");
  if (read) check_commands(journal, read_journal(file.path()));
  return read;
}

}  // namespace legwright::test
