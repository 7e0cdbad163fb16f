// SPDX-License-Identifier: Apache-2.0
#include "tools/render/portrait.hpp"

#include <algorithm>

#include "tools/image/png.hpp"
#include "tools/render/poses.hpp"

namespace legwright {
namespace {

constexpr int kPortraitWidth = 960, kPortraitHeight = 720;

}  // namespace

void draw_portrait(const std::filesystem::path& scene, const std::filesystem::path& png,
                   const std::string& origin) {
  const GlContext context;
  const ModelPointer model = load_drawn_scene(scene);
  const int key = std::max(mj_name2id(model.get(), mjOBJ_KEY, "home"), 0);
  const double* pose = model->nkey > 0
                           ? model->key_qpos + static_cast<std::ptrdiff_t>(key) * model->nq
                           : model->qpos0;
  const std::vector<double> qpos(pose, pose + model->nq);
  const View view = frame_robot(*model, {qpos}, kObliqueAzimuth, kObliqueElevation,
                                static_cast<double>(kPortraitWidth) / kPortraitHeight);
  Renderer renderer(context, *model, kPortraitWidth, kPortraitHeight, RenderStyle::full);
  write_png(png, renderer.render(qpos, view), origin);
}

}  // namespace legwright
