// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/cases.hpp"

namespace legwright::bench {

std::vector<Case> cases() {
  return {
      {"puppy, sideways", "puppy/sideways.toml", PaperRow{614, 6207, 32, 107.66}, 614, 3.0, 1.0,
       500, 250},
      {"hexapod, tripod", "hexapod/tripod_0.4.toml", PaperRow{1044, 5013, 53, 97.47}, 1044, 6.0,
       1.0, 700, 250},
      {"quadruped, pace and sideways", "quadruped/both.toml", PaperRow{1050, 14873, 100, 124.47},
       1050, 6.0, 1.0, 1200, 250},
  };
}

}  // namespace legwright::bench
