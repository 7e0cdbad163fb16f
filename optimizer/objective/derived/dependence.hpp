// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>

#include "optimizer/design/kinematics.hpp"
#include "optimizer/design/morphology.hpp"

namespace legwright {

/// Coordinates of [q; s] that a derived quantity depends on.
struct Dependence {
  std::set<int> links;       // whose joints matter
  std::set<int> parameters;  // of the design
  bool root = true;          // the trunk's six coordinates
};

/// A link's place in the world: the joints of its chain, and what of the design lies on the way.
Dependence on_chain(const Morphology& morphology, int link);
/// A point that is fixed to a link.
Dependence on_point(const Morphology& morphology, int link, const AffineVector& point);
/// The same point seen from the trunk, where it is wherever the trunk is.
Dependence on_point_of_trunk(const Morphology& morphology, int link, const AffineVector& point);
/// The masses of a link and all below it, seen from the link's parent, and the feet that they
/// carry.
Dependence on_subtree(const Morphology& morphology, const Ancestry& ancestry, int link);

/// Both.
Dependence operator|(Dependence a, const Dependence& b);

}  // namespace legwright
