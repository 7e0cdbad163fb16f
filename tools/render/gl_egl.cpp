// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cstdint>

#include "tools/render/gl_context.hpp"
#include "tools/render/gl_library.hpp"
#include "tools/render/gl_platform.hpp"

namespace legwright {
namespace {

// Numbers of the EGL registry; no header, because the library is only there at run time.
constexpr unsigned kPlatformSurfaceless = 0x31DD, kOpenGlApi = 0x30A2;
constexpr std::int32_t kNone = 0x3038, kSurfaceType = 0x3033, kPbuffer = 0x0001,
                       kRenderableType = 0x3040, kOpenGl = 0x0008;

class Egl : public GlPlatform {
 public:
  Egl() : library_("libEGL.so.1", "libegl1") {
    const auto address = library_.function<GetAddress>("eglGetProcAddress");
    open_display(address);
    make_context();
    get_string_ = reinterpret_cast<GetString>(address("glGetString"));
    library_.make_global();
  }
  ~Egl() override {
    make_current_(display_, nullptr, nullptr, nullptr);
    destroy_(display_, context_);
    // The display is the process's own and stays: the next context takes it again.
  }

 private:
  using Handle = void*;
  using Bool = unsigned;
  using GetAddress = void (*(*)(const char*))();
  using GetError = std::int32_t (*)();

  [[noreturn]] void fail(const char* what) const {
    const auto error = library_.function<GetError>("eglGetError");
    throw GlError(fmt::format("EGL {} (error 0x{:04X})", what, error()));
  }

  void open_display(GetAddress address) {
    using GetDisplay = Handle (*)(unsigned, void*, const std::int32_t*);
    using Initialize = Bool (*)(Handle, std::int32_t*, std::int32_t*);
    const auto get = reinterpret_cast<GetDisplay>(address("eglGetPlatformDisplayEXT"));
    if (get == nullptr) throw GlError("EGL has no platforms");
    const auto initialize = library_.function<Initialize>("eglInitialize");
    display_ = get(kPlatformSurfaceless, nullptr, nullptr);
    if (display_ == nullptr) fail("has no platform without a surface");
    if (!initialize(display_, nullptr, nullptr)) fail("could not be started");
  }

  void make_context() {
    using BindApi = Bool (*)(unsigned);
    using Choose = Bool (*)(Handle, const std::int32_t*, Handle*, std::int32_t, std::int32_t*);
    using Create = Handle (*)(Handle, Handle, Handle, const std::int32_t*);
    if (!library_.function<BindApi>("eglBindAPI")(kOpenGlApi))
      fail("has no OpenGL, only OpenGL ES");
    const std::array<std::int32_t, 5> wanted{kSurfaceType, kPbuffer, kRenderableType, kOpenGl,
                                             kNone};
    Handle config = nullptr;
    std::int32_t count = 0;
    const auto choose = library_.function<Choose>("eglChooseConfig");
    if (!choose(display_, wanted.data(), &config, 1, &count) || count == 0)
      fail("has no configuration for OpenGL");
    make_current_ = library_.function<MakeCurrent>("eglMakeCurrent");
    destroy_ = library_.function<Destroy>("eglDestroyContext");
    context_ = library_.function<Create>("eglCreateContext")(display_, config, nullptr, nullptr);
    if (context_ == nullptr) fail("made no context");
    if (!make_current_(display_, nullptr, nullptr, context_)) {
      destroy_(display_, context_);
      fail("could not make a context current without a surface");
    }
  }

  using MakeCurrent = Bool (*)(Handle, Handle, Handle, Handle);
  using Destroy = Bool (*)(Handle, Handle);
  GlLibrary library_;
  MakeCurrent make_current_ = nullptr;
  Destroy destroy_ = nullptr;
  Handle display_ = nullptr, context_ = nullptr;
};

}  // namespace

std::unique_ptr<GlPlatform> open_egl() { return std::make_unique<Egl>(); }

}  // namespace legwright
