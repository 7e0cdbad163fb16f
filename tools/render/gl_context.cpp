// SPDX-License-Identifier: Apache-2.0
#include "tools/render/gl_context.hpp"

#include <dlfcn.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <string_view>

namespace legwright {
namespace {

constexpr const char* kLibrary = "libOSMesa.so.8";
constexpr int kGlRgba = 0x1908, kGlUnsignedByte = 0x1401, kGlRenderer = 0x1F01, kGlVersion = 0x1F02;
constexpr int kCanvas = 16;  // of the context itself; MuJoCo draws into its own frame buffer

std::atomic<bool> context_exists{false};

template <class Function>
Function symbol(void* library, const char* name) {
  auto* address = dlsym(library, name);
  if (address == nullptr) throw GlError(std::string(kLibrary) + " lacks the function " + name);
  return reinterpret_cast<Function>(address);
}

}  // namespace

struct GlContext::Mesa {
  using Handle = void*;
  Handle (*create)(unsigned, int, int, int, Handle) = nullptr;
  unsigned char (*make_current)(Handle, void*, unsigned, int, int) = nullptr;
  void (*destroy)(Handle) = nullptr;
  Handle context = nullptr;
  std::array<unsigned char, kCanvas * kCanvas * 4> canvas{};

  Mesa() = default;
  Mesa(const Mesa&) = delete;
  Mesa& operator=(const Mesa&) = delete;
  ~Mesa() {
    if (context != nullptr) destroy(context);
    context_exists = false;
  }
};

void pin_rasteriser() {
  const char* driver = std::getenv("GALLIUM_DRIVER");
  if (driver == nullptr || std::string_view(driver) != "llvmpipe")
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
}

GlContext::GlContext() {
  if (context_exists.exchange(true)) throw GlError("this process already has an OpenGL context");
  mesa_ = std::make_unique<Mesa>();  // from here on its destructor gives the place free
  pin_rasteriser();
  // Global, because MuJoCo looks its functions up by name; never closed, because MuJoCo keeps them.
  void* library = dlopen(kLibrary, RTLD_NOW | RTLD_GLOBAL);
  if (library == nullptr) {
    const char* why = dlerror();
    throw GlError(std::string("no off-screen OpenGL: ") + (why != nullptr ? why : kLibrary) +
                  "; install the package libosmesa6");
  }
  mesa_->create = symbol<decltype(mesa_->create)>(library, "OSMesaCreateContextExt");
  mesa_->make_current = symbol<decltype(mesa_->make_current)>(library, "OSMesaMakeCurrent");
  mesa_->destroy = symbol<decltype(mesa_->destroy)>(library, "OSMesaDestroyContext");
  mesa_->context = mesa_->create(kGlRgba, 24, 8, 8, nullptr);
  if (mesa_->context == nullptr) throw GlError("OSMesa made no context");
  if (!mesa_->make_current(mesa_->context, mesa_->canvas.data(), kGlUnsignedByte, kCanvas,
                           kCanvas)) {
    throw GlError("OSMesa could not make its context current");
  }
  const auto get_string = symbol<const unsigned char* (*)(unsigned)>(library, "glGetString");
  const auto text = [&](int name) {
    const unsigned char* value = get_string(static_cast<unsigned>(name));
    return std::string(value != nullptr ? reinterpret_cast<const char*>(value) : "unknown");
  };
  description_ = text(kGlRenderer) + ", " + text(kGlVersion);
}

GlContext::~GlContext() = default;

}  // namespace legwright
