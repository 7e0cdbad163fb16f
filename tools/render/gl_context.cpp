// SPDX-License-Identifier: Apache-2.0
#include "tools/render/gl_context.hpp"

#include <dlfcn.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "tools/render/gl_platform.hpp"

namespace legwright {
namespace {

std::atomic<bool> context_exists{false};
std::atomic<const char*> platform_of_process{nullptr};  // the first that worked

struct GlBackend {
  const char* name;
  std::unique_ptr<GlPlatform> (*open)();
};
constexpr GlBackend kOsMesa{"osmesa", open_osmesa}, kEgl{"egl", open_egl};

/// MuJoCo takes EGL wherever its functions are global, even with a context of OSMesa current.
bool egl_is_global() { return dlsym(RTLD_DEFAULT, "eglGetCurrentContext") != nullptr; }

/// Platforms to try, in order. Throws GlError where the environment names none that there is.
std::vector<GlBackend> backends() {
  const char* given = std::getenv("LEGWRIGHT_GL");
  const std::string_view wanted = given != nullptr ? given : "";
  if (wanted == "none") throw GlError("no off-screen OpenGL: LEGWRIGHT_GL=none rules it out");
  if (!wanted.empty() && wanted != kOsMesa.name && wanted != kEgl.name) {
    throw GlError("LEGWRIGHT_GL is '" + std::string(wanted) +
                  "', expected osmesa, egl or none, or nothing for the first that works");
  }
  if (const char* fixed = platform_of_process) return {fixed == kEgl.name ? kEgl : kOsMesa};
  if (!wanted.empty()) return {wanted == kEgl.name ? kEgl : kOsMesa};
  if (egl_is_global()) return {kEgl};
  return {kOsMesa, kEgl};
}

}  // namespace

std::string GlPlatform::text(unsigned name) const {
  const unsigned char* value = get_string_ != nullptr ? get_string_(name) : nullptr;
  return value != nullptr ? reinterpret_cast<const char*>(value) : "unknown";
}

void pin_rasteriser() {
  constexpr std::array<std::array<const char*, 2>, 2> kPins{{
      {"GALLIUM_DRIVER", "llvmpipe"},
      {"LIBGL_ALWAYS_SOFTWARE", "1"},  // EGL would take a graphics card
  }};
  for (const auto& [name, value] : kPins) {
    const char* now = std::getenv(name);
    if (now == nullptr || std::string_view(now) != value) setenv(name, value, 1);
  }
}

GlContext::GlContext() {
  if (context_exists.exchange(true)) throw GlError("this process already has an OpenGL context");
  try {
    pin_rasteriser();
    std::string failures;
    for (const GlBackend& backend : backends()) {
      try {
        platform_ = backend.open();
        platform_name_ = backend.name;
        platform_of_process = backend.name;
        break;
      } catch (const GlError& error) {
        failures += (failures.empty() ? "" : "; ") + std::string(error.what());
      }
    }
    if (!platform_) {
      throw GlError("no off-screen OpenGL: " + failures +
                    "; install the package libosmesa6, or libegl1 with libgl1-mesa-dri");
    }
  } catch (...) {
    context_exists = false;
    throw;
  }
  renderer_ = platform_->text(kGlRenderer);
  version_ = platform_->text(kGlVersion);
}

GlContext::~GlContext() {
  platform_.reset();
  context_exists = false;
}

}  // namespace legwright
