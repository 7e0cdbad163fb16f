// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/figures.hpp"

namespace legwright::bench {

Group sqp_figures(const SolvedCase& solved) {
  Group group;
  group.notes.push_back(solved.of.label + ": SLSQP not measured: NLopt not installed");
  return group;
}

}  // namespace legwright::bench
