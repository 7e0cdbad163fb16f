// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <string>

#include "optimizer/objective/objective.hpp"
#include "optimizer/solve/checkpoint.hpp"

namespace legwright {

struct FirstMotionOptions {
  int perturbations = 0;  // further starts: the first guess, moved at random
  std::uint64_t seed = 1;
  /// Told of each start with the F that a solve comes to from it; infinite where there is none.
  std::function<void(const std::string& start, double F)> tell = {};
  Checkpoint checkpoint = {};        // of this first motion, as NewtonOptions::checkpoint
  std::function<bool()> go_on = {};  // asked before each Newton step; false: no further start
  int threads = 1;                   // starts tried at the same time; the result is the same

  bool stopped() const { return go_on && !go_on(); }
};

/// m₀ for a body: of several first motions the one from which Newton's method comes to the least
/// F. Motion-only optimisation has many local minima, and a baseline that is left in a bad one
/// flatters co-design. Starts are initial_guess() at the wanted speed, the same on the spot, the
/// plan of half the speed (continuation), and the guess with smooth random joint motions on top.
/// Another start than the guess counts only if its F is lower by one percent; so where the guess is
/// good it stays. Deterministic. @param s design @return a start, which is not solved yet, but for
/// continuation; the guess where no start has a finite F
Eigen::VectorXd best_first_motion(const Objective& objective, const Eigen::VectorXd& s,
                                  const FirstMotionOptions& options = {});

}  // namespace legwright
