// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "optimizer/terms/term.hpp"

namespace legwright {

/// What a term is for: what the task wants, what must hold, what keeps F well-behaved, or what only an outer objective
/// measures.
enum class TermRole { objective, constraint, regulariser, outer };

/// One row of the table of terms.
struct TermEntry {
  std::string_view name;      // file stem and key of [weights]
  std::string_view equation;  // of the paper, or "-" where it has none
  double default_weight;      // multiplies ½ r² or the barrier
  std::unique_ptr<Term> (*make)(const TermContext&);
  TermRole role;
};

/// Every term there is, in the order in which reports list them.
const std::vector<TermEntry>& term_registry();

}  // namespace legwright
