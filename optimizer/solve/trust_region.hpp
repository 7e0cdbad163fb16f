// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace legwright {

/// How far a quadratic model of F over s is trusted: as far as it was right.
struct TrustRegion {
  double radius;  // largest change of a parameter in the next step [natural units]
  double most;    // that the radius may become
  double least;   // that a poor step may leave

  /// After a step that was taken. @param agreement its decrease over what the model promised.
  /// @param change its largest change of a parameter [natural units]
  void adapt(double agreement, double change) {
    if (agreement < 0.25)
      radius = std::max(0.5 * change, least);
    else if (agreement > 0.7 && change > 0.5 * radius)
      radius = std::min(2.0 * radius, most);
  }
};

}  // namespace legwright
