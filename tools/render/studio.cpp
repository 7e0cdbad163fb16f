// SPDX-License-Identifier: Apache-2.0
#include "tools/render/studio.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <numbers>

namespace legwright {
namespace {

// [m] extent that clipping planes go by, whatever the model's.
constexpr double kStudioSize = 1.2;
// The floor fades into this.
constexpr std::array<float, 4> kFogColour{0.965F, 0.97F, 0.975F, 1.0F};
constexpr double kFloor = 30.0;                    // [m] half its side; the fog ends long before
constexpr float kSun[3] = {-0.35F, 0.30F, -1.0F};  // seen from the camera: to the right, away, down

/// MuJoCo clears to black: beyond the edge of the floor, and above the horizon, there shall be
/// paper. So floors end only where the fog has swallowed them, and the sky is paper too.
void extend_to_paper(mjModel& model) {
  for (int g = 0; g < model.ngeom; ++g) {
    if (model.geom_type[g] != mjGEOM_PLANE) continue;
    for (int side : {0, 1}) {
      double& size = model.geom_size[3 * g + side];
      if (size > 0.0) size = kFloor;  // 0, without end, stays so
    }
  }
  for (int t = 0; t < model.ntex; ++t) {
    if (model.tex_type[t] != mjTEXTURE_SKYBOX) continue;
    const int channels = model.tex_nchannel[t];
    mjtByte* pixel = model.tex_data + model.tex_adr[t];
    for (int i = 0; i < model.tex_width[t] * model.tex_height[t]; ++i, pixel += channels)
      for (int c = 0; c < channels; ++c)
        pixel[c] =
            static_cast<mjtByte>(std::lround(255.0F * kFogColour[static_cast<std::size_t>(c)]));
  }
}

}  // namespace

ModelPointer styled_copy(const mjModel& model, int width, int height, RenderStyle style) {
  ModelPointer copy(mj_copyModel(nullptr, &model));
  if (!copy) throw std::bad_alloc();
  const bool full = style == RenderStyle::full;
  copy->nplugin = 0;  // what plugins draw is for viewers; poses are only placed, nothing else asks
  copy->vis.global.offwidth = width;
  copy->vis.global.offheight = height;
  copy->vis.global.fovy = static_cast<float>(kFieldOfView);
  copy->vis.quality.offsamples = full ? 4 : 0;
  copy->vis.quality.shadowsize = full ? 2048 : 1024;
  copy->stat.extent = kStudioSize;
  std::copy(kFogColour.begin(), kFogColour.end(), copy->vis.rgba.fog);
  std::fill_n(copy->vis.headlight.ambient, 3, 0.42F);
  std::fill_n(copy->vis.headlight.diffuse, 3, 0.26F);
  std::fill_n(copy->vis.headlight.specular, 3, 0.10F);
  copy->vis.headlight.active = 1;
  if (style != RenderStyle::full) {  // a third of a cheap frame; the eye sees it only near by
    copy->vis.quality.numslices = 20;
    copy->vis.quality.numstacks = 10;
  }
  extend_to_paper(*copy);
  return copy;
}

void set_effects(RenderStyle style, mjvScene& scene, mjvOption& option) {
  const mjtByte rich = style == RenderStyle::plain ? 0 : 1;
  scene.flags[mjRND_REFLECTION] = 0;
  scene.flags[mjRND_HAZE] = 0;
  scene.flags[mjRND_SKYBOX] = rich;
  scene.flags[mjRND_FOG] = rich;
  option.flags[mjVIS_TEXTURE] = rich;
}

double shadow_reach(const View& view, int width, int height) {
  const double half_height =
      view.distance * std::tan(0.5 * kFieldOfView * std::numbers::pi / 180.0);
  return 2.2 * half_height * std::max(1.0, static_cast<double>(width) / height);
}

void light_studio(const View& view, double reach, mjvScene& scene) {
  scene.nlight = std::min(scene.nlight, 1);  // MuJoCo puts the head light first
  const double a = view.azimuth * std::numbers::pi / 180.0;
  mjvLight sun{};
  sun.type = mjLIGHT_DIRECTIONAL;
  sun.texid = -1;
  sun.castshadow = 1;
  sun.attenuation[0] = 1.0F;
  sun.exponent = 10.0F;
  sun.cutoff = 45.0F;
  std::fill_n(sun.diffuse, 3, 0.48F);
  std::fill_n(sun.specular, 3, 0.25F);
  const double right = kSun[0], away = kSun[1];
  const double x = away * std::cos(a) + right * std::sin(a),
               y = away * std::sin(a) - right * std::cos(a);
  const double length = std::sqrt(x * x + y * y + 1.0);
  sun.dir[0] = static_cast<float>(x / length);
  sun.dir[1] = static_cast<float>(y / length);
  sun.dir[2] = static_cast<float>(-1.0 / length);
  for (std::size_t c = 0; c < 3; ++c) {  // so far off that no floor in its reach is behind it
    sun.pos[c] = static_cast<float>(view.lookat[c] - 3.0 * reach * sun.dir[c]);
  }
  scene.lights[scene.nlight++] = sun;
}

}  // namespace legwright
