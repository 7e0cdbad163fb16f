// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "optimizer/objective/objective.hpp"

namespace legwright {

/// What one term of one task gained (above zero) or lost of F by the change of a parameter.
struct AttributionShare {
  std::string task;  // empty where there is one task only
  std::string term;
  double decrease = 0.0;  // of F
};

/// Why one parameter changed.
struct Attribution {
  std::string parameter;
  std::vector<AttributionShare> shares;  // the largest first, whatever their sign

  /// Decrease of F by all terms. @param task of one task only; of all where it is empty
  double total(std::string_view task = {}) const;
};

/// Why a body changed: how much of a task's F each term gave up by each parameter's change, summed
/// along the designs that were accepted. A term's derivative is the total one, along m*(s):
/// dF_t/ds = ∂F_t/∂s + ∂F_t/∂m dm/ds. All terms together make dF/ds, because ∂F/∂m vanishes. From
/// one design to the next its share is the mean of both ends times the change, exact to second
/// order; the rest of what a term really gave up in a long step goes to the parameters in the same
/// ratio.
class AttributionAlongPath {
 public:
  /// The next accepted design and the task's motion there. The first one only sets the start.
  /// @param sensitivity dm/ds; where it is empty ∂F_t/∂s alone counts.
  void add(const Objective& objective, const Eigen::VectorXd& s, const Eigen::VectorXd& m,
           const Eigen::MatrixXd& sensitivity);
  /// Goes on where another path ended.
  void follow(const AttributionAlongPath& before);

  /// Decrease of F by term (row) and parameter (column); negative: the change cost this term.
  const Eigen::MatrixXd& decrease() const { return decrease_; }
  /// Σ |what a term really gave up − what its derivatives explain|: the part that was spread.
  double spread() const { return spread_; }

  /// By parameter of `space`, times `weight`; shares below 1 % of the largest of all are left out.
  std::vector<Attribution> by_parameter(const DesignSpace& space, double weight) const;

 private:
  std::vector<std::string_view> terms_;
  std::vector<double> values_;  // of the terms
  double spread_ = 0.0;
  Eigen::VectorXd s_;
  Eigen::MatrixXd share_, decrease_;
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

/// All parameters together.
struct AttributionSummary {
  double decrease = 0.0;  // of F, by all terms and parameters
  bool partial = false;   // more than a tenth of the known fall of F is not attributed
  std::vector<AttributionShare> terms;  // summed over the parameters; the main ones
  std::vector<std::pair<std::string, double>> parameters;  // the two that lowered F most
};

/// None where there are no shares.
/// @param fall by how much F fell in all, if it is known and counted as the shares are
std::optional<AttributionSummary> summarise(const std::vector<Attribution>& attributions,
                                            std::optional<double> fall);

/// What a changed parameter did, for the order in which changes are named.
struct ParameterEffect {
  double decrease = 0.0;        // of F, by its change; 0: not known
  double share_of_range = 0.0;  // |change| over the allowed range
};

/// Indices by falling decrease of F; equal ones by falling share of the range.
std::vector<std::size_t> order_of_effects(const std::vector<ParameterEffect>& effects);

/// How many of the first of `ordered` are worth naming: at most three, and where decreases are
/// known none whose is below 5 % of the first.
std::size_t count_main_effects(const std::vector<ParameterEffect>& ordered, bool decreases_known);

}  // namespace legwright
