// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "optimizer/terms/term.hpp"

namespace legwright {

/// What a term is for: what the task wants, what must hold, what keeps F well-behaved, or what only
/// an outer objective measures.
enum class TermRole { objective, constraint, regulariser, outer };

/// p of the p-norm that stands for the largest of all torques: a smooth maximum.
inline constexpr int kPeakNorm = 16;

/// One row of the table of terms.
struct TermEntry {
  std::string_view name;      // file stem and key of [weights]
  std::string_view equation;  // of the paper, or "-" where it has none
  double default_weight;      // multiplies ½ r² or the barrier
  std::unique_ptr<Term> (*make)(const TermContext&);
  TermRole role;
  std::string_view unit;   // of residual · Term::unit().size; "1" for shares, "m, rad" for either
  std::string_view label;  // what it asks for, in a few words: "stance feet do not slip"
  std::string_view cost_label;  // what it punishes, as a noun: "slip of stance feet"
  /// Of outer terms: amount = value^(1/norm) · Term::unit().size, in `unit`.
  int norm = 1;
};

/// Every term there is, in the order in which reports list them.
const std::vector<TermEntry>& term_registry();
/// The row of a name; null where there is none.
const TermEntry* find_term(std::string_view name);

}  // namespace legwright
