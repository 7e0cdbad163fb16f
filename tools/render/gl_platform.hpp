// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

namespace legwright {

/// A way to an off-screen OpenGL context that is current on the thread which made it.
class GlPlatform {
 public:
  virtual ~GlPlatform() = default;
  GlPlatform() = default;
  GlPlatform(const GlPlatform&) = delete;
  GlPlatform& operator=(const GlPlatform&) = delete;

  /// Text with which OpenGL describes itself: `name` is GL_RENDERER or GL_VERSION.
  std::string text(unsigned name) const;

 protected:
  using GetString = const unsigned char* (*)(unsigned);
  GetString get_string_ = nullptr;
};

inline constexpr unsigned kGlRenderer = 0x1F01, kGlVersion = 0x1F02;

/// Mesa's own off-screen interface, libOSMesa.so.8. Throws GlError. Where it fails it leaves
/// nothing in the process's global scope, so that another platform can still be taken.
std::unique_ptr<GlPlatform> open_osmesa();

/// EGL without any surface or display server, libEGL.so.1: what newer Mesa has in OSMesa's place.
/// Throws GlError.
std::unique_ptr<GlPlatform> open_egl();

}  // namespace legwright
