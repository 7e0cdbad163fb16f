// SPDX-License-Identifier: Apache-2.0
#include "optimizer/factor/cholesky_kernels.hpp"

namespace legwright {

const CholeskyKernels& cholesky_kernels(CpuPath path) {
#if defined(LEGWRIGHT_X86_PATHS)
  if (path == CpuPath::avx512) return avx512_kernels;
  if (path == CpuPath::avx2) return avx2_kernels;
#endif
  (void)path;
  return baseline_kernels;
}

}  // namespace legwright
