// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tools/files/json_file.hpp"
#include "tools/simulate/scene.hpp"

namespace legwright {

/// A scene under the name that a page shows it by.
struct NamedScene {
  std::string name;
  Scene scene;
};

/// Scenes as the viewer of tools/studio/page plays them: an array of {name, design, motion}, meshes
/// included. Surroundings that stand on the floor are drawn; meshes of all designs together have
/// some `most_triangles`, whichever robot that is.
Json viewed_scenes_json(const std::vector<NamedScene>& scenes, int most_triangles = 24'000);

}  // namespace legwright
