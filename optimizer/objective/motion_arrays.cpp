// SPDX-License-Identifier: Apache-2.0
#include "optimizer/objective/motion_arrays.hpp"

#include <vector>

namespace legwright {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

double cubed(double length) { return length * length * length; }

}  // namespace

MotionArrays::MotionArrays(const Layout& layout)
    : s(VectorXd::Zero(layout.design_size())),
      joints(MatrixXd::Zero(layout.knot_count() + 1, layout.joint_count())),
      torques(joints),
      root(MatrixXd::Zero(layout.knot_count() + 1, 6)),
      com(MatrixXd::Zero(layout.knot_count() + 1, 3)),
      feet(MatrixXd::Zero(layout.knot_count() + 1, Eigen::Index{3} * layout.foot_count())),
      forces(feet) {}

MotionEntries::MotionEntries(const Objective& objective)
    : objective_(objective),
      mass_(objective.morphology().total_mass()),
      volume_unit_(cubed(objective.morphology().leg_length)) {
  const Layout& layout = objective.layout();
  std::vector<char> wanted(static_cast<std::size_t>(layout.extended_size()), 0);
  MotionArrays shapes(layout);
  visit(shapes, [&](double, int slot, double) { wanted[static_cast<std::size_t>(slot)] = 1; });
  derived_ =
      DerivedQuantities(objective.morphology(), layout, objective.task(), objective.path(), wanted);
}

// Calls visit(entry, slot, unit) for all entries that have a slot.
template <class Arrays, class Visit>
void MotionEntries::visit(Arrays& arrays, const Visit& visit) const {
  const Layout& layout = objective_.layout();
  for (int k = 0; k < layout.design_size(); ++k) visit(arrays.s[k], layout.design(k), 1.0);
  const auto row = [&](auto& table, int knot, int column, int slot, int size) {
    for (int k = 0; k < size; ++k) visit(table(knot, column + k), slot + k, 1.0);
  };
  for (int knot = 0; knot <= layout.knot_count(); ++knot) {
    const int pose = layout.pose(knot), joints = layout.joint_count();
    row(arrays.root, knot, 0, pose, 6);
    row(arrays.joints, knot, 0, pose + 6, joints);
    const int first = layout.joint_torque(knot % layout.knot_count(), 0);
    row(arrays.torques, knot, 0, first, joints);
    row(arrays.com, knot, 0, layout.com(knot), 3);
    for (int foot = 0; foot < layout.foot_count(); ++foot) {
      row(arrays.feet, knot, 3 * foot, layout.foot(knot, foot), 3);
      const int force = layout.force(knot, foot);
      if (force >= 0) row(arrays.forces, knot, 3 * foot, force, 3);
    }
  }
  visit(arrays.mass[0], layout.mass_share(), mass_);
  visit(arrays.printed_volume[0], layout.printed_volume(), volume_unit_);
}

MotionArrays MotionEntries::arrays(const VectorXd& s, const VectorXd& m, bool with_gradient,
                                   Workspace& workspace) const {
  const Layout& layout = objective_.layout();
  VectorXd& extended = workspace.extended;
  extended.setZero(layout.extended_size());
  extended.head(s.size()) = s;
  extended.segment(s.size(), m.size()) = m;
  derived_.evaluate(objective_.morphology(), layout,
                    with_gradient ? PoseDetail::design : PoseDetail::place, extended,
                    workspace.derived);
  MotionArrays out(layout);
  visit(out, [&](double& entry, int slot, double unit) { entry = unit * extended[slot]; });
  return out;
}

void MotionEntries::pull_back(const MotionArrays& by_entry, Workspace& workspace,
                              Evaluation& out) const {
  const Layout& layout = objective_.layout();
  VectorXd& gradient = workspace.gradient;
  gradient.setZero(layout.extended_size());
  visit(by_entry, [&](double entry, int slot, double unit) { gradient[slot] += unit * entry; });
  for (std::size_t b = 0; b < derived_.blocks().size(); ++b) {
    const DerivedQuantities::Extent at = derived_.extents()[b];
    const VectorXd by_y = gradient.segment(at.slot, at.size);
    if (by_y.isZero(0.0)) continue;
    const VectorXd by_column = derived_.jacobian(objective_.morphology(), static_cast<int>(b),
                                                 workspace.extended, workspace.derived) *
                               by_y;
    const std::vector<int>& slots = derived_.blocks()[b]->slots();
    for (std::size_t k = 0; k < slots.size(); ++k)
      gradient[slots[k]] += by_column[static_cast<Eigen::Index>(k)];
  }
  out.stationarity = gradient.segment(layout.design_size(), layout.motion_size());
  out.partial_s = gradient.head(layout.design_size());
}

}  // namespace legwright
