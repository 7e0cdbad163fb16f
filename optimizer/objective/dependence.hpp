// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>

#include "optimizer/design/kinematics.hpp"
#include "optimizer/design/morphology.hpp"
#include "optimizer/objective/derived.hpp"

namespace legwright {

/// Coordinates of [q; s] that a derived quantity depends on, besides the root's.
struct Dependence {
  std::set<int> links;       // whose joints matter
  std::set<int> parameters;  // of the design
};

/// @param part of the block: see DerivedBlock.
Dependence dependence(const Morphology& morphology, const Ancestry& ancestry,
                      DerivedBlock::Kind kind, int part);

}  // namespace legwright
