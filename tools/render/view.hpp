// SPDX-License-Identifier: Apache-2.0
// How a picture is taken: its quality and its camera.
#pragma once

#include <array>

namespace legwright {

/// How much a picture may cost: `cheap` for every iteration (small shadows, no antialiasing),
/// `full` for the pictures people look at (large shadows, antialiased), `plain` for pictures that
/// are compared byte by byte (as cheap, without textures, fog and sky).
enum class RenderStyle { cheap, full, plain };

/// A camera that looks at a point: where from, in degrees, as MuJoCo's free camera counts them.
struct View {
  std::array<double, 3> lookat{};  // [m], world
  double distance = 1.0;           // [m]
  double azimuth = 90.0;           // [deg] direction of sight about z, 0 along +x
  double elevation = -15.0;        // [deg] negative looks down
};

}  // namespace legwright
