// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace legwright {

/// How a residual r is punished.
enum class Penalty {
  quadratic,  // equalities: ½ r²
  barrier,    // inequalities r ≥ 0: relaxed log barrier
};

/// Value and first two derivatives of a penalty at r.
struct PenaltyValue {
  double value, first, second;
};

inline PenaltyValue quadratic(double r) { return {0.5 * r * r, r, 1.0}; }

/// −log r above `edge`, continued below it by the parabola with the same value and two derivatives: finite
/// everywhere, and unlike a hinge it bends before the wall, so Newton's method sees the wall coming.
inline PenaltyValue relaxed_log_barrier(double r, double edge) {
  if (r > edge) return {-std::log(r), -1.0 / r, 1.0 / (r * r)};
  const double u = (r - 2.0 * edge) / edge;
  return {0.5 * (u * u - 1.0) - std::log(edge), u / edge, 1.0 / (edge * edge)};
}

inline PenaltyValue evaluate(Penalty penalty, double r, double edge) {
  return penalty == Penalty::quadratic ? quadratic(r) : relaxed_log_barrier(r, edge);
}

}  // namespace legwright
