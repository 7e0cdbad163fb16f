// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "optimizer/solve/codesign.hpp"
#include "optimizer/solve/put_back.hpp"

namespace legwright {

struct FewestChangesOptions {
  CodesignOptions codesign = refit_options();  // of the rest, after something was put back
  double share = 0.95;  // of the fall of F: the fewest changes that keep it are looked for
  /// Several parameters go at once while that costs less than this share of the fall of F, or half
  /// of what may still be lost.
  double free_share = 0.01;
  std::function<bool()> stop = {};  // true: no further design

  /// A few steps each: the next design starts from this one.
  static CodesignOptions refit_options();
};

/// A design of which only some parameters differ from their old values.
struct FewerChanges {
  std::vector<int> changed;  // parameters
  DesignIteration design;
};

/// Designs with ever fewer changes: in each round the parameter whose putting back costs least
/// takes its old value for good, and the rest is optimised again from there, body and motions.
/// Greedy: another choice of so many parameters may do better.
/// @param threads the same tasks once for each thread; bits do not depend on how many there are
/// @param initial_value Σ w (F + J) of the old values with the best motions
/// @param rows_of_result what put_back() says of the result; where some are left out, it is asked
/// anew
/// @return from the result itself, or what it is without the changes that cost nothing, down to one
/// change; counts may be left out where several were put back at once
[[nodiscard]] std::vector<FewerChanges> fewest_changes(
    const std::vector<std::vector<WeightedCost>>& threads, const DesignSpace& space,
    const Eigen::VectorXd& old_values, double initial_value, const DesignIteration& result,
    const std::vector<PutBack>& rows_of_result, const FewestChangesOptions& options = {});

/// The last of `designs` that keeps this share of the fall of Σ w (F + J); the first where none
/// does. @param designs as of fewest_changes(), not empty
std::size_t fewest_that_keep(const std::vector<FewerChanges>& designs, double initial_value,
                             double share);

/// The space in which only `changed` may move; all others are held at their old values.
[[nodiscard]] DesignSpace held_space(DesignSpace space, const Eigen::VectorXd& old_values,
                                     const std::vector<int>& changed);

/// The design solved to the end: its changed parameters alone move.
[[nodiscard]] CodesignResult settle(const std::vector<WeightedCost>& tasks,
                                    const DesignSpace& space, const Eigen::VectorXd& old_values,
                                    const FewerChanges& design, const CodesignOptions& options);

}  // namespace legwright
