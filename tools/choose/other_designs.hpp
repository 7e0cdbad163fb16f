// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "optimizer/solve/multistart.hpp"
#include "tools/choose/candidate.hpp"

namespace legwright {

/// What else than its optimum a search came by, by rising F: optima of other starts, and iterates
/// on the way.
std::vector<Candidate> further_candidates(const MultistartResult& found,
                                          const std::vector<DesignIteration>& along);

/// The optimum of the other starts that has the least F, if that is another design and has less
/// than `dear` times the F of the best.
std::optional<Candidate> other_optimum(const MultistartResult& found, double dear);

}  // namespace legwright
