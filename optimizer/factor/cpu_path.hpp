// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace legwright {

/// Which of the builds of the numerical kernels runs. They agree to rounding, not to the bit, so a
/// result says which one made it.
enum class CpuPath {
  baseline,  // what every processor of the architecture can do
  avx2,      // AVX2 and FMA
  avx512,    // AVX-512F
};

/// avx512, avx2 or baseline.
std::string_view to_string(CpuPath path);
std::optional<CpuPath> cpu_path_by_name(std::string_view name);

/// Those that this program has and this processor can run; slowest first, never empty.
std::vector<CpuPath> available_cpu_paths();

/// The fastest of them, or the one that the environment variable LEGWRIGHT_CPU_PATH names. Throws
/// std::invalid_argument where it names none, or one that this processor cannot run.
CpuPath cpu_path();

}  // namespace legwright
