// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "benchmarks/figures.hpp"

namespace legwright::bench {

/// The lines of the tables, like the paper's Table I, of goals and of growth, in Markdown.
/// @param result with "machine" and "cases" as speed_bench writes them, a case for each of `cases`
Json markdown(const Json& result, const std::vector<Case>& cases, const std::vector<Group>& groups);

}  // namespace legwright::bench
