// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tools/image/id_image.hpp"
#include "tools/image/image.hpp"
#include "tools/render/gl_context.hpp"
#include "tools/render/view.hpp"

namespace legwright {

/// A line on the floor, drawn into the picture: where something went, or where it began.
struct FloorLine {
  std::vector<std::array<double, 3>> points;  // [m], world
  std::array<float, 4> rgba{0.2F, 0.2F, 0.2F, 1.0F};
  double radius = 0.002;  // [m]
};

/// The robot once more, in another pose, translucent and of one colour.
struct GhostPose {
  std::span<const double> qpos;
  std::array<float, 4> rgba{0.10F, 0.42F, 0.95F, 0.12F};
};

/// Full qpos vectors of one model, one after another.
using Poses = std::vector<std::vector<double>>;

/// The camera with the given direction that has the robot in the picture in all `poses` (at least
/// one), as large as `margin` (share of the picture left free) allows. The world body's geoms do
/// not count.
/// @param aspect width/height of the picture.
View frame_robot(const mjModel& model, const Poses& poses, double azimuth, double elevation,
                 double aspect, double margin = 0.12);
/// The same for several models in one picture frame: what each needs, together.
struct PosedModel {
  const mjModel* model;
  const Poses* poses;
};
View frame_robots(std::span<const PosedModel> robots, double azimuth, double elevation,
                  double aspect, double margin = 0.12);

/// Draws one model off-screen. Poses are only placed, nothing is simulated, so the same pose, view
/// and style give the same bytes each time. Keeps its own copy of the model. Lives on the thread of
/// its GlContext.
class Renderer {
 public:
  /// @param width, height of the pictures [pixels]. Throws GlError where OpenGL fails.
  Renderer(const GlContext& context, const mjModel& model, int width, int height,
           RenderStyle style);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// @param qpos model.nq numbers; throws std::invalid_argument for another count or non-finite
  /// ones, of the ghost too.
  Image render(std::span<const double> qpos, const View& view,
               std::span<const FloorLine> lines = {}, const GhostPose* ghost = nullptr);

  /// Which geom is seen where: no light, no colour, so it tells a moved joint from another
  /// rasteriser. Throws std::logic_error in style full, whose antialiasing would mix numbers.
  IdImage ids(std::span<const double> qpos, const View& view);

  /// A line of ASCII text as a mask, of a height that depends on `large` only; its width is that of
  /// its ink.
  Mask text(std::string_view line, bool large = false);

 private:
  struct Parts;
  void set_scene(std::span<const double> qpos, const View& view);
  Mask word(const std::string& word, bool large);
  Image read_buffer(int width, int height) const;
  std::unique_ptr<Parts> parts_;
};

}  // namespace legwright
