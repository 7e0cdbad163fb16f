// SPDX-License-Identifier: Apache-2.0
#include "tools/render/iteration_painter.hpp"

#include <vector>

#include "tools/image/png.hpp"
#include "tools/render/poses.hpp"
#include "tools/run/judged_sums.hpp"

namespace legwright {
namespace {

constexpr double kMargin = 0.22;  // room to grow in

}  // namespace

IterationPainter::IterationPainter(const std::filesystem::path& first_scene) {
  const ModelPointer model = load_drawn_scene(first_scene);
  // The robot at rest too: its gait may crouch or turn, and later bodies stand otherwise.
  const std::vector<double> rest(model->qpos0, model->qpos0 + model->nq);
  view_ = frame_robot(*model, {start_pose(*model), rest}, kObliqueAzimuth, kObliqueElevation,
                      static_cast<double>(kWidth) / kHeight, kMargin);
}

void IterationPainter::paint(const std::filesystem::path& scene,
                             const std::filesystem::path& png) const {
  write_png(png, draw(scene), origin_text(sum_of_scene(scene.parent_path())));
}

Image IterationPainter::draw(const std::filesystem::path& scene) const {
  const ModelPointer model = load_drawn_scene(scene);
  Renderer renderer(context_, *model, kWidth, kHeight, RenderStyle::cheap);
  return renderer.render(start_pose(*model), view_);
}

}  // namespace legwright
