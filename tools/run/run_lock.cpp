// SPDX-License-Identifier: Apache-2.0
#include "tools/run/run_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <ctime>
#include <optional>
#include <sstream>
#include <system_error>
#include <thread>
#include <utility>

#include "tools/files/clean_text.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/unfinished_path.hpp"
#include "tools/run/result_folder.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 && name[0] != '\0' ? name.data()
                                                                             : "this machine";
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  ::gmtime_r(&now, &parts);
  std::array<char, 40> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S UTC", &parts)};
}

/// Who holds a lock, as its file says.
struct Holder {
  long process = 0;
  std::string host, since, build;
};

Holder read_holder(int descriptor) {
  std::array<char, 512> text{};
  const ssize_t got = ::pread(descriptor, text.data(), text.size() - 1, 0);
  if (got <= 0) return {};
  Holder holder;
  std::istringstream lines(std::string(text.data(), static_cast<std::size_t>(got)));
  std::string process;
  if (!std::getline(lines, process) || !std::getline(lines, holder.host) ||
      !std::getline(lines, holder.since) || lines.eof())
    return {};
  std::getline(lines, holder.build);
  for (const char digit : process.substr(0, 18)) {
    if (digit < '0' || digit > '9') return {};
    holder.process = 10 * holder.process + (digit - '0');
  }
  return holder;
}

bool is_running(const Holder& holder) {
  return holder.process > 0 &&
         (holder.host != host_name() || ::kill(static_cast<pid_t>(holder.process), 0) == 0 ||
          errno == EPERM);
}

/// Who holds it has perhaps not yet written so, or the file still names a killed process.
[[noreturn]] void refuse_second_writer(int descriptor, const fs::path& run) {
  constexpr int kTries = 500;  // a second: a busy machine may let it wait
  Holder holder = read_holder(descriptor);
  for (int n = 0; n < kTries && !is_running(holder); ++n) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    holder = read_holder(descriptor);
  }
  ::close(descriptor);
  const std::string who = holder.process == 0
                              ? "another process"
                              : fmt::format("process {} on {} since {}", holder.process,
                                            clean_utf8(holder.host), clean_utf8(holder.since));
  throw IoError(
      fmt::format("{} is in use by {}: wait for it or choose another folder", run.string(), who));
}

/// Whether a path still leads to an open file.
bool is_same(int descriptor, const fs::path& path) {
  struct stat open {
  }, named{};
  return ::fstat(descriptor, &open) == 0 && ::stat(path.c_str(), &named) == 0 &&
         open.st_dev == named.st_dev && open.st_ino == named.st_ino;
}

/// @param build name of the folder in which it builds, or nothing
void write_holder(int descriptor, const std::string& since, const std::string& build) {
  const std::string text = fmt::format("{}\n{}\n{}\n{}\n", ::getpid(), host_name(), since, build);
  // A full disk is no reason not to go on: without the text nobody is told who it is.
  if (::ftruncate(descriptor, 0) == 0) (void)!::pwrite(descriptor, text.data(), text.size(), 0);
}

/// The folder whose lock counts for a run.
fs::path locked_folder(const fs::path& run) {
  fs::path here = fs::canonical(run);
  const fs::path tasks = here.parent_path();
  if (tasks.filename() == "tasks" && is_run(tasks.parent_path())) return tasks.parent_path();
  return here;
}

}  // namespace

RunLock::RunLock(const fs::path& run, Extent extent)
    : folder_(extent == Extent::whole_run ? locked_folder(run) : fs::canonical(run)),
      since_(utc_now()) {
  const fs::path file = folder_ / kFile;
  constexpr int kTries = 1000;  // each but the first is a writer that went away meanwhile
  for (int n = 0;; ++n) {
    std::optional<WholeChange> whole(
        std::in_place);  // no signal between making and noting the file
    const int opened = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (opened < 0) throw std::system_error(errno, std::generic_category(), file.string());
    int locked = 0;
    do locked = ::flock(opened, LOCK_EX | LOCK_NB);
    while (locked != 0 && errno == EINTR);
    const bool held = locked != 0 && errno == EWOULDBLOCK;
    if (is_same(opened, file) || n == kTries) {  // else it went away with whoever held it
      if (held) {
        whole.reset();
        refuse_second_writer(opened, run);
      }
      descriptor_ = opened;
      file_.emplace(file);
      write_holder(opened, since_, "");
      return;
    }
    ::close(opened);
  }
}

RunLock::~RunLock() {
  // While it is held nobody else can have put another file there; an old one that was exchanged for
  // a new folder's is not at its path any more.
  if (stands()) ::unlink((folder_ / kFile).c_str());
  ::flock(descriptor_, LOCK_UN);  // for children, too, that were forked meanwhile
  ::close(descriptor_);
}

void RunLock::moved_to(const fs::path& folder) {
  folder_ = folder;
  file_.emplace(folder / kFile);
}

bool RunLock::stands() const { return is_same(descriptor_, folder_ / kFile); }

void RunLock::note(const std::string& build) const { write_holder(descriptor_, since_, build); }

std::optional<fs::path> build_beside(const fs::path& run) {
  std::error_code error;
  const fs::path here = fs::canonical(run, error);
  const int opened = ::open((here / RunLock::kFile).c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (opened < 0) return std::nullopt;
  const Holder holder = read_holder(opened);
  ::close(opened);
  const std::string& line = holder.build;
  const bool plain = line.starts_with('.') && line.ends_with(".tmp") && line.size() < 256 &&
                     line.find('/') == std::string::npos;
  if (error || !is_running(holder) || !plain || !fs::is_directory(here.parent_path() / line, error))
    return std::nullopt;
  return here.parent_path() / line;
}

std::optional<fs::path> run_around(const fs::path& path) {
  for (fs::path at = fs::weakly_canonical(fs::absolute(path)); at.has_relative_path();
       at = at.parent_path())
    if (is_run(at)) return at;
  return std::nullopt;
}

}  // namespace legwright
