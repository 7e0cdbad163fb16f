// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "optimizer/solve/attribution.hpp"

namespace legwright {

/// The main shares of a parameter, as changes of F: "slip of stance feet −14.3,
/// at the cost of jerky joints +2.6". Empty where none is worth telling.
/// @param scale as of largest_share()
std::string attribution_words(const Attribution& attribution, double scale);

/// All parameters together in a few sentences; empty without shares.
/// @param fall by how much F fell in all, if it is known and counted as the shares are
std::string attribution_summary(const std::vector<Attribution>& attributions,
                                std::optional<double> fall);

/// A change of F with its sign and as many digits as matter here: −14.3, −2.82, +0.06.
std::string change_of_F(double change);

}  // namespace legwright
