// SPDX-License-Identifier: Apache-2.0
#include "plugin/clock.hpp"

namespace legwright {

Blend blend_at(const Clock& clock, double time) noexcept {
  if (!(clock.blend_in > 0.0) || time >= clock.blend_in) return {};
  if (!(time > 0.0)) return {0.0, 0.0};
  const double x = time / clock.blend_in, y = 1.0 - x;
  return {x * x * x * (10.0 + x * (6.0 * x - 15.0)), 30.0 * x * x * y * y / clock.blend_in};
}

}  // namespace legwright
