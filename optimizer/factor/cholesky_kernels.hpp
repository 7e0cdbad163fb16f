// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optimizer/factor/cpu_path.hpp"
#include "optimizer/factor/kernel_table.hpp"

namespace legwright {

/// The kernels built for `path`, which must be one of available_cpu_paths().
const CholeskyKernels& cholesky_kernels(CpuPath path);

}  // namespace legwright
