// SPDX-License-Identifier: Apache-2.0
#include "tools/files/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <system_error>
#include <utility>

#include "tools/files/io_error.hpp"

namespace legwright {
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

std::filesystem::path temporary_for(const std::filesystem::path& path) {
  static std::atomic<unsigned> counter{0};
  return path.parent_path() /
         fmt::format(".{}.{}-{}.tmp", path.filename().string(), ::getpid(), counter++);
}

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view bytes, Durability durability) {
  const std::filesystem::path temporary = temporary_for(path);
  Descriptor file(temporary, O_WRONLY | O_CREAT | O_EXCL, 0666);
  if (!file.is_open()) fail("cannot write", path);
  const bool ok = write_all(file.number(), bytes) &&
                  (durability == Durability::process || ::fsync(file.number()) == 0) &&
                  file.close() && std::rename(temporary.c_str(), path.c_str()) == 0;
  if (!ok) {
    const int error = errno;
    ::unlink(temporary.c_str());
    errno = error;
    fail("cannot write", path);
  }
  if (durability == Durability::power)
    sync_folder(path.has_parent_path() ? path.parent_path() : std::filesystem::path("."));
}

std::string read_file(const std::filesystem::path& path, std::size_t most) {
  Descriptor file(path, O_RDONLY);
  if (!file.is_open()) fail("cannot read", path);
  std::string bytes;
  char buffer[1 << 16];
  for (;;) {
    const ssize_t got = ::read(file.number(), buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail("cannot read", path);
    if (got == 0) return bytes;
    bytes.append(buffer, static_cast<std::size_t>(got));
    if (bytes.size() > most)
      throw IoError(path.string() + ": larger than " + std::to_string(most) + " bytes");
  }
}

void sync_folder(const std::filesystem::path& folder) {
  Descriptor file(folder, O_RDONLY | O_DIRECTORY);
  if (!file.is_open()) fail("cannot open folder", folder);
  // Some file systems cannot flush a folder and say EINVAL; the rename is as safe there as it gets.
  if (::fsync(file.number()) != 0 && errno != EINVAL) fail("cannot flush folder", folder);
}

}  // namespace legwright
