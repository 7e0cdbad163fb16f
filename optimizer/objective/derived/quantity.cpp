// SPDX-License-Identifier: Apache-2.0
#include "optimizer/objective/derived/quantity.hpp"

#include <algorithm>

namespace legwright {

DerivedQuantity::DerivedQuantity(const DerivedSetting& setting, int slot, int size,
                                 const std::vector<int>& knots, const Dependence& on,
                                 const std::vector<int>& forces)
    : slot_(slot), size_(size) {
  const Layout& layout = setting.layout;
  std::vector<int> coordinates;  // of each pose
  if (on.root) coordinates = {0, 1, 2, 3, 4, 5};
  for (int link : on.links) coordinates.push_back(5 + link);
  for (int knot : knots)
    for (int c : coordinates) slots_.push_back(layout.pose(knot) + c);
  for (int force : forces)
    for (int k = 0; k < 3; ++k) slots_.push_back(force + k);
  std::sort(slots_.begin(), slots_.end());  // as a clique has them
  motion_columns_ = static_cast<int>(slots_.size());
  for (int parameter : on.parameters) slots_.push_back(layout.design(parameter));
  for (int knot : knots) {
    Columns columns(static_cast<std::size_t>(layout.pose_size() + layout.design_size()), -1);
    for (int c : coordinates) columns[c] = column_of(layout.pose(knot) + c);
    for (int parameter : on.parameters)
      columns[layout.pose_size() + parameter] = column_of(layout.design(parameter));
    columns_.push_back(std::move(columns));
    pose_slots_.push_back(layout.pose(knot));
  }
}

int DerivedQuantity::column_of(int slot) const {
  return static_cast<int>(std::find(slots_.begin(), slots_.end(), slot) - slots_.begin());
}

}  // namespace legwright
