// SPDX-License-Identifier: Apache-2.0
#include "tools/assemble/assembly_desk.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

#include "mjcf/text/input_error.hpp"
#include "tools/assemble/assembly_edits.hpp"
#include "tools/assemble/assembly_item.hpp"
#include "tools/assemble/assembly_spots.hpp"
#include "tools/files/json_values.hpp"
#include "tools/modules/assembly_file.hpp"
#include "tools/modules/assembly_text.hpp"

namespace legwright {
namespace {

constexpr std::size_t kMostSteps = 1000;
constexpr const char* kNewAssembly = R"(name = "robot"
[trunk]
size = [0.2, 0.09, 0.04]
mass = 0.25
)";

/// The smallest ball of the library, else its first foot. Throws InputError where it has none.
const Module& first_foot(const ModuleLibrary& library) {
  const Module* found = nullptr;
  for (const ModuleFile& file : library.modules()) {
    const Module& module = file.module;
    if (module.kind != ModuleKind::foot) continue;
    const auto is_ball = [](const Module& foot) {
      return foot.outline.size() == 1 && foot.outline[0].type == OutlineShape::Type::sphere;
    };
    if (!found || (is_ball(module) && !is_ball(*found)) ||
        (is_ball(module) && module.outline[0].size.x() < found->outline[0].size.x()))
      found = &module;
  }
  if (!found) throw InputError("the library has no foot; a module of the kind foot is needed");
  return *found;
}

constexpr const char* kNoFile = "assembly.toml";

/// What is wrong, a line each, without the places in a file that nobody has.
std::string words_without_places(const std::string& told) {
  std::istringstream in(told);
  std::string out;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(kNoFile)) line.erase(0, line.find(": ") + 2);
    out += (out.empty() ? "" : "\n") + line;
  }
  return out;
}

/// The assembly of a text as its file would be read.
Assembly checked(const std::string& text, const ModuleLibrary& library) {
  try {
    return parse_assembly(text, kNoFile, library, AssemblyState::draft);
  } catch (const InputError& error) {
    throw InputError(words_without_places(error.what()));
  }
}

}  // namespace

AssemblyDesk::AssemblyDesk(const ModuleLibrary& library)
    : AssemblyDesk(kNewAssembly, kNoFile, library) {}

AssemblyDesk::AssemblyDesk(const std::string& text, const std::filesystem::path& file,
                           const ModuleLibrary& library)
    : library_(&library),
      history_{std::make_shared<const Assembly>(
          parse_assembly(text, file, library, AssemblyState::draft))} {}

void AssemblyDesk::take(const Assembly& next, const std::string& set, bool goes_on) {
  if (!goes_on) last_set_.clear();
  const bool same_step = !set.empty() && set == last_set_;
  const std::string text = assembly_text(next);
  if (text == assembly_text(now())) return;
  if (same_step && text == assembly_text(*history_[at_ - 1])) {  // a hand that came back
    history_.pop_back();
    --at_;
    last_set_.clear();
    return;
  }
  auto kept = std::make_shared<const Assembly>(checked(text, *library_));
  history_.resize(at_ + 1);
  if (same_step)
    history_.back() = std::move(kept);
  else
    history_.push_back(std::move(kept));
  if (history_.size() > kMostSteps) history_.erase(history_.begin());
  at_ = history_.size() - 1;
  last_set_ = set;
}

std::string AssemblyDesk::obey(const Json& command) {
  const auto kind = needed<std::string>(command, "do");
  if (kind == "undo" || kind == "redo") {
    if (kind == "undo" && can_undo()) --at_;
    if (kind == "redo" && can_redo()) ++at_;
    last_set_.clear();
    return {};
  }
  Assembly next = now();
  const auto item = [&] { return item_named(needed<std::string>(command, "item"), next); };
  std::string changed, set;
  if (kind == "put") {
    const Module& module = library_->find(needed<std::string>(command, "module")).module;
    changed = to_string(
        put_module(next, needed<std::string>(command, "spot"), module, first_foot(*library_)));
  } else if (kind == "copy") {
    const AssemblyItem limb = item();
    if (limb.kind == AssemblyItem::Kind::trunk || limb.kind == AssemblyItem::Kind::part)
      throw InputError("'copy' is of limbs; " + words_of(limb, next) + " is none");
    changed = to_string(put_copy(next, needed<std::string>(command, "spot"), limb.index));
  } else if (kind == "set") {
    const AssemblyItem one = item();
    const auto key = needed<std::string>(command, "key");
    set_value(next, one, key, command.contains("value") ? command["value"] : Json(nullptr));
    changed = to_string(one);
    set = changed + " " + key;
  } else if (kind == "remove") {
    remove_item(next, item());
  } else {
    throw InputError("'" + kind +
                     "' is no command of an assembly; expected put, copy, set, remove, undo or "
                     "redo");
  }
  take(next, set, given_or(command, "goes_on", false));
  return changed;
}

}  // namespace legwright
