// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

namespace legwright {

class GlPlatform;

/// No OpenGL, or one that refuses to work. The verb `render` exits 3 for it; `optimize` goes on
/// without pictures.
class GlError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Pins Mesa's llvmpipe rasteriser, so that pictures have the same bytes wherever they are made.
/// Changes the environment: call it before other threads start; GlContext calls it too.
void pin_rasteriser();

/// An off-screen OpenGL context: no display, no window. By OSMesa, where that is missing by EGL;
/// both give the same bytes. Belongs to the thread that made it; there is at most one at a time,
/// and all of a process are of one platform, because MuJoCo takes its GL functions from the first
/// one it sees.
///
/// The environment variable LEGWRIGHT_GL takes one platform alone: "osmesa" or "egl"; "none" is a
/// machine without any.
class GlContext {
 public:
  /// Opens a context and makes it current. Throws GlError that says what was tried and which
  /// package helps.
  GlContext();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// "osmesa" or "egl".
  const std::string& platform() const { return platform_name_; }
  /// What OpenGL calls its rasteriser, and its version: for records and golden pictures.
  const std::string& renderer() const { return renderer_; }
  const std::string& version() const { return version_; }
  /// "renderer, version".
  std::string description() const { return renderer_ + ", " + version_; }

 private:
  std::unique_ptr<GlPlatform> platform_;
  std::string platform_name_, renderer_, version_;
};

}  // namespace legwright
