// SPDX-License-Identifier: Apache-2.0
#include "optimizer/factor/cpu_path.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace legwright {
namespace {

constexpr const char* kVariable = "LEGWRIGHT_CPU_PATH";

[[noreturn]] void refuse(std::string_view found) {
  std::string message(kVariable);
  message.append(" is '").append(found).append("'; this program on this processor has");
  for (const CpuPath path : available_cpu_paths()) message.append(" ").append(to_string(path));
  throw std::invalid_argument(message.append("; unset it to take the fastest"));
}

}  // namespace

std::string_view to_string(CpuPath path) {
  switch (path) {
    case CpuPath::avx512:
      return "avx512";
    case CpuPath::avx2:
      return "avx2";
    case CpuPath::baseline:
      break;
  }
  return "baseline";
}

std::optional<CpuPath> cpu_path_by_name(std::string_view name) {
  for (const CpuPath path : {CpuPath::baseline, CpuPath::avx2, CpuPath::avx512})
    if (name == to_string(path)) return path;
  return std::nullopt;
}

std::vector<CpuPath> available_cpu_paths() {
  std::vector<CpuPath> paths = {CpuPath::baseline};
#if defined(LEGWRIGHT_X86_PATHS)
  // Both also ask whether the operating system saves the wide registers.
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (avx2) paths.push_back(CpuPath::avx2);
  if (avx2 && __builtin_cpu_supports("avx512f")) paths.push_back(CpuPath::avx512);
#endif
  return paths;
}

CpuPath cpu_path() {
  const std::vector<CpuPath> available = available_cpu_paths();
  const char* wanted = std::getenv(kVariable);
  if (!wanted || !*wanted) return available.back();
  const std::optional<CpuPath> path = cpu_path_by_name(wanted);
  if (!path || std::find(available.begin(), available.end(), *path) == available.end())
    refuse(wanted);
  return *path;
}

}  // namespace legwright
