// SPDX-License-Identifier: Apache-2.0
#include "tools/render/renderer.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "mjcf/scene/surroundings.hpp"
#include "tools/render/posing.hpp"
#include "tools/render/studio.hpp"

namespace legwright {
namespace {

constexpr int kSceneGeoms = 4000;
// Canvas of one line of text, twice its final size [pixels].
constexpr int kTextWidth = 1536, kTextHeight = 128;

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

void paint_as_ghost(mjvGeom& geom, const GhostPose& ghost) {
  std::copy(ghost.rgba.begin(), ghost.rgba.end(), geom.rgba);
  geom.matid = -1;
  geom.category = mjCAT_DECOR;
  geom.emission = 0.2F;
  geom.specular = geom.reflectance = 0.0F;
}

/// Turns what the scene's cameras (left and right eye) see about the point that is looked at.
void turn_cameras(const Eigen::Matrix3d& turn, const View& view, mjvScene& scene) {
  if (turn.isIdentity(0.0)) return;  // level ground: the very same bits as ever
  const Eigen::Vector3f at(static_cast<float>(view.lookat[0]), static_cast<float>(view.lookat[1]),
                           static_cast<float>(view.lookat[2]));
  const Eigen::Matrix3f by = turn.cast<float>();
  for (mjvGLCamera& camera : scene.camera) {
    Eigen::Map<Eigen::Vector3f> place(camera.pos), forward(camera.forward), up(camera.up);
    place = (at + by * (place - at)).eval();
    forward = (by * forward).eval();
    up = (by * up).eval();
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
  DataPointer data, ghost;
  int width, height;
  RenderStyle style;
  mjvScene scene;
  mjvOption option;
  mjrContext context;

  Parts(const mjModel& source, int w, int h, RenderStyle how)
      : model(styled_copy(source, std::max(w, kTextWidth), std::max(h, kTextHeight), how)),
        data(mj_makeData(model.get())),
        ghost(mj_makeData(model.get())),
        width(w),
        height(h),
        style(how) {
    if (!data || !ghost) throw std::bad_alloc();
    mjv_defaultScene(&scene);
    mjv_defaultOption(&option);
    mjr_defaultContext(&context);
    mjv_makeScene(model.get(), &scene, kSceneGeoms);
    set_effects(style, scene, option);
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

void Renderer::set_scene(std::span<const double> qpos, const View& view) {
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
  turn_cameras(ground_rotation(*p.model), view, p.scene);
  light_studio(view, shadow_reach(view, p.width, p.height), p.scene);
  // The shadow's own picture covers what is seen about the robot: small scenes get sharp shadows.
  p.context.shadowClip = static_cast<float>(shadow_reach(view, p.width, p.height));
  p.context.fogStart = static_cast<float>(1.15 * view.distance);
  p.context.fogEnd = static_cast<float>(3.0 * view.distance);
}

Image Renderer::render(std::span<const double> qpos, const View& view,
                       std::span<const FloorLine> lines, const GhostPose* ghost) {
  Parts& p = *parts_;
  set_scene(qpos, view);
  draw_lines(lines, p.scene);
  if (ghost != nullptr) {
    place(*p.model, *p.ghost, ghost->qpos);
    const int first = p.scene.ngeom;
    mjv_addGeoms(p.model.get(), p.ghost.get(), &p.option, nullptr, mjCAT_DYNAMIC, &p.scene);
    for (int g = first; g < p.scene.ngeom; ++g) paint_as_ghost(p.scene.geoms[g], *ghost);
  }
  mjr_render({0, 0, p.width, p.height}, &p.scene, &p.context);
  return read_buffer(p.width, p.height);
}

IdImage Renderer::ids(std::span<const double> qpos, const View& view) {
  Parts& p = *parts_;
  if (p.style == RenderStyle::full)
    throw std::logic_error("numbers of geoms cannot be antialiased: use style cheap or plain");
  set_scene(qpos, view);
  p.scene.flags[mjRND_SEGMENT] = p.scene.flags[mjRND_IDCOLOR] = 1;
  mjr_render({0, 0, p.width, p.height}, &p.scene, &p.context);
  p.scene.flags[mjRND_SEGMENT] = p.scene.flags[mjRND_IDCOLOR] = 0;
  const Image colours = read_buffer(p.width, p.height);
  std::vector<std::uint16_t> id_of(static_cast<std::size_t>(p.scene.ngeom) + 1, 0);
  for (int g = 0; g < p.scene.ngeom; ++g) {  // what is drawn but is no geom counts as background
    const mjvGeom& geom = p.scene.geoms[g];
    if (geom.objtype == mjOBJ_GEOM && geom.segid >= 0 && geom.segid < p.scene.ngeom)
      id_of[static_cast<std::size_t>(geom.segid) + 1] = static_cast<std::uint16_t>(geom.objid + 1);
  }
  IdImage image(p.width, p.height);
  for (std::size_t i = 0; i < image.id.size(); ++i) {
    const std::uint8_t* c = &colours.rgb[3 * i];
    const std::size_t drawn = c[0] + 256U * c[1] + 65536U * c[2];
    image.id[i] = drawn < id_of.size() ? id_of[drawn] : 0;
  }
  return image;
}

Mask Renderer::word(const std::string& word, bool large) {
  const mjrContext& c = parts_->context;
  const int factor = large ? 3 : 2;
  const int tall = factor * ((large ? c.charHeightBig : c.charHeight) / factor + 4);
  mjr_label({0, 0, kTextWidth, tall}, large ? mjFONT_BIG : mjFONT_NORMAL, word.c_str(), 0, 0, 0, 1,
            1, 1, 1, &c);
  const Image drawn = downsample(read_buffer(kTextWidth, tall), factor);
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
