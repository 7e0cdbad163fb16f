// SPDX-License-Identifier: Apache-2.0
#include "tools/run/install.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <sys/resource.h>

#include <Eigen/Core>

#include "tools/files/atomic_file.hpp"

namespace legwright {
namespace {

// Asked by symbol: this library must not depend on the headers of what it reports on.
std::string mujoco_version() {
  const auto version =
      reinterpret_cast<const char* (*)()>(::dlsym(RTLD_DEFAULT, "mj_versionString"));
  return version ? version() : "not loaded";
}

std::string cholmod_version() {
  const auto version = reinterpret_cast<int (*)(int*)>(::dlsym(RTLD_DEFAULT, "cholmod_version"));
  if (!version) return "not loaded";
  int parts[3] = {0, 0, 0};
  version(parts);
  return fmt::format("{}.{}.{}", parts[0], parts[1], parts[2]);
}

std::string compiler() {
#if defined(__clang__)
  return fmt::format("clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#else
  return fmt::format("gcc {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
}

}  // namespace

std::filesystem::path program_file() { return std::filesystem::read_symlink("/proc/self/exe"); }

std::vector<std::string> command_line() {
  std::vector<std::string> words;
  const std::string text = read_file("/proc/self/cmdline");
  for (std::size_t start = 0, end; (end = text.find('\0', start)) != std::string::npos;
       start = end + 1)
    words.push_back(text.substr(start, end - start));
  return words;
}

std::string program_version() { return LEGWRIGHT_VERSION; }

Json versions() {
  return {{"legwright", program_version()},
          {"mujoco", mujoco_version()},
          {"eigen",
           fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"cholmod", cholmod_version()},
          {"compiler", compiler()}};
}

double peak_memory_mib() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;  // Linux counts KiB
}

}  // namespace legwright
