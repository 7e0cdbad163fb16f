// SPDX-License-Identifier: Apache-2.0
// Draws the toy scene in a process of its own: gl_probe PNG. Prints the platform; exits 3 with
// the reason where there is no OpenGL.
#include <cstdio>
#include <filesystem>

#include "tests/tools/render/toy_scene.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/image/png.hpp"
#include "tools/render/poses.hpp"

int main(int count, char** words) {
  using namespace legwright;
  if (count != 2) return 2;
  try {
    const std::filesystem::path png = words[1];
    write_file(png.parent_path() / "probe.xml", kToyScene);
    const ModelPointer model = load_drawn_scene(png.parent_path() / "probe.xml");
    std::string platform;
    for (int turn = 0; turn < 2; ++turn) {  // a second context of the process works like the first
      const GlContext context;
      platform = context.platform();
      Renderer renderer(context, *model, 320, 240, RenderStyle::cheap);
      const auto pose = start_pose(*model);
      const View view = frame_robot(*model, {pose}, 120, -15, 320.0 / 240);
      write_png(png, renderer.render(pose, view));
    }
    std::printf("%s\n", platform.c_str());
    return 0;
  } catch (const GlError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
