// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace legwright {

/// How a residual r is punished.
enum class Penalty {
  quadratic,  // equalities: ½ r²
  barrier,    // inequalities r ≥ 0: relaxed log barrier
  near_only,  // inequalities r ≥ 0 that cost nothing from r = 1 on
  linear,     // r itself, for amounts that are to be small
};

/// Share of what a motor may exert, the last one, over which its barrier acts.
inline constexpr double kTorqueBarrierRange = 0.3;

/// Value and first two derivatives of a penalty at r.
struct PenaltyValue {
  double value, first, second;
};

inline PenaltyValue quadratic(double r) { return {0.5 * r * r, r, 1.0}; }

/// −log r above `edge`, continued below it by the parabola with the same value and two derivatives:
/// finite everywhere, and unlike a hinge it bends before the wall, so Newton's method sees the wall
/// coming.
inline PenaltyValue relaxed_log_barrier(double r, double edge) {
  if (r > edge) return {-std::log(r), -1.0 / r, 1.0 / (r * r)};
  const double u = (r - 2.0 * edge) / edge;
  return {0.5 * (u * u - 1.0) - std::log(edge), u / edge, 1.0 / (edge * edge)};
}

/// (−log r)³ between `edge` and 1, zero from 1 on, below the edge the parabola with the same value
/// and two derivatives. Twice differentiable everywhere; what is far from its wall costs and
/// disturbs nothing.
inline PenaltyValue near_barrier(double r, double edge) {
  if (r >= 1.0) return {0.0, 0.0, 0.0};
  const double at = r > edge ? r : edge, u = -std::log(at);
  const double first = -3.0 * u * u / at, second = (6.0 * u + 3.0 * u * u) / (at * at), d = r - at;
  return {u * u * u + (first + 0.5 * second * d) * d, first + second * d, second};
}

inline PenaltyValue evaluate(Penalty penalty, double r, double edge) {
  switch (penalty) {
    case Penalty::quadratic:
      return quadratic(r);
    case Penalty::barrier:
      return relaxed_log_barrier(r, edge);
    case Penalty::near_only:
      return near_barrier(r, edge);
    default:
      return {r, 1.0, 0.0};
  }
}

inline bool is_inequality(Penalty penalty) {
  return penalty == Penalty::barrier || penalty == Penalty::near_only;
}

}  // namespace legwright
