// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/safe_path.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "mjcf/text/input_error.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCopyIt = "copy the file beside the main file and write its path from there";

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

/// Absolute and without `.`, `..` and a slash at its end; no link is followed.
fs::path without_steps(const fs::path& folder) {
  const fs::path out = fs::absolute(folder.empty() ? "." : folder).lexically_normal();
  return out.has_filename() || out == out.root_path() ? out : out.parent_path();
}

/// What is wrong with the words of a path, before any disk is asked.
std::string fault_of_words(const std::string& reference) {
  if (reference.empty()) return "names no file; write the file's path";
  if (is_windows_root(reference))
    return fmt::format("is a path of a Windows computer, which begins at a drive or its root; {}",
                       kCopyIt);
  if (reference.find("://") != std::string::npos)
    return fmt::format("has :// in its path, which names places elsewhere; {}", kCopyIt);
  for (const char c : reference)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
      return "has a control character in its path; rename the file";
  return "";
}

/// Whether a small file stands in for one that git keeps elsewhere.
bool is_lfs_pointer(const fs::path& file, std::uintmax_t bytes) {
  constexpr std::string_view kHead = "version https://git-lfs.github.com/";
  constexpr std::uintmax_t kMostBytesOfPointer = 1024;
  if (bytes > kMostBytesOfPointer) return false;
  std::string head(kHead.size(), '\0');
  std::ifstream(file, std::ios::binary)
      .read(head.data(), static_cast<std::streamsize>(head.size()));
  return head == kHead;
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

bool is_windows_root(std::string_view reference) {
  const bool drive = reference.size() > 2 && reference[1] == ':' &&
                     std::isalpha(static_cast<unsigned char>(reference[0])) &&
                     (reference[2] == '\\' || reference[2] == '/');
  return drive || reference.starts_with('\\');
}

std::string slashed(std::string reference) {
  if (!is_windows_root(reference)) std::replace(reference.begin(), reference.end(), '\\', '/');
  return reference;
}

fs::path path_below(const fs::path& reference) {
  if (reference.is_absolute()) return {};
  const fs::path normal = reference.lexically_normal();
  return normal.empty() || *normal.begin() == ".." || normal == "." ? fs::path() : normal;
}

fs::path named_path(const fs::path& folder, const fs::path& reference) {
  if (fs::path inside = path_below(reference); !inside.empty()) return inside;
  const fs::path home = without_steps(folder);
  const fs::path from_home = (home / reference).lexically_normal().lexically_relative(home);
  if (fs::path inside = path_below(from_home); !inside.empty()) return inside;
  return reference.is_absolute() ? reference.lexically_normal() : from_home;
}

fs::path source_of(const fs::path& folder, const fs::path& named) {
  const bool below = !path_below(named).empty();
  return below ? folder / named : (folder / named).lexically_normal();
}

FoundFile find_file(const fs::path& folder, const std::string& reference, std::uintmax_t most_bytes,
                    const FileReach& reach) {
  FoundFile found;
  found.fault = fault_of_words(reference);
  if (!found.fault.empty()) return found;
  const fs::path home = without_steps(folder);
  found.path = named_path(folder, slashed(reference));
  found.source = source_of(folder, found.path);
  found.fault = reach.fault_of_place((home / found.path).lexically_normal(), home);
  if (!found.fault.empty()) return found;
  std::error_code error;
  const fs::file_status status = fs::status(found.source, error);
  if (status.type() == fs::file_type::not_found) {
    found.missing = true;
    found.fault = "is not there; check the path, which starts in the folder of the main file";
    return found;
  }
  if (error) {  // a loop of links, a folder that may not be searched, a name that is too long
    found.fault = fmt::format("cannot be read: {}; mend the file or its path", error.message());
    return found;
  }
  found.fault = reach.fault_of_target(found.source, home);
  if (!found.fault.empty()) return found;
  if (!fs::is_regular_file(status)) {
    found.fault = fmt::format("is {}; name a regular file", kind_of(status.type()));
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
  else if (is_lfs_pointer(found.source, found.bytes))
    found.fault =
        "is a pointer of Git LFS, not the file: `git lfs install` and `git lfs pull` in its "
        "repository fetch it, where a ZIP archive of a repository has pointers alone";
  return found;
}

std::string read_regular_file(const fs::path& file, std::size_t most) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found)
    throw InputError(file.string(), 0, "", "no such file; check the path of the robot");
  if (!error && !fs::is_regular_file(status))
    throw InputError(file.string(), 0, "",
                     "is no regular file; name the robot's MJCF or URDF file");
  const Descriptor opened(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat now {};
  if (opened.number() < 0 || ::fstat(opened.number(), &now) != 0)
    throw std::system_error(errno, std::generic_category(), "cannot open " + file.string());
  if (!S_ISREG(now.st_mode))
    throw InputError(file.string(), 0, "",
                     "is no regular file; name the robot's MJCF or URDF file");
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
