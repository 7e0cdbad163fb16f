// SPDX-License-Identifier: Apache-2.0
#include "tools/run/events.hpp"
#include "tools/files/parse_json.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>
#include <system_error>

#include "tools/files/checksum.hpp"

namespace legwright {
namespace {

constexpr std::string_view kCrcField = ",\"crc\":\"";
constexpr std::size_t kTailSize = kCrcField.size() + 8 + 2;  // field, eight digits, quote and brace

[[noreturn]] void fail(const std::string& what, const std::filesystem::path& path) {
  const int error = errno;
  throw std::system_error(error, std::generic_category(), what + " " + path.string());
}

/// The event of a line, or a discarded value where the line is damaged.
Json parse_line(std::string_view line) {
  if (line.size() < kTailSize) return Json::value_t::discarded;
  const std::size_t split = line.size() - kTailSize;
  const std::string body = std::string(line.substr(0, split)) + "}";
  if (line.substr(split) != std::string(kCrcField) + crc32_hex(body) + "\"}")
    return Json::value_t::discarded;
  return parse_json(body);
}

}  // namespace

std::string event_line(const Json& event) {
  const std::string body = event.dump(-1, ' ', false, Json::error_handler_t::replace);
  return body.substr(0, body.size() - 1) + std::string(kCrcField) + crc32_hex(body) + "\"}";
}

EventLog::EventLog(const std::filesystem::path& path)
    : path_(path),
      descriptor_(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) fail("cannot create", path_);
}

EventLog::~EventLog() { ::close(descriptor_); }

void EventLog::append(const Json& event) {
  const std::string line = event_line(event) + "\n";
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t written = ::write(descriptor_, line.data() + done, line.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("cannot append to", path_);
    done += static_cast<std::size_t>(written);
  }
}

void EventLog::sync() {
  if (::fsync(descriptor_) != 0) fail("cannot flush", path_);
}

std::vector<Json> read_events(const std::filesystem::path& path) {
  const std::string text = read_file(path);
  std::vector<Json> events;
  std::size_t start = 0;
  for (std::size_t end; (end = text.find('\n', start)) != std::string::npos; start = end + 1) {
    Json event = parse_line(std::string_view(text).substr(start, end - start));
    if (event.is_discarded()) break;
    events.push_back(std::move(event));
  }
  return events;
}

}  // namespace legwright
