// SPDX-License-Identifier: Apache-2.0
#include "tools/files/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <system_error>
#include <utility>

#include "tools/files/io_error.hpp"
#include "tools/files/unfinished_path.hpp"

namespace legwright {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& what, const std::filesystem::path& path) {
  const int error = errno;
  throw std::system_error(error, std::generic_category(), what + " " + path.string());
}

/// An open file, closed on every way out.
class Descriptor {
 public:
  Descriptor(const std::filesystem::path& path, int flags, mode_t mode = 0)
      : number_(::open(path.c_str(), flags | O_CLOEXEC, mode)) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }
  /// A delayed write error may only show here.
  bool close() { return ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// A new file beside `path`. Its name is random: where process ids repeat, as in containers, a
/// counted one may be that of a killed process.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& path) {
    constexpr int kTries = 100;
    constexpr std::size_t kStem = 200;  // of the 255 bytes that a name may have
    const std::string stem = path.filename().string().substr(0, kStem);
    for (int n = 0; n < kTries && !file_; ++n) {
      std::uint64_t random = 0;
      if (::getrandom(&random, sizeof random, 0) != sizeof random) return;
      path_.emplace(path.parent_path() / fmt::format(".{}.{:016x}.tmp", stem, random));
      file_.emplace(path_->path(), O_WRONLY | O_CREAT | O_EXCL, 0666);
      if (file_->is_open()) return;
      const int error = errno;
      file_.reset();
      path_.reset();
      errno = error;
      if (error != EEXIST) return;
    }
  }
  ~TemporaryFile() {
    if (file_ && path_) ::unlink(path_->path().c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  bool is_open() const { return file_.has_value(); }
  Descriptor& file() { return *file_; }
  bool replace(const fs::path& path) {
    const std::error_code error = path_->rename_to(path);
    if (!error) path_.reset();
    errno = error.value();
    return !error;
  }

 private:
  std::optional<UnfinishedPath> path_;
  std::optional<Descriptor> file_;
};

/// The open descriptor that a path such as /dev/stdout or /proc/self/fd/3 stands for.
std::optional<int> descriptor_named(const fs::path& path) {
  std::error_code error;
  const fs::path folder = fs::canonical(path.parent_path(), error);
  if (error || folder != fmt::format("/proc/{}/fd", ::getpid())) return std::nullopt;
  const std::string name = path.filename().string();
  int number = -1;
  const auto [end, fault] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (fault != std::errc() || end != name.data() + name.size()) return std::nullopt;
  return number;
}

/// Where the bytes go: the file that links lead to, whether it is there or not, or an open
/// descriptor.
struct Destination {
  fs::path path;
  std::optional<int> descriptor;
};

Destination destination_of(fs::path path) {
  constexpr int kMostLinks = 40;  // as the kernel has it
  for (int n = 0; n < kMostLinks; ++n) {
    if (const auto number = descriptor_named(path)) return {path, number};
    std::error_code error;
    if (!fs::is_symlink(fs::symlink_status(path, error))) return {path, std::nullopt};
    path = path.parent_path() / fs::read_symlink(path);
  }
  errno = ELOOP;
  fail("cannot write", path);
}

/// Into a pipe, a device or an open descriptor, which no rename may replace.
void write_directly(const Destination& to, std::string_view bytes) {
  std::fflush(nullptr);  // what was printed before stands before
  if (to.descriptor) {
    if (!write_all(*to.descriptor, bytes)) fail("cannot write", to.path);
    return;
  }
  Descriptor file(to.path, O_WRONLY | O_NOCTTY);
  if (!file.is_open() || !write_all(file.number(), bytes) || !file.close())
    fail("cannot write", to.path);
}

/// Mode and owner of the file that is replaced. Who may not give files away keeps the mode.
bool take_over(int file, const struct stat& old) {
  struct stat fresh {};
  if (::fstat(file, &fresh) != 0) return false;
  mode_t mode = old.st_mode & 07777U;
  if ((fresh.st_uid != old.st_uid || fresh.st_gid != old.st_gid) &&
      ::fchown(file, old.st_uid, old.st_gid) != 0)
    mode &= 0777U;  // no set-user-id for another user
  return ::fchmod(file, mode) == 0;
}

}  // namespace

void write_file(const fs::path& asked, std::string_view bytes, Durability durability) {
  const Destination to = destination_of(asked);
  struct stat old {};
  const bool existed = !to.descriptor && ::stat(to.path.c_str(), &old) == 0;
  if (to.descriptor || (existed && !S_ISREG(old.st_mode) && !S_ISDIR(old.st_mode)))
    return write_directly(to, bytes);
  const fs::path& path = to.path;
  TemporaryFile temporary(path);
  if (!temporary.is_open()) fail("cannot write", path);
  Descriptor& file = temporary.file();
  const bool regular = existed && S_ISREG(old.st_mode);
  if (!write_all(file.number(), bytes) || (regular && !take_over(file.number(), old)) ||
      (durability == Durability::power && ::fsync(file.number()) != 0) || !file.close() ||
      !temporary.replace(path))
    fail("cannot write", path);
  if (durability == Durability::power)
    sync_folder(path.has_parent_path() ? path.parent_path() : fs::path("."));
}

namespace {

/// The bytes of a regular file, or its first `most`.
std::string read_regular(const fs::path& path, std::size_t most) {
  Descriptor file(path, O_RDONLY | O_NONBLOCK | O_NOCTTY);  // a pipe without a writer would hang
  struct stat kind {};
  if (!file.is_open() || ::fstat(file.number(), &kind) != 0) fail("cannot read", path);
  if (!S_ISREG(kind.st_mode) && !S_ISDIR(kind.st_mode))  // of a folder read() tells
    throw IoError(path.string() +
                  ": is a pipe, a socket or a device; expected a regular file: write what it "
                  "holds into one");
  std::string bytes;
  char buffer[1 << 16];
  while (bytes.size() < most) {
    const std::size_t wanted = std::min(sizeof buffer, most - bytes.size());
    const ssize_t got = ::read(file.number(), buffer, wanted);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail("cannot read", path);
    if (got == 0) break;
    bytes.append(buffer, static_cast<std::size_t>(got));
  }
  return bytes;
}

}  // namespace

std::string read_file(const fs::path& path, std::size_t most) {
  std::string bytes = read_regular(path, most + 1);
  if (bytes.size() > most)
    throw IoError(path.string() + ": larger than " + std::to_string(most) + " bytes");
  return bytes;
}

std::string read_head(const fs::path& path, std::size_t count) { return read_regular(path, count); }

void sync_folder(const std::filesystem::path& folder) {
  Descriptor file(folder, O_RDONLY | O_DIRECTORY);
  if (!file.is_open()) fail("cannot open folder", folder);
  // Some file systems cannot flush a folder and say EINVAL; the rename is as safe there as it gets.
  if (::fsync(file.number()) != 0 && errno != EINVAL) fail("cannot flush folder", folder);
}

}  // namespace legwright
