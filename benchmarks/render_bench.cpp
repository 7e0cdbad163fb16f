// SPDX-License-Identifier: Apache-2.0
// What a picture of 640 × 480 costs. Usage: render_bench SCENE.xml…
// Writes JSON to stdout: per scene and style the first frame, which sets OpenGL up, then the median
// of 50 frames and the slowest, in wall time and in CPU time of all threads; and the median of
// writing a PNG. Wall times are only worth something on a machine that does nothing else: the load
// is told too.
#include <time.h>

#include <cstdio>
#include <cstdlib>
#include <exception>

#include "benchmarks/timing.hpp"
#include "tools/image/png.hpp"
#include "tools/render/poses.hpp"
#include "tools/simulate/mujoco_host.hpp"

namespace {

using namespace legwright;
using Json = nlohmann::ordered_json;

constexpr int kFrames = 50, kWidth = 640, kHeight = 480;

double milliseconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

struct Samples {
  std::vector<double> wall, cpu;

  template <class Work>
  void add(const Work& work) {
    const double w = milliseconds(CLOCK_MONOTONIC), c = milliseconds(CLOCK_PROCESS_CPUTIME_ID);
    work();
    wall.push_back(milliseconds(CLOCK_MONOTONIC) - w);
    cpu.push_back(milliseconds(CLOCK_PROCESS_CPUTIME_ID) - c);
  }
  Json json() const {
    const auto median = [](std::vector<double> sorted) {
      std::sort(sorted.begin(), sorted.end());
      return sorted[sorted.size() / 2];
    };
    return {{"median_ms", median(wall)},
            {"least_ms", *std::min_element(wall.begin(), wall.end())},
            {"most_ms", *std::max_element(wall.begin(), wall.end())},
            {"median_cpu_ms", median(cpu)}};
  }
};

Json bench_style(const GlContext& context, const mjModel& model, RenderStyle style) {
  Samples first, frames, png, ids;
  std::vector<double> pose = start_pose(model);
  const View view = frame_robot(model, {pose}, 215.0, -16.0, static_cast<double>(kWidth) / kHeight);
  Image image;
  std::unique_ptr<Renderer> renderer;
  first.add([&] {
    renderer = std::make_unique<Renderer>(context, model, kWidth, kHeight, style);
    image = renderer->render(pose, view);
  });
  for (int i = 0; i < kFrames; ++i) {
    pose.back() += 0.01;  // no two frames alike
    frames.add([&] { image = renderer->render(pose, view); });
    png.add([&] { (void)encode_png(image); });
    if (style != RenderStyle::full) ids.add([&] { (void)renderer->ids(pose, view); });
  }
  Json result{{"first_ms", first.wall[0]}, {"frame", frames.json()}, {"png", png.json()}};
  if (style != RenderStyle::full) result["ids"] = ids.json();
  return result;
}

Json measure(int count, char** scenes) {
  double load = 0.0;
  if (::getloadavg(&load, 1) != 1) load = -1.0;
  Json document{{"schema", "legwright/render_bench"}, {"version", 1}};
  document["machine"] = legwright::bench::machine();
  document["load_average"] = load;
  const GlContext context;
  document["opengl"] = context.platform() + ": " + context.description();
  for (int i = 0; i < count; ++i) {
    const ModelPointer model = load_drawn_scene(scenes[i]);
    document["scenes"].push_back({{"scene", scenes[i]},
                                  {"geoms", model->ngeom},
                                  {"cheap", bench_style(context, *model, RenderStyle::cheap)},
                                  {"full", bench_style(context, *model, RenderStyle::full)}});
  }
  return document;
}

}  // namespace

int main(int count, char** words) {
  if (count < 2) {
    std::fprintf(stderr, "usage: render_bench SCENE.xml...\n");
    return 2;
  }
  try {
    pin_rasteriser();
    load_gait_plugin();
    std::printf("%s\n", measure(count - 1, words + 1).dump(2).c_str());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "render_bench: %s\n", error.what());
    return 3;
  }
}
