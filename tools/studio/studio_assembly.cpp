// SPDX-License-Identifier: Apache-2.0
// Answers about robots that are assembled of modules.
#include <optional>
#include <utility>
#include <vector>

#include "mjcf/text/input_error.hpp"
#include "tools/files/json_values.hpp"
#include "tools/studio/assembly_view.hpp"
#include "tools/studio/studio_service.hpp"

namespace legwright {

namespace {

namespace fs = std::filesystem;

/// The robot with a first task. Throws InputError that names no file: nobody has one yet.
Opening first_opening(RobotModel robot) {
  const fs::path file = robot.file;
  try {
    return open_robot(std::move(robot), file);
  } catch (const InputError& error) {
    throw InputError(error.message());
  }
}

}  // namespace

const ModuleLibrary& StudioService::library() {
  const std::lock_guard lock(mutex_);
  if (!library_) library_ = std::make_unique<ModuleLibrary>(library_with(options_.modules));
  return *library_;
}

std::shared_ptr<AssemblyBench> StudioService::bench() const {
  const std::lock_guard lock(mutex_);
  if (!bench_)
    throw InputError("no assembly is open; open one, or begin a new one, on the first page");
  return bench_;
}

/// Puts an assembly on the bench, in the place of all that is open.
void StudioService::take_assembly(Opening opening) {
  AssemblyDesk desk = opening.assembly->empty()
                          ? AssemblyDesk(library())
                          : AssemblyDesk(*opening.assembly, opening.file, library());
  const std::string name = desk.now().name;
  const bool is_kept = !opening.taken_up.empty();
  auto next = std::make_shared<AssemblyBench>(
      std::move(desk), opening.origin == opening.taken_up ? fs::path() : opening.origin, kept_,
      hub_, meshes_);
  if (is_kept) next->keep();
  leave();
  {
    const std::lock_guard lock(mutex_);
    close_bench();
  }
  hub_.forget("");
  if (is_kept)
    kept_.remove(opening.taken_up);
  else if (!opening.origin.empty())
    kept_.note_recent(opening.origin, name);
  opening.origin = next->origin();
  const std::lock_guard lock(mutex_);
  bench_ = std::move(next);
  carried_.reset();
  opened_ = std::move(opening);
}

void StudioService::open_new_assembly() {
  const std::lock_guard opening_lock(opening_);
  Opening opening;
  opening.assembly = "";
  take(std::move(opening));
}

Json StudioService::get_modules(const StudioRequest&) { return palette_json(library()); }

Json StudioService::get_module(const StudioRequest& request) {
  const auto name = request.query.find("name");
  if (name == request.query.end()) throw InputError("'name' is missing; GET /api/modules has them");
  return module_picture(library().find(name->second).module, meshes_);
}

Json StudioService::post_assembly(const StudioRequest& request) {
  return bench()->obey(request.body);
}

/// The robot as it stands, opened with a first task; the assembly stays on the bench.
Json StudioService::post_build(const StudioRequest&) {
  const std::lock_guard opening_lock(opening_);  // first: another page may open something else
  const auto assembly = bench();
  std::vector<std::string> notes;
  Opening opening = first_opening(assembly->build(notes));
  opening.origin = assembly->origin();
  opening.of_modules = true;
  std::optional<CarriedDesign> before;
  {
    const std::lock_guard lock(mutex_);
    if (workspace_ && opened_.of_modules)  // built again, as by a second page
      carried_ = carried_of(*workspace_->session().snapshot()->state, first_text_);
    first_text_ = opening.text;
    before = carried_;
  }
  const std::string carried = before ? carry_over(*before, opening) : "";
  take(std::move(opening));
  for (const std::string& note : notes) hub_.notice("info", note);
  if (!carried.empty()) hub_.notice("info", carried);
  return {{"notes", notes}, {"carried", carried}};
}

/// From the robot that was built of it back to the assembly.
Json StudioService::post_bench(const StudioRequest&) {
  const std::lock_guard opening_lock(opening_);  // as above
  const auto assembly = bench();
  const bool is_left = [this] {
    const std::lock_guard lock(mutex_);
    if (!workspace_) return false;
    const SnapshotPointer last = workspace_->session().snapshot();
    carried_ = carried_of(*last->state, first_text_);
    return !is_untouched(*last);
  }();
  leave();
  hub_.forget("");
  {
    const std::lock_guard lock(mutex_);
    opened_ = {};
    opened_.origin = assembly->origin();
    opened_.assembly = "";
  }
  tell_opened();
  if (is_left)
    hub_.notice(
        "info",
        "\"Build and design\" takes over what was designed, as far as the robot still has it. What "
        "was not saved is kept, too, under \"Not saved\" on the first page.");
  return Json::object();
}

Json StudioService::post_assembly_save(const StudioRequest& request) {
  const auto path = paths_.to_write(needed<std::string>(request.body, "path"));
  const auto assembly = bench();
  assembly->save(path, given_or(request.body, "force", false));
  kept_.note_recent(path, path.stem().string());
  return {{"path", path.string()}};
}

}  // namespace legwright
