// SPDX-License-Identifier: Apache-2.0
#include "tools/render/gl_library.hpp"

#include <dlfcn.h>

#include "tools/render/gl_context.hpp"

namespace legwright {

GlLibrary::GlLibrary(const char* file, const char* package)
    : file_(file), handle_(dlopen(file, RTLD_NOW | RTLD_LOCAL)) {
  if (handle_ != nullptr) return;
  const char* why = dlerror();
  throw GlError(std::string(why != nullptr ? why : file) + " (Debian's package " + package + ")");
}

void* GlLibrary::address(const char* name) const {
  void* found = dlsym(handle_, name);
  if (found == nullptr) throw GlError(file_ + " lacks the function " + name);
  return found;
}

void GlLibrary::make_global() const {
  if (dlopen(file_.c_str(), RTLD_NOW | RTLD_GLOBAL | RTLD_NOLOAD) == nullptr)
    throw GlError(file_ + " cannot be made visible to MuJoCo");
}

}  // namespace legwright
