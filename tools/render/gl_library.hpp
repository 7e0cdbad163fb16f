// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace legwright {

/// A shared library that stays in the process for good: MuJoCo keeps its functions' addresses.
class GlLibrary {
 public:
  /// Opens it so that nobody else finds its functions by name. Throws GlError with the loader's
  /// words and the package that has it.
  GlLibrary(const char* file, const char* package);

  /// Throws GlError where it has no such function.
  template <class Function>
  Function function(const char* name) const {
    return reinterpret_cast<Function>(address(name));
  }

  /// Shows it to MuJoCo, which looks for OpenGL by name among what is global.
  void make_global() const;

 private:
  void* address(const char* name) const;
  std::string file_;
  void* handle_ = nullptr;
};

}  // namespace legwright
