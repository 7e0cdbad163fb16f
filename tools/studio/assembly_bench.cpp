// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/assembly_bench.hpp"

#include <fmt/format.h>

#include <utility>

#include "mjcf/assembly/build_robot.hpp"
#include "mjcf/text/input_error.hpp"
#include "tools/files/io_error.hpp"
#include "tools/modules/assembly_text.hpp"
#include "tools/studio/assembly_view.hpp"

namespace legwright {

namespace fs = std::filesystem;

AssemblyBench::AssemblyBench(AssemblyDesk desk, fs::path origin, const KeptSessions& kept,
                             EventHub& hub, MeshStore& meshes)
    : desk_(std::move(desk)), origin_(std::move(origin)), kept_(kept), hub_(hub), meshes_(meshes) {
  drawn_ = picture(desk_);
  const Assembly& now = desk_.now();
  folder_ = kept.begin_assembly(assembly_text(now), origin_.string(), now.name);
}

fs::path AssemblyBench::origin() const {
  const std::lock_guard lock(mutex_);
  return origin_;
}

fs::path AssemblyBench::folder() const {
  const std::lock_guard lock(mutex_);
  return folder_->path();
}

void AssemblyBench::keep() {
  const std::lock_guard lock(mutex_);
  folder_->keep();
}

void AssemblyBench::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
}

void AssemblyBench::check_open() const {
  if (closed_)
    throw InputError(
        "another page has opened something else, so this was not done; look at what is open now");
}

Json AssemblyBench::picture(const AssemblyDesk& desk) const {
  Json out = assembly_json(desk.now(), meshes_);
  out["can_undo"] = desk.can_undo();
  out["can_redo"] = desk.can_redo();
  out["path"] = origin_.string();
  return out;
}

Json AssemblyBench::obey(const Json& command) {
  const std::lock_guard lock(mutex_);
  check_open();
  AssemblyDesk next = desk_;
  const std::string item = next.obey(command);
  Json drawn = picture(next);
  // What is answered is kept, and what cannot be kept did not happen.
  write_file(folder_->assembly(), assembly_text(next.now()), Durability::process);
  folder_->keep();
  desk_ = std::move(next);
  drawn_ = std::move(drawn);
  drawn_["revision"] = ++revision_;
  hub_.publish("assembly", to_line(drawn_));
  return {{"item", item}, {"revision", revision_}};
}

void AssemblyBench::tell() {
  const std::lock_guard lock(mutex_);
  drawn_["revision"] = revision_;
  hub_.publish("assembly", to_line(drawn_));
}

RobotModel AssemblyBench::build(std::vector<std::string>& notes) {
  const std::lock_guard lock(mutex_);
  const fs::path folder = folder_->path() / "built", file = folder / "robot.xml";
  const Assembly& assembly = desk_.now();
  if (assembly.limbs.empty())
    throw InputError("the robot has no limb yet; put a servo on the trunk, which begins one");
  const BuiltRobot built = build_robot(assembly, assembly.name + ".xml");
  fs::create_directories(folder);
  write_file(file, built.xml, Durability::process);
  notes = built.notes;
  if (!built.pose.empty()) notes.push_back(built.pose);
  RobotModel robot = read_robot(file);
  robot.morphology.name = assembly.name;
  return robot;
}

void AssemblyBench::save(const fs::path& file, bool replace) {
  const std::lock_guard lock(mutex_);
  check_open();
  if (file.extension() != ".toml")
    throw InputError(file.string() + ": an assembly's file ends in .toml");
  if (!replace && fs::exists(file))
    throw IoError(file.string() + ": is there already; name another file");
  fs::create_directories(file.parent_path());
  write_file(file, assembly_text(desk_.now()));
  origin_ = file;
  drawn_["path"] = file.string();
  hub_.publish("assembly", to_line(drawn_));
  // What is done from now on is of that file; what was is in it.
  auto next = kept_.begin_assembly(assembly_text(desk_.now()), origin_.string(), desk_.now().name);
  folder_->forget();
  folder_ = std::move(next);
}

}  // namespace legwright
