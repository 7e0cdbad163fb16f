// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "benchmarks/cases.hpp"

namespace legwright::bench {

using Json = nlohmann::ordered_json;

/// One line of the table: the goal, and what was measured.
struct Figure {
  std::string name;
  double goal, measured;
  bool at_least;      // true: larger is better
  std::string unit;   // "s", "×", "" …
  std::string where;  // on which robot
};

/// How a time grows.
struct Curve {
  std::string what, against, where;
  std::vector<double> x, seconds;
  std::string why_steep;  // why it may be steeper than a line

  /// Of seconds against x, by least squares on the logarithms.
  double exponent() const;
};

/// What a group of figures hands back: all numbers for the JSON, the tables' lines, and what could
/// not be measured and why.
struct Group {
  Json details;
  std::vector<Figure> figures;
  std::vector<Curve> curves;
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
/// An SQP method without second derivatives on the same F; a note where NLopt is not installed.
Group sqp_figures(const SolvedCase& solved);
/// How times grow, with exponents fitted to them: of a Newton iteration with the number of knots
/// and of legs (the case is a hexapod), of a step of body and motions with the number of design
/// parameters and of tasks.
Group knots_figures(const SolvedCase& solved);
Group legs_figures(const SolvedCase& solved);
Group parameters_figures(const SolvedCase& solved);
Group tasks_figures(const SolvedCase& solved);

}  // namespace legwright::bench
