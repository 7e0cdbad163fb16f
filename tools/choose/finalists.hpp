// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "tools/choose/candidate.hpp"

namespace legwright {

/// A candidate that failed and may be among the nearest to passing.
struct Finalist {
  Candidate design;
  std::size_t place = 0;  // among all candidates, in the order in which they came
  double distance = 0.0;  // at least
  bool known = true;      // whether it is that
};

/// Of all candidates that fail the few nearest to passing, the first two of all, and besides those
/// that may be as near for all that is known.
class Finalists {
 public:
  void add(const Candidate& candidate, std::size_t place, const PlayedCandidate& played);
  /// The nearest that is not known in full; null where there is none.
  const Finalist* unknown() const;
  /// Makes unknown() known.
  void tell(const PlayedCandidate& played);
  /// In the order in which they came.
  std::vector<Finalist> in_order() const;

 private:
  void drop();

  std::vector<Finalist> kept_;  // the nearest first, behind those that stay
};

}  // namespace legwright
