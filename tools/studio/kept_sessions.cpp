// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/kept_sessions.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <system_error>

#include "tools/files/atomic_file.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/parse_json.hpp"
#include "tools/run/robot_folder.hpp"
#include "tools/studio/session_names.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kRecentKept = 12, kSessionsKept = 20;

/// Holds a folder's lock, or −1 where another process does. @param waits until it can be held
int lock_of(const fs::path& folder, bool waits = false) {
  const fs::path file = folder / "lock";
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (descriptor < 0)
    throw std::system_error(errno, std::generic_category(), "cannot lock " + file.string());
  if (::flock(descriptor, waits ? LOCK_EX : LOCK_EX | LOCK_NB) == 0) return descriptor;
  ::close(descriptor);
  return -1;
}

/// The lock of a folder, held as long as this lives.
class FolderLock {
 public:
  FolderLock(const fs::path& folder, bool waits) : descriptor_(lock_of(folder, waits)) {}
  ~FolderLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  bool held() const { return descriptor_ >= 0; }

 private:
  int descriptor_;
};

/// Takes a folder away that no process holds.
void remove_unheld(const fs::path& folder) {
  std::error_code none;
  if (!fs::is_directory(folder, none)) return;
  try {
    const FolderLock lock(folder, false);
    if (lock.held()) fs::remove_all(folder, none);
  } catch (const std::system_error&) {
    return;  // somebody else's
  }
}

/// Empty where there is none, or something else: somebody's edit.
std::string text_in(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// A folder of a new name that sorts by time.
fs::path new_folder(const fs::path& above, const std::string& name) {
  fs::create_directories(above);
  const auto now = std::chrono::system_clock::now();
  const std::string time =
      fmt::format("{:%Y%m%d-%H%M%S}", fmt::localtime(std::chrono::system_clock::to_time_t(now)));
  for (int k = 0;; ++k) {
    fs::path path = above / fmt::format("{}-{}-{}", time, plain_name(name), k);
    if (fs::create_directory(path)) return path;
  }
}

}  // namespace

fs::path studio_state_folder() {
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state && *state == '/') return fs::path(state) / "legwright" / "studio";
  const char* home = std::getenv("HOME");
  if (!home || *home != '/')
    throw IoError(
        "neither XDG_STATE_HOME nor HOME names a folder; set one of them: sessions are "
        "kept there as they go");
  return fs::path(home) / ".local" / "state" / "legwright" / "studio";
}

SessionFolder::~SessionFolder() {
  std::error_code ignored;
  if (!kept_) fs::remove_all(path_, ignored);
  ::close(lock_);
}

std::unique_ptr<SessionFolder> KeptSessions::new_session(const std::string& origin,
                                                         const std::string& name) const {
  const fs::path folder = new_folder(root_ / "sessions", name);
  const int lock = lock_of(folder);
  auto out = std::make_unique<SessionFolder>(folder, lock);
  write_json(folder / "about.json",
             {{"schema", "legwright/studio-session"},
              {"version", 1},
              {"origin", origin},
              {"name", name},
              {"begun", clock_words()}},
             Durability::process);
  return out;
}

std::unique_ptr<SessionFolder> KeptSessions::begin(const RobotFiles& robot,
                                                   const std::string& origin,
                                                   const std::string& name) const {
  auto out = new_session(origin, name);
  const fs::path folder = out->robot().parent_path();
  fs::create_directory(folder);
  write_robot_files(folder, robot, Durability::process);
  return out;
}

std::unique_ptr<SessionFolder> KeptSessions::begin_assembly(const std::string& text,
                                                            const std::string& origin,
                                                            const std::string& name) const {
  auto out = new_session(origin, name);
  write_file(out->assembly(), text, Durability::process);
  return out;
}

std::unique_ptr<SessionFolder> KeptSessions::begin_work(const std::string& name) const {
  const fs::path above = root_ / "work";
  fs::create_directories(above);
  const FolderLock alone(above, true);  // else a folder might go before it is locked
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(above, none)) remove_unheld(entry.path());
  const fs::path folder = new_folder(above, name);
  return std::make_unique<SessionFolder>(folder, lock_of(folder));
}

std::optional<KeptSession> kept_session(const fs::path& folder) {
  std::error_code none;
  if (!fs::is_regular_file(folder / "about.json", none) ||
      !(fs::is_regular_file(folder / "session.jsonl", none) ||
        fs::is_regular_file(folder / kKeptAssembly, none)))
    return std::nullopt;
  Json about = Json::object();  // where it is damaged, robot and journal may be whole
  try {
    about = parse_json(read_file(folder / "about.json"));
  } catch (const std::system_error&) {
    return std::nullopt;  // not to be read, or gone meanwhile
  } catch (const IoError&) {
    about = Json::object();
  }
  std::string name = text_in(about, "name");
  if (name.empty()) name = folder.filename().string();
  return KeptSession{folder, text_in(about, "origin"), std::move(name), text_in(about, "begun")};
}

std::vector<KeptSession> KeptSessions::left_behind() const {
  std::vector<fs::path> folders;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(root_ / "sessions", none))
    folders.push_back(entry.path());
  std::sort(folders.rbegin(), folders.rend());
  std::vector<KeptSession> out;
  for (const fs::path& folder : folders) {
    const auto session = kept_session(folder);
    if (!session) continue;
    if (is_held(folder)) continue;
    if (out.size() < kSessionsKept)
      out.push_back(*session);
    else
      remove_unheld(folder);
  }
  return out;
}

bool KeptSessions::is_held(const fs::path& folder) {
  try {
    return !FolderLock(folder, false).held();
  } catch (const std::system_error&) {
    return true;  // another user's
  }
}

bool KeptSessions::owns(const fs::path& folder) const {
  std::error_code none;
  return fs::equivalent(folder.parent_path(), root_ / "sessions", none);
}

void KeptSessions::remove(const fs::path& folder) const {
  std::error_code ignored;
  if (owns(folder)) fs::remove_all(folder, ignored);
}

fs::path KeptSessions::new_robot_folder() const { return new_folder(root_ / "robots", "dropped"); }

void KeptSessions::note_recent(const fs::path& path, const std::string& words) const {
  const std::lock_guard lock(recent_mutex_);
  Json kept = Json::array({{{"path", path.string()}, {"words", words}, {"opened", clock_words()}}});
  for (const Json& one : recent())
    if (one["path"] != path.string() && kept.size() < kRecentKept) kept.push_back(one);
  fs::create_directories(root_);
  write_json(root_ / "recent.json", kept, Durability::process);
}

Json KeptSessions::recent() const {
  Json out = Json::array();
  std::error_code none;
  if (!fs::is_regular_file(root_ / "recent.json", none)) return out;
  const Json kept = parse_json(read_file(root_ / "recent.json"));
  if (!kept.is_array()) return out;  // somebody's edit: nothing of worth is lost
  for (const Json& one : kept)
    if (one.is_object() && one.contains("path") && one["path"].is_string() &&
        fs::exists(one["path"].get<std::string>(), none))
      out.push_back({{"path", one["path"]},
                     {"words", text_in(one, "words")},
                     {"opened", text_in(one, "opened")}});
  return out;
}

}  // namespace legwright
