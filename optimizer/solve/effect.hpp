// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

namespace legwright {

/// Which values of a figure are better.
enum class Better { less, more, near_one, neither };

/// What a change of the body did to one figure, from one body to the other.
struct Effect {
  /// (after − before)/|before|, where both are known, before is not 0, and they have one sign.
  std::optional<double> change = std::nullopt;
  /// By how much it got worse, as a share of what it was; 0 where it did not or that is not known.
  /// Of a figure that is best at one: by how much it came away from one, if that is 0.05 or more.
  double worse = 0.0;
};

/// @param least difference below which nothing is called worse
Effect effect_of(std::optional<double> before, std::optional<double> after, Better better,
                 double least = 0.0);

/// The effects worth naming, as indices.
struct MainEffects {
  std::vector<std::size_t> gains;    // amounts that fell by 5 % or more
  std::optional<std::size_t> worst;  // what got worse most of all, by 5 % or more
};

/// @param amounts by effect: whether the figure is an amount, of which there is more or less
MainEffects main_effects(const std::vector<Effect>& effects, const std::vector<bool>& amounts);

}  // namespace legwright
