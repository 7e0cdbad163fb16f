// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tools/files/atomic_file.hpp"
#include "tools/render/gl_context.hpp"
#include "tools/render/poses.hpp"

namespace legwright {

/// A robot of a body and two legs over a floor; starts at keyframe "gait".
inline constexpr const char* kToyScene = R"(<mujoco model="toy">
  <worldbody>
    <geom name="floor" type="plane" size="0 0 0.1" rgba="0.8 0.8 0.8 1"/>
    <body name="trunk" pos="0 0 0.3">
      <freejoint name="root"/>
      <geom type="box" size="0.1 0.05 0.03" rgba="0.9 0.5 0.2 1"/>
      <body pos="0 0.06 0">
        <joint name="left" axis="0 1 0"/>
        <geom type="capsule" fromto="0 0 0 0 0 -0.25" size="0.015" rgba="0.2 0.4 0.8 1"/>
      </body>
      <body pos="0 -0.06 0">
        <joint name="right" axis="0 1 0"/>
        <geom type="capsule" fromto="0 0 0 0 0 -0.25" size="0.015" rgba="0.2 0.4 0.8 1"/>
      </body>
    </body>
  </worldbody>
  <keyframe><key name="gait" qpos="0 0 0.28 1 0 0 0 0.2 -0.2"/></keyframe>
</mujoco>)";

/// That robot, compiled.
inline ModelPointer toy_model() {
  const auto file = std::filesystem::path(testing::TempDir()) / "toy_scene.xml";
  write_file(file, kToyScene);
  return load_drawn_scene(file);
}

/// Empty where OpenGL works, else why not.
inline std::string why_no_gl() {
  try {
    const GlContext context;
    return "";
  } catch (const GlError& error) {
    return error.what();
  }
}

/// For the first line of a test that draws: skips it, loudly, on a machine without OSMesa.
#define LEGWRIGHT_NEEDS_GL()                                                         \
  if (const std::string why = why_no_gl(); !why.empty()) {                           \
    GTEST_SKIP() << "NOT TESTED, pictures cannot be drawn on this machine: " << why; \
  }

}  // namespace legwright
