// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

namespace legwright {

/// No OpenGL, or one that refuses to work. The verb `render` exits 3 for it; `optimize` goes on
/// without pictures.
class GlError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Pins Mesa's llvmpipe rasteriser, so that pictures have the same bytes wherever they are made.
/// Changes the environment: call it before other threads start; GlContext calls it too.
void pin_rasteriser();

/// An off-screen OpenGL context by OSMesa: no display, no window. Belongs to the thread that made
/// it; there is at most one per process, because MuJoCo takes its GL functions from the first one
/// it sees.
class GlContext {
 public:
  /// Opens OSMesa and makes the context current. Throws GlError.
  GlContext();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// "renderer, version" as OpenGL tells them, for records and golden pictures.
  const std::string& description() const { return description_; }

 private:
  struct Mesa;
  std::unique_ptr<Mesa> mesa_;
  std::string description_;
};

}  // namespace legwright
