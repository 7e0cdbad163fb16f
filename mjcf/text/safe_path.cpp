// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/safe_path.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "mjcf/text/input_error.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCopyIt =
    "copy the file into the folder of the main file and write its path from there";

const char* kind_of(fs::file_type type) {
  switch (type) {
    case fs::file_type::directory:
      return "a folder";
    case fs::file_type::fifo:
      return "a pipe";
    case fs::file_type::socket:
      return "a socket";
    case fs::file_type::character:
    case fs::file_type::block:
      return "a device";
    default:
      return "no regular file";
  }
}

bool is_below(const fs::path& file, const fs::path& folder) {
  const auto [end, unused] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return end == folder.end();
}

/// What is wrong with the words of a path, before any disk is asked.
std::string fault_of_words(const std::string& reference) {
  if (reference.empty()) return "names no file; write the file's path";
  if (reference.find('\\') != std::string::npos)
    return "has a backslash in its path; write / between folders";
  if (reference.find(':') != std::string::npos)
    return fmt::format("has a colon in its path, which names places elsewhere; {}", kCopyIt);
  for (const char c : reference)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
      return "has a control character in its path; rename the file";
  if (fs::path(reference).is_absolute())
    return fmt::format("is an absolute path, which no copy of the robot could follow; {}", kCopyIt);
  if (path_below(reference).empty())
    return fmt::format("leads out of the folder of the main file; {}", kCopyIt);
  return "";
}

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

}  // namespace

fs::path path_below(const fs::path& reference) {
  if (reference.is_absolute()) return {};
  const fs::path normal = reference.lexically_normal();
  return normal.empty() || *normal.begin() == ".." || normal == "." ? fs::path() : normal;
}

FoundFile find_in_folder(const fs::path& folder, const std::string& reference,
                         std::uintmax_t most_bytes) {
  FoundFile found;
  found.fault = fault_of_words(reference);
  if (!found.fault.empty()) return found;
  found.path = path_below(reference);
  found.source = folder / found.path;
  std::error_code error;
  const fs::file_status status = fs::status(found.source, error);
  if (status.type() == fs::file_type::not_found) {
    found.fault = "is not there; check the path, which starts in the folder of the main file";
    return found;
  }
  if (error) {  // a loop of links, a folder that may not be searched, a name that is too long
    found.fault = fmt::format("cannot be read: {}; mend the file or its path", error.message());
    return found;
  }
  if (!fs::is_regular_file(status)) {
    found.fault = fmt::format("is {}; name a regular file", kind_of(status.type()));
    return found;
  }
  const fs::path real = fs::canonical(found.source, error);
  const fs::path home = error ? fs::path() : fs::canonical(folder.empty() ? "." : folder, error);
  if (error || !is_below(real, home)) {
    found.fault = fmt::format(
        "is a symbolic link that leads out of the folder of the main file; {}", kCopyIt);
    return found;
  }
  // The kernel follows a link before it follows `..`; then the shorter path is another file.
  if (fs::exists(folder / reference, error) &&
      !fs::equivalent(folder / reference, found.source, error)) {
    found.fault = "goes through a symbolic link and back by ..; write the path without ..";
    return found;
  }
  found.bytes = fs::file_size(found.source, error);
  if (error || found.bytes > most_bytes)
    found.fault = fmt::format("is larger than {} MB; make it smaller", most_bytes >> 20);
  else if (found.bytes == 0)
    found.fault = "is empty; is the copy complete?";
  else if (::access(found.source.c_str(), R_OK) != 0)
    found.fault = fmt::format("cannot be read: {}; mend its permissions",
                              std::generic_category().message(errno));
  return found;
}

std::string read_regular_file(const fs::path& file, std::size_t most) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found)
    throw InputError(file.string(), 0, "", "no such file; check the path of the robot");
  if (!error && !fs::is_regular_file(status))
    throw InputError(file.string(), 0, "", "is no regular file; name the robot's MJCF file");
  const Descriptor opened(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat now {};
  if (opened.number() < 0 || ::fstat(opened.number(), &now) != 0)
    throw std::system_error(errno, std::generic_category(), "cannot open " + file.string());
  if (!S_ISREG(now.st_mode))
    throw InputError(file.string(), 0, "", "is no regular file; name the robot's MJCF file");
  std::string bytes;
  char buffer[1 << 16];
  while (bytes.size() <= most) {
    const ssize_t got = ::read(opened.number(), buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0)
      throw std::system_error(errno, std::generic_category(), "cannot read " + file.string());
    if (got == 0) break;
    bytes.append(buffer, static_cast<std::size_t>(got));
  }
  return bytes;
}

}  // namespace legwright
