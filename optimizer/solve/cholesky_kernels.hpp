// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optimizer/solve/cpu_path.hpp"
#include "optimizer/solve/kernel_table.hpp"

namespace legwright {

/// The kernels built for `path`, which must be one of available_cpu_paths().
const CholeskyKernels& cholesky_kernels(CpuPath path);

}  // namespace legwright
