// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "tools/render/gl_context.hpp"
#include "tools/render/renderer.hpp"

namespace legwright {

/// Stills of design iterations, cheap style, all by the camera that frames the first one: seen one
/// after another, only the body changes. Make, use and destroy it on one thread (it may be a
/// background one); plugins that the scenes name must have been loaded, and pin_rasteriser()
/// called, before that thread started.
class IterationPainter {
 public:
  static constexpr int kWidth = 640, kHeight = 480;

  /// @param first_scene scene.xml of iteration 0.
  /// Throws GlError where there is no OpenGL, std::runtime_error where the scene does not compile.
  explicit IterationPainter(const std::filesystem::path& first_scene);

  /// Draws the start of the scene's gait and writes it as PNG, whole or not at all.
  /// Throws std::runtime_error for the scene, std::system_error for the file.
  void paint(const std::filesystem::path& scene, const std::filesystem::path& png) const;
  /// The same, as a picture. Throws std::runtime_error for the scene.
  Image draw(const std::filesystem::path& scene) const;

  const GlContext& context() const { return context_; }

 private:
  GlContext context_;
  View view_;
};

}  // namespace legwright
