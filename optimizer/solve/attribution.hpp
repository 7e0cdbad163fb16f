// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace legwright {

/// What one term of one task gains (above zero) or loses of F by the change of a parameter: what it
/// costs more with that parameter put back (`put_back`).
struct AttributionShare {
  std::string task;  // empty where there is one task only
  std::string term;
  double decrease = 0.0;  // of F
};

/// What the change of one parameter buys in the finished design.
struct Attribution {
  std::string parameter;
  std::vector<AttributionShare> shares;  // the largest first, whatever their sign

  /// Decrease of F by all terms. @param task of one task only; of all where it is empty
  double total(std::string_view task = {}) const;
};

/// The largest first by size; equal ones keep their order.
void sort_by_size(std::vector<AttributionShare>& shares);

/// Adds the shares of another task.
void merge_attributions(std::vector<Attribution>& all, const std::vector<Attribution>& more);

/// The largest share of all, as a scale for what is worth naming.
double largest_share(const std::vector<Attribution>& attributions);

/// The few shares of a parameter that explain its change: at most three, none below 5 % of the
/// first. None at all where the first is below 1 % of `scale`. @param scale as of largest_share()
std::vector<AttributionShare> main_shares(const Attribution& attribution, double scale);

/// All parameters side by side. Their decreases are no parts of a whole and are not summed.
struct AttributionSummary {
  std::size_t count = 0, idle = 0;  // changes; those worth less than 1 % of the fall of F each
  std::vector<std::pair<std::string, double>> parameters;  // the two that buy most
};

/// None where nothing is known of any parameter.
/// @param fall by how much F fell in all, if it is known and counted as the shares are
std::optional<AttributionSummary> summarise(const std::vector<Attribution>& attributions,
                                            std::optional<double> fall);

/// What a changed parameter did, for the order in which changes are named.
struct ParameterEffect {
  double decrease = 0.0;        // of F, that its change buys; 0: not known
  double share_of_range = 0.0;  // |change| over the allowed range
};

/// Indices by falling decrease of F; equal ones by falling share of the range.
std::vector<std::size_t> order_of_effects(const std::vector<ParameterEffect>& effects);

/// How many of the first of `ordered` are worth naming: at most three, and where decreases are
/// known none whose is below 5 % of the first.
std::size_t count_main_effects(const std::vector<ParameterEffect>& ordered, bool decreases_known);

}  // namespace legwright
