// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

namespace legwright {

/// Checks for numbers on the command line: a whole word that is a finite number (parse_number()),
/// within bounds, which --help tells. The library's own take "nan", and a negative seed for a large
/// one.
CLI::Validator number_between(double low, double high);
CLI::Validator finite_number();
CLI::Validator number_from_zero();
/// A whole number that fits into 64 bits without sign.
CLI::Validator seed_number();

}  // namespace legwright
