// SPDX-License-Identifier: Apache-2.0
// Makes the stored pictures anew. Usage:
//   golden_tool --write            draws them from the stored scenes and poses
//   golden_tool --adopt RUN NAME   takes scene and poses of NAME from a run; then --write
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/golden/golden.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/image/png.hpp"

namespace {

/// Whether the file had these bytes already, which `write` writes.
template <typename Write>
bool same_after(const std::filesystem::path& file, const Write& write) {
  const std::string before = std::filesystem::exists(file) ? legwright::read_file(file) : "";
  write();
  return legwright::read_file(file) == before;
}

void write_all() {
  using namespace legwright;
  const GlContext context;
  bool same = true;
  for (const std::string& name : golden::kRobots) {
    const golden::Robot robot = golden::read_robot(name);
    Renderer renderer(context, *robot.model, golden::kWidth, golden::kHeight, RenderStyle::plain);
    for (const auto& pose : robot.poses) {
      const std::filesystem::path ids = robot.id_file(pose), colours = robot.colour_file(pose);
      same &= same_after(ids, [&] { write_id_png(ids, renderer.ids(pose.qpos, robot.view)); });
      same &=
          same_after(colours, [&] { write_png(colours, renderer.render(pose.qpos, robot.view)); });
    }
    std::printf("%s: %zu poses\n", name.c_str(), robot.poses.size());
  }
  golden::write_versions(golden::versions_here(context), same);
}

}  // namespace

int main(int count, char** words) {
  const std::vector<std::string> given(words + 1, words + count);
  try {
    if (given.size() == 3 && given[0] == "--adopt") {
      legwright::golden::adopt(given[1], given[2]);
      return 0;
    }
    if (given.size() == 1 && given[0] == "--write") {
      write_all();
      return 0;
    }
    std::fprintf(stderr, "usage: golden_tool --write | --adopt RUN NAME\n");
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "golden_tool: %s\n", error.what());
    return 3;
  }
}
