// SPDX-License-Identifier: Apache-2.0
#include "tools/render/renderer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "tools/render/scene_parts.hpp"

namespace legwright {
namespace {

constexpr int kSceneGeoms = 4000;
constexpr int kTextWidth = 1536,
              kTextHeight = 128;  // canvas of one line of text, twice its final size

constexpr double kStudioSize =
    1.2;  // [m] extent that shadows and clipping planes go by, whatever the model's
constexpr std::array<float, 4> kPaper{0.965F, 0.97F, 0.975F, 1.0F};  // the floor fades into this
constexpr double kFloorStretch = 10.0;  // times its size in the scene; 0, without end, stays so
constexpr float kSun[3] = {-0.35F, 0.30F, -1.0F};  // seen from the camera: to the right, away, down

/// MuJoCo clears to black: beyond the edge of the floor, and above the horizon, there shall be paper. So
/// floors end only where the fog has swallowed them, and the sky is paper too.
void extend_to_paper(mjModel& model) {
  for (int g = 0; g < model.ngeom; ++g) {
    if (model.geom_type[g] != mjGEOM_PLANE) continue;
    for (int side : {0, 1}) model.geom_size[3 * g + side] *= kFloorStretch;
  }
  for (int t = 0; t < model.ntex; ++t) {
    if (model.tex_type[t] != mjTEXTURE_SKYBOX) continue;
    const int channels = model.tex_nchannel[t];
    mjtByte* pixel = model.tex_data + model.tex_adr[t];
    for (int i = 0; i < model.tex_width[t] * model.tex_height[t]; ++i, pixel += channels)
      for (int c = 0; c < channels; ++c)
        pixel[c] = static_cast<mjtByte>(std::lround(255.0F * kPaper[static_cast<std::size_t>(c)]));
  }
}

ModelPointer styled_copy(const mjModel& model, int width, int height, RenderStyle style) {
  ModelPointer copy(mj_copyModel(nullptr, &model));
  if (!copy) throw std::bad_alloc();
  const bool full = style == RenderStyle::full;
  copy->vis.global.offwidth = std::max(width, kTextWidth);
  copy->vis.global.offheight = std::max(height, kTextHeight);
  copy->vis.global.fovy = static_cast<float>(kFieldOfView);
  copy->vis.quality.offsamples = full ? 4 : 0;
  copy->vis.quality.shadowsize = full ? 2048 : 1024;
  copy->vis.map.shadowclip = 1.0F;  // times the extent: half the side of what the shadow map covers
  copy->stat.extent = kStudioSize;
  std::copy(kPaper.begin(), kPaper.end(), copy->vis.rgba.fog);
  std::fill_n(copy->vis.headlight.ambient, 3, 0.42F);
  std::fill_n(copy->vis.headlight.diffuse, 3, 0.26F);
  std::fill_n(copy->vis.headlight.specular, 3, 0.10F);
  copy->vis.headlight.active = 1;
  extend_to_paper(*copy);
  return copy;
}

/// The same light for every scene, turned with the camera: a head light and a sun that casts the
/// shadow.
void light_studio(const View& view, mjvScene& scene) {
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
  for (std::size_t c = 0; c < 3; ++c) {
    sun.pos[c] = static_cast<float>(view.lookat[c] - 1.0 * sun.dir[c]);
  }
  scene.lights[scene.nlight++] = sun;
}

void draw_lines(std::span<const FloorLine> lines, mjvScene& scene) {
  for (const FloorLine& line : lines) {
    for (std::size_t i = 1; i < line.points.size() && scene.ngeom < scene.maxgeom; ++i) {
      mjvGeom& geom = scene.geoms[scene.ngeom++];
      mjv_initGeom(&geom, mjGEOM_CAPSULE, nullptr, nullptr, nullptr, line.rgba.data());
      mjv_connector(&geom, mjGEOM_CAPSULE, line.radius, line.points[i - 1].data(),
                    line.points[i].data());
      geom.category = mjCAT_DECOR;
      geom.objtype = mjOBJ_UNKNOWN;
      geom.objid = geom.segid = -1;
      geom.emission = 0.6F;
      geom.specular = 0.0F;
    }
  }
}

}  // namespace

void place(const mjModel& model, mjData& data, std::span<const double> qpos) {
  if (qpos.size() != static_cast<std::size_t>(model.nq)) {
    throw std::invalid_argument("a pose of " + std::to_string(qpos.size()) +
                                " numbers for a model of " + std::to_string(model.nq));
  }
  if (!std::all_of(qpos.begin(), qpos.end(), [](double q) { return std::isfinite(q); })) {
    throw std::invalid_argument("a pose that is not finite");
  }
  std::copy(qpos.begin(), qpos.end(), data.qpos);
  mj_kinematics(&model, &data);
  mj_comPos(&model, &data);
  mj_camlight(&model, &data);
  mj_tendon(&model, &data);
}

struct Renderer::Parts {
  ModelPointer model;
  DataPointer data;
  int width, height;
  mjvScene scene;
  mjvOption option;
  mjrContext context;

  Parts(const mjModel& source, int w, int h, RenderStyle style)
      : model(styled_copy(source, w, h, style)),
        data(mj_makeData(model.get())),
        width(w),
        height(h) {
    if (!data) throw std::bad_alloc();
    mjv_defaultScene(&scene);
    mjv_defaultOption(&option);
    mjr_defaultContext(&context);
    mjv_makeScene(model.get(), &scene, kSceneGeoms);
    scene.flags[mjRND_REFLECTION] = 0;
    scene.flags[mjRND_HAZE] = 0;
    scene.flags[mjRND_SKYBOX] = 1;
    scene.flags[mjRND_FOG] = 1;
    mjr_makeContext(model.get(), &context, mjFONTSCALE_200);
  }
  ~Parts() {
    mjr_freeContext(&context);
    mjv_freeScene(&scene);
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;
};

Renderer::Renderer(const GlContext&, const mjModel& model, int width, int height, RenderStyle style)
    : parts_(std::make_unique<Parts>(model, width, height, style)) {
  mjr_setBuffer(mjFB_OFFSCREEN, &parts_->context);
  if (parts_->context.currentBuffer != mjFB_OFFSCREEN)
    throw GlError("OpenGL made no off-screen buffer");
}

Renderer::~Renderer() = default;

Image Renderer::read_buffer(int width, int height) const {
  Image image(width, height), upside_down(width, height);
  mjr_readPixels(upside_down.rgb.data(), nullptr, {0, 0, width, height}, &parts_->context);
  for (int y = 0; y < height; ++y) {
    std::copy_n(upside_down.pixel(0, height - 1 - y), 3 * width, image.pixel(0, y));
  }
  return image;
}

Image Renderer::render(std::span<const double> qpos, const View& view,
                       std::span<const FloorLine> lines) {
  Parts& p = *parts_;
  place(*p.model, *p.data, qpos);
  mjvCamera camera;
  mjv_defaultFreeCamera(p.model.get(), &camera);
  camera.type = mjCAMERA_FREE;
  std::copy(view.lookat.begin(), view.lookat.end(), camera.lookat);
  camera.distance = view.distance;
  camera.azimuth = view.azimuth;
  camera.elevation = view.elevation;
  // Infinite planes are centred on the camera that the scene had before: place it first, else the
  // first frame differs.
  mjv_updateCamera(p.model.get(), p.data.get(), &camera, &p.scene);
  mjv_updateScene(p.model.get(), p.data.get(), &p.option, nullptr, &camera, mjCAT_ALL, &p.scene);
  light_studio(view, p.scene);
  draw_lines(lines, p.scene);
  p.context.fogStart = static_cast<float>(1.15 * view.distance);
  p.context.fogEnd = static_cast<float>(3.0 * view.distance);
  mjr_render({0, 0, p.width, p.height}, &p.scene, &p.context);
  return read_buffer(p.width, p.height);
}

Mask Renderer::word(const std::string& word, bool large) {
  const mjrContext& c = parts_->context;
  const int factor = large ? 3 : 2;
  const int tall = factor * ((large ? c.charHeightBig : c.charHeight) / factor + 4);
  mjr_label({0, 0, kTextWidth, tall}, large ? mjFONT_BIG : mjFONT_NORMAL, word.c_str(), 0, 0, 0, 1,
            1, 1, 1, &c);
  const Image drawn = shrink(read_buffer(kTextWidth, tall), factor);
  int left = drawn.width, right = 0;  // ink decides the width; all words keep the same height
  for (int i = 0; i < drawn.width * drawn.height; ++i) {
    if (drawn.rgb[3 * static_cast<std::size_t>(i)] == 0) continue;
    left = std::min(left, i % drawn.width);
    right = std::max(right, i % drawn.width + 1);
  }
  Mask mask{std::max(0, right - left), drawn.height, {}};
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) mask.cover.push_back(drawn.pixel(left + x, y)[0]);
  }
  return mask;
}

Mask Renderer::text(std::string_view line, bool large) {
  const int blank = large ? 7 : 6;  // pixels
  Mask whole;
  while (
      // word by word: MuJoCo draws nothing of a text that is wider than its canvas
      !line.empty()) {
    const std::size_t end = std::min(line.find(' '), line.size());
    const Mask next = word(std::string(line.substr(0, end)), large);
    line.remove_prefix(std::min(end + 1, line.size()));
    const int gap = whole.width == 0 ? 0 : blank;
    Mask joined{whole.width + gap + next.width, next.height, {}};
    joined.cover.assign(
        static_cast<std::size_t>(joined.width) * static_cast<std::size_t>(joined.height), 0);
    for (int y = 0; y < joined.height; ++y) {
      const auto row = joined.cover.begin() + y * joined.width;
      if (whole.width > 0) std::copy_n(whole.cover.begin() + y * whole.width, whole.width, row);
      std::copy_n(next.cover.begin() + y * next.width, next.width, row + whole.width + gap);
    }
    whole = std::move(joined);
  }
  return whole;
}

}  // namespace legwright
