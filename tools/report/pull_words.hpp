// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/files/json_file.hpp"

namespace legwright {

/// What one term of one task gained (above zero) or lost of F by the change of a parameter.
struct PullShare {
  std::string task;  // empty where there is one task only
  std::string term;
  double decrease = 0.0;
};

/// Why one parameter changed.
struct ParameterPull {
  std::string parameter;
  std::vector<PullShare> shares;  // the largest first, whatever their sign

  /// Decrease of F by all terms. @param task of one task only; of all where it is empty
  double total(std::string_view task = {}) const;
};

/// run.json's "pull", {parameter: {term: decrease of F}}; what has another form is left out.
/// @param task that the shares are labelled with; may be empty
std::vector<ParameterPull> pulls_of(const Json& pull, const std::string& task = {});
/// Adds the shares of another task.
void merge_pulls(std::vector<ParameterPull>& all, const std::vector<ParameterPull>& more);

/// The largest share of all, as a scale for what is worth telling.
double largest_share(const std::vector<ParameterPull>& pulls);

/// The two or three terms that pulled a parameter most, as changes of F: "slip of stance feet −14.3,
/// at the cost of jerky joints +2.6". Empty where none is worth telling.
/// @param scale as of largest_share()
std::string pull_words(const ParameterPull& pull, double scale);

/// All parameters together in a few sentences; empty without pulls.
/// @param fall by how much F fell in all, if it is known and counted as the pulls are
std::string pull_summary(const std::vector<ParameterPull>& pulls, std::optional<double> fall);

/// A change of F with its sign and as many digits as matter here: −14.3, −2.82, +0.06.
std::string change_of_F(double change);

}  // namespace legwright
