// SPDX-License-Identifier: Apache-2.0
#include "optimizer/objective/derived/quantities.hpp"

namespace legwright {

void list_derived(DerivedList& out) {
  // Kinds of one row stand together knot by knot. The order settles the rounding of F's
  // derivatives.
  using Kind = void (*)(int knot, DerivedList&);
  static const std::vector<std::vector<Kind>> kTable{
      {list_com, list_feet},  // of one pose
      {list_swept_momentum, list_foot_turns, list_joint_torques},
      {list_trunk_points},
      {list_sole_directions},
      {list_wrapping_momentum},  // from a cycle to the next
      {list_actuator_shapes},
      {list_mass_share},
      {list_printed_volume},
      {list_home_inertia},
  };
  for (const std::vector<Kind>& row : kTable)
    for (int knot = 0; knot <= out.setting().layout.knot_count(); ++knot)
      for (const Kind list : row) list(knot, out);
}

}  // namespace legwright
