// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/figures.hpp"

namespace legwright::bench {

Group ipopt_figures(const SolvedCase& solved) {
  return {{}, {}, {solved.of.label + ": IPOPT + MUMPS not measured: IPOPT not installed"}};
}

}  // namespace legwright::bench
