// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "benchmarks/figures.hpp"

namespace legwright::bench {

/// The lines of the two tables, like the paper's Table I and of what is asked, in Markdown.
/// @param result with "machine" and "cases" as speed_bench writes them.
Json markdown(const Json& result, const std::vector<Group>& groups);

}  // namespace legwright::bench
