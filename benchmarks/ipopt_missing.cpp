// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/figures.hpp"

namespace legwright::bench {

Group ipopt_figures(const SolvedCase& solved) {
  Group group;
  group.notes.push_back(solved.of.label + ": IPOPT + MUMPS not measured: IPOPT not installed");
  return group;
}

}  // namespace legwright::bench
