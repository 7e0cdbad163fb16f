// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <array>

#include "plugin/planned_motion.hpp"

namespace legwright {

using Colour = std::array<float, 4>;  // red, green, blue, alpha

inline constexpr Colour kGhostColour = {0.30F, 0.55F, 0.95F, 0.35F};
inline constexpr Colour kComColour = {0.80F, 0.15F, 0.60F, 0.9F};
inline constexpr Colour kComBallColour = {0.80F, 0.15F, 0.60F, 0.4F};
inline constexpr Colour kFootColour = {0.10F, 0.45F, 0.85F, 0.9F};
inline constexpr Colour kFootholdColour = {0.10F, 0.45F, 0.85F, 0.55F};
inline constexpr Colour kForceColour = {0.10F, 0.62F, 0.25F, 0.5F};

/// Marks a geom of the scene as decoration: no object of the model, in no segmentation picture,
/// see-through where its colour is.
void make_decoration(mjvGeom& geom) noexcept;

/// Adds decoration to a scene while it has room; what does not fit is left out.
class Pen {
 public:
  explicit Pen(mjvScene* scene) noexcept : scene_(scene) {}

  /// A rod from one point to another. @param radius [m]
  void rod(const Point& from, const Point& to, double radius, const Colour& colour) noexcept;
  void arrow(const Point& from, const Point& to, double radius, const Colour& colour) noexcept;
  void ball(const Point& centre, double radius, const Colour& colour) noexcept;
  /// A flat round mark on the ground. @param radius, height [m]
  void disc(const Point& centre, double radius, double height, const Colour& colour) noexcept;

 private:
  mjvGeom* add(int type, const mjtNum* size, const mjtNum* position, const Colour& colour) noexcept;
  void connect(int type, const Point& from, const Point& to, double radius,
               const Colour& colour) noexcept;

  mjvScene* scene_;
};

}  // namespace legwright
