// SPDX-License-Identifier: Apache-2.0
#include "mjcf/urdf/collada.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/fuzz/promises.hpp"
#include "tests/fuzz/targets.hpp"

namespace legwright::test {
namespace {

/// Whoever draws a mesh trusts it.
void promise_mesh(const DrawnMesh& mesh) {
  promise(!mesh.faces.empty() && mesh.faces.size() % 3 == 0, "a mesh without triangles");
  promise(mesh.vertices.size() % 3 == 0, "a vertex without three coordinates");
  promise(std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                      [](float x) { return std::isfinite(x); }),
          "a vertex nowhere");
  promise(std::all_of(mesh.faces.begin(), mesh.faces.end(),
                      [&](std::uint32_t vertex) { return vertex < mesh.vertices.size() / 3; }),
          "a triangle of vertices that are not there");
}

}  // namespace

bool fuzz_collada(std::string_view text) {
  const std::filesystem::path file = "/nowhere/part.dae";
  return accepted(file, [&] {
    const DrawnMesh mesh = read_collada(std::string(text), file);
    promise_mesh(mesh);
    const DrawnMesh again = read_collada(std::string(text), file);
    promise(again.vertices == mesh.vertices && again.faces == mesh.faces,
            "a file that is another mesh each time");
    promise_mesh(simpler_mesh(mesh, 1.0));
  });
}

}  // namespace legwright::test
