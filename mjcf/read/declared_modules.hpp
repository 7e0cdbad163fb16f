// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <string_view>
#include <vector>

namespace legwright {

/// A <text> that declares a module is called so, and then like the body or geom that it is.
inline constexpr std::string_view kModulePrefix = "legwright_module/";

/// A module that a robot was built of, as its file declares it.
struct DeclaredModule {
  std::string of;          // its body, or of a foot the first of its geoms
  std::string kind;        // "servo", "trunk"
  std::vector<int> geoms;  // of its outline
  int body = 0;            // that they are on

  bool is_trunk() const { return kind == "trunk"; }
};

/// Those of a model, in the order of its texts; none of robots that were not built of modules. What
/// names no body or geom of the model is left out.
std::vector<DeclaredModule> declared_modules(const mjModel& model);

}  // namespace legwright
