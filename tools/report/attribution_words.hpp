// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "optimizer/solve/attribution.hpp"
#include "tools/run/put_back_record.hpp"

namespace legwright {

/// What a parameter's change buys by term, as changes of F, the main ones: "slip of stance feet
/// −14.3, at the cost of jerky joints +2.6". Empty where none is worth telling.
/// @param scale as of largest_share()
std::string attribution_words(const Attribution& attribution, double scale);

/// All parameters in a sentence or two; empty where nothing is known of any.
/// @param fall by how much F fell in all, if it is known and counted as the shares are
std::string attribution_summary(const std::vector<Attribution>& attributions,
                                std::optional<double> fall);

/// "put back alone, F rises by 3.1, and the robot fails in MuJoCo".
/// @param raised by how much; not finite: no motion @param played what physics says then, if known
std::string put_back_words(double raised, const std::optional<PlayedGait>& played = {});

/// "Put back alone, 2 of the 9 that buy 1 % of F or more let the robot fail in MuJoCo within a few
/// cycles: a and b.";
/// empty where nothing was played.
std::string put_back_physics_words(const std::optional<std::vector<PutBackRecord>>& rows);

/// What the numbers of such rows are, and what they are not.
inline constexpr const char* kPutBackNote =
    "Each number is of the finished body with that one parameter at its old value, all others as "
    "designed and the motion optimised anew: what the change buys there. The numbers do not add up "
    "to the fall of F, because changes help each other or do the same work.";

/// A change of F with its sign and as many digits as matter here: −14.3, −2.82, +0.06.
std::string change_of_cost(double change);

}  // namespace legwright
