// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "tools/render/gl_context.hpp"
#include "tools/render/gl_library.hpp"
#include "tools/render/gl_platform.hpp"

namespace legwright {
namespace {

constexpr unsigned kRgba = 0x1908, kUnsignedByte = 0x1401;
constexpr int kCanvas = 16;  // of the context itself; MuJoCo draws into its own frame buffer

class OsMesa : public GlPlatform {
 public:
  OsMesa() : library_("libOSMesa.so.8", "libosmesa6") {
    using Create = Handle (*)(unsigned, int, int, int, Handle);
    using MakeCurrent = unsigned char (*)(Handle, void*, unsigned, int, int);
    const auto create = library_.function<Create>("OSMesaCreateContextExt");
    const auto make_current = library_.function<MakeCurrent>("OSMesaMakeCurrent");
    destroy_ = library_.function<Destroy>("OSMesaDestroyContext");
    get_string_ = library_.function<GetString>("glGetString");
    context_ = create(kRgba, 24, 8, 8, nullptr);
    if (context_ == nullptr) throw GlError("OSMesa made no context");
    if (!make_current(context_, canvas_.data(), kUnsignedByte, kCanvas, kCanvas)) {
      destroy_(context_);
      throw GlError("OSMesa could not make its context current");
    }
    library_.make_global();
  }
  ~OsMesa() override { destroy_(context_); }

 private:
  using Handle = void*;
  using Destroy = void (*)(Handle);
  GlLibrary library_;
  Destroy destroy_ = nullptr;
  Handle context_ = nullptr;
  std::array<unsigned char, kCanvas * kCanvas * 4> canvas_{};
};

}  // namespace

std::unique_ptr<GlPlatform> open_osmesa() { return std::make_unique<OsMesa>(); }

}  // namespace legwright
