// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/effect.hpp"

#include <algorithm>
#include <cmath>

namespace legwright {
namespace {

constexpr double kEffectThreshold = 0.05;  // relative change of a figure

double worsening(double before, double after, Better better, double least) {
  if (better == Better::near_one) {
    before = std::abs(before - 1.0);
    after = std::abs(after - 1.0);
    return after - before >= std::max(least, kEffectThreshold) ? after - before : 0.0;
  }
  const double by = better == Better::less   ? after - before
                    : better == Better::more ? before - after
                                             : 0.0;
  return before != 0.0 && by >= least ? std::max(0.0, by / std::abs(before)) : 0.0;
}

}  // namespace

Effect effect_of(std::optional<double> before, std::optional<double> after, Better better,
                 double least) {
  Effect out;
  if (!before || !after) return out;
  const bool one_sign = std::signbit(*before) == std::signbit(*after) || *after == 0.0;
  if (*before != 0.0 && one_sign) out.change = (*after - *before) / std::abs(*before);
  out.worse = worsening(*before, *after, better, least);
  return out;
}

MainEffects main_effects(const std::vector<Effect>& effects, const std::vector<bool>& amounts) {
  MainEffects out;
  for (std::size_t k = 0; k < effects.size(); ++k) {
    const Effect& effect = effects[k];
    if (amounts[k] && effect.change && *effect.change <= -kEffectThreshold) out.gains.push_back(k);
    if (effect.worse >= kEffectThreshold &&
        (!out.worst || effect.worse > effects[*out.worst].worse))
      out.worst = k;
  }
  return out;
}

}  // namespace legwright
