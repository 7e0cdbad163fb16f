// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/studio_service.hpp"

#include <fmt/format.h>

#include <utility>

#include "mjcf/text/input_error.hpp"
#include "tools/run/robot_label.hpp"
#include "tools/studio/session_names.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// The newest session that was left behind of what is opened.
std::optional<fs::path> left_of(const KeptSessions& kept, const fs::path& origin) {
  for (const KeptSession& session : kept.left_behind())
    if (session.origin == origin.string()) return session.folder;
  return std::nullopt;
}

/// Whether two states ask for the same, however far their motions are solved.
bool same_wishes(const SessionState& a, const SessionState& b) {
  return a.problem == b.problem && a.s() == b.s() && a.frozen == b.frozen && a.lower == b.lower &&
         a.upper == b.upper && a.weights == b.weights;
}

}  // namespace

StudioService::StudioService(StudioOptions options)
    : options_(std::move(options)),
      paths_(options_.roots, {options_.examples, options_.state}),
      kept_(options_.state) {
  fs::create_directories(options_.state);
  paths_.allow_reading(options_.state);
}

StudioService::~StudioService() {
  hub_.close();
  leave();
}

/// By mutex_: whether nothing was done since the robot was opened, with what was carried over.
bool StudioService::is_untouched(const SessionSnapshot& last) const {
  const bool as_begun = !last.can_undo || (began_ && same_wishes(*began_, *last.state));
  return as_begun && last.names.empty();
}

void StudioService::leave() {
  judge_.end();  // before the lock: it notes verdicts
  const std::lock_guard lock(mutex_);
  if (workspace_) workspace_->close();  // requests that still have it may tell nothing any more
  if (workspace_ && folder_) {
    const SnapshotPointer last = workspace_->session().snapshot();
    if (is_untouched(*last) || saved_ == last->state) folder_->forget();
  }
  workspace_.reset();
  folder_.reset();
  saved_.reset();
  began_.reset();
}

void StudioService::close_bench() {
  if (!bench_) return;
  bench_->close();
  bench_.reset();
  hub_.forget("assembly");
}

bool StudioService::stands_in(const fs::path& run) const {
  const std::lock_guard lock(mutex_);
  return saved_ && saved_at_ == run && workspace_ &&
         saved_ == workspace_->session().snapshot()->state;
}

std::shared_ptr<Workspace> StudioService::workspace() const {
  const std::lock_guard lock(mutex_);
  if (!workspace_) throw InputError("nothing is open; open a robot, a task file or a run first");
  return workspace_;
}

fs::path StudioService::proposing() const {
  const std::lock_guard lock(mutex_);
  if (!opened_.proposes)
    throw InputError("nothing is proposed: no robot is open that declares no parameters");
  return opened_.origin;
}

void StudioService::open(const std::string& path) {
  const std::lock_guard opening_lock(opening_);
  const fs::path asked = paths_.to_read(path);
  const bool run = fs::is_regular_file(asked / "run.json");
  const auto left = left_of(kept_, asked);
  if (left && run)
    hub_.notice("info",
                "This takes up what was left unsaved of " + asked.filename().string() + ".");
  Opening opening = open_path(left && run ? *left : asked, paths_);
  if (!opening.taken_up.empty() && kept_.owns(opening.taken_up) &&
      KeptSessions::is_held(opening.taken_up))
    throw InputError(opening.taken_up.string() +
                     ": a studio works on this session; go on there, or end that studio first");
  const std::string note = opening.note;
  const fs::path judged = opening.judged;
  take(std::move(opening));
  if (!judged.empty()) tell_verdict_of(judged);
  if (!note.empty()) hub_.notice("info", note);
  if (left && !run)
    hub_.notice("info",
                "An unsaved session of this file is left: it is under File, Open another….");
}

/// Where it fails, nothing is open any more but an assembly on its bench, and pages are told so.
std::shared_ptr<Workspace> StudioService::make_workspace(RobotModel robot,
                                                         const SessionFolder& folder,
                                                         Opening& opening) {
  try {
    return std::make_shared<Workspace>(
        WorkspaceBegin{std::move(robot), opening.text, opening.file, folder.journal(),
                       std::move(opening.commands)},
        hub_, meshes_);
  } catch (...) {
    {
      const std::lock_guard lock(mutex_);
      opened_ = {};
      carried_.reset();
      if (bench_) {
        opened_.origin = bench_->origin();
        opened_.assembly = "";
      }
    }
    tell_opened();
    throw;
  }
}

void StudioService::take(Opening opening) {
  if (opening.assembly) {
    take_assembly(std::move(opening));
    tell_opened();
    return;
  }
  std::shared_ptr<Workspace> next;
  std::unique_ptr<SessionFolder> folder;
  if (opening.robot) {
    (void)check_fit(opening);
    const RobotModel& robot = *opening.robot;
    const fs::path& origin = opening.origin;
    opening.label = robot_label(robot.morphology.name, origin, robot.file);
    const std::string name = session_name(opening.label, origin);
    folder = kept_.begin(robot.files, origin.string(), name);
    // The session works on the copy: the file may change while somebody works.
    RobotModel copy = read_robot(folder->robot());
    copy.morphology.name = opening.label;
    if (opening.robot_file.empty()) opening.robot_file = robot.file;
    leave();  // from now on nothing of what was may be told
    hub_.forget("");
    next = make_workspace(std::move(copy), *folder, opening);
    folder->keep();
    if (!opening.taken_up.empty()) kept_.remove(opening.taken_up);
    if (!opening.of_modules) kept_.note_recent(origin, name);
    opening.robot.reset();
  }
  {
    const std::lock_guard lock(mutex_);
    if (next && opening.taken_up.empty()) began_ = next->session().snapshot()->state;
    workspace_ = std::move(next);
    folder_ = std::move(folder);
    if (!opening.of_modules) {
      close_bench();
      carried_.reset();
    }
    opened_ = std::move(opening);
  }
  tell_opened();
}

/// The page asks for the document, or for what is proposed, once it sees this.
void StudioService::tell_opened() {
  const std::lock_guard lock(mutex_);
  const bool assembles = opened_.assembly.has_value();
  Json kept = folder_ ? Json(folder_->path().string()) : Json(nullptr);
  if (assembles) {
    kept = bench_->folder().string();
    bench_->tell();
  }
  hub_.publish("opened", to_line({{"path", opened_.origin.string()},
                                  {"proposes", opened_.proposes},
                                  {"assembles", assembles},
                                  {"of_modules", opened_.of_modules},
                                  {"heard", hub_.now()},
                                  {"kept", kept}}));
}

}  // namespace legwright
