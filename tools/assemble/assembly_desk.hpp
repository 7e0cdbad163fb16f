// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "mjcf/assembly/robot_assembly.hpp"
#include "tools/files/json_file.hpp"
#include "tools/modules/module_library.hpp"

namespace legwright {

/// An assembly that is being made: commands change it, and can be undone. It may have no limb yet;
/// in all else it is at any time one that its file could say.
class AssemblyDesk {
 public:
  /// A trunk alone. @param library must live longer
  explicit AssemblyDesk(const ModuleLibrary& library);
  /// Throws InputError as parse_assembly(). @param library must live longer
  AssemblyDesk(const std::string& text, const std::filesystem::path& file,
               const ModuleLibrary& library);

  const Assembly& now() const { return *history_[at_]; }
  bool can_undo() const { return at_ > 0; }
  bool can_redo() const { return at_ + 1 < history_.size(); }

  /// Obeys `{"do": …}`: `put {module, spot}`, `copy {item, spot}` of a limb, `set {item, key,
  /// value, goes_on}`, `remove {item}`, `undo`, `redo`. With `goes_on` it is one step with the one
  /// before, where that set the same; what changes nothing is no step. Throws InputError for what
  /// is no command, or would make no assembly; nothing changes then.
  /// @return the item that was put or changed, empty where there is none
  std::string obey(const Json& command);

 private:
  void take(const Assembly& next, const std::string& set, bool goes_on);

  const ModuleLibrary* library_;
  std::vector<std::shared_ptr<const Assembly>> history_;
  std::size_t at_ = 0;
  std::string last_set_;  // item and key of the last step, where more of it may come
};

}  // namespace legwright
