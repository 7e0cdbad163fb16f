// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "benchmarks/cases.hpp"

namespace legwright::bench {

using Json = nlohmann::ordered_json;

/// One line of the table: what is asked, and what was measured.
struct Figure {
  std::string name;
  double ask, stretch;
  double measured;
  bool at_least;      // true: larger is better
  std::string unit;   // "s", "×", "" …
  std::string where;  // on which robot
};

/// What a group of figures hands back: all numbers for the JSON, the table's lines, and what could
/// not be measured and why.
struct Group {
  Json details;
  std::vector<Figure> figures;
  std::vector<std::string> notes;
};

/// Co-design of a case: wall time, Newton and design iterations, motion solves. Solves it.
Group codesign_figures(SolvedCase& solved);
/// Motion of a task from standing still, at the co-designed body.
Group cold_start_figures(const SolvedCase& solved);
/// One Newton iteration and its parts over factor + solve of the same H.
Group iteration_figures(const SolvedCase& solved);
/// IPOPT + MUMPS over newton() on the same F; a note where IPOPT is not installed.
Group ipopt_figures(const SolvedCase& solved);
/// Design gradient over one Newton iteration and over central differences, by number of parameters.
Group gradient_figures(const SolvedCase& solved);
/// Time of one Newton iteration against the number of knots.
Group knots_figures(const SolvedCase& solved);

}  // namespace legwright::bench
