// SPDX-License-Identifier: Apache-2.0
#include "optimizer/objective/assembly.hpp"

#include <algorithm>
#include <map>

namespace legwright {

ElementPlan plan_element(const Element& element, const std::vector<DerivedBlock>& blocks,
                         const std::vector<int>& block_at_slot, int design_size,
                         int parameter_count) {
  ElementPlan plan;
  std::vector<int> slots;
  for (int slot : element.slots) {
    if (slot < parameter_count)
      slots.push_back(slot);
    else if (const int block = block_at_slot[slot]; block >= 0)
      slots.insert(slots.end(), blocks[block].slots.begin(), blocks[block].slots.end());
  }
  // Motion slots first, then design slots; both rising.
  std::sort(slots.begin(), slots.end(), [design_size](int a, int b) {
    const bool a_design = a < design_size, b_design = b < design_size;
    return a_design != b_design ? b_design : a < b;
  });
  slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
  std::map<int, int> column;
  for (std::size_t k = 0; k < slots.size(); ++k) column[slots[k]] = static_cast<int>(k);
  plan.clique.motion_count = static_cast<int>(
      std::count_if(slots.begin(), slots.end(), [&](int s) { return s >= design_size; }));
  for (int v = 0; v < static_cast<int>(element.slots.size()); ++v) {
    const int slot = element.slots[v];
    if (slot < parameter_count) {
      plan.direct.push_back({v, column[slot]});
    } else if (const int block = block_at_slot[slot]; block >= 0) {
      ElementPlan::Through through{v, block, {}};
      for (int s : blocks[block].slots) through.columns.push_back(column[s]);
      plan.through.push_back(std::move(through));
    }
  }
  plan.clique.slots = std::move(slots);
  return plan;
}

void expand_jacobian(const ElementPlan& plan, const std::vector<Eigen::Matrix3Xd>& jacobians,
                     int columns, ElementWorkspace& workspace) {
  workspace.expanded.setZero(workspace.jacobian.rows(), columns);
  for (const ElementPlan::Direct& direct : plan.direct)
    if (direct.column < columns)
      workspace.expanded.col(direct.column) += workspace.jacobian.col(direct.variable);
  for (const ElementPlan::Through& through : plan.through) {
    const auto local = workspace.jacobian.middleCols<3>(through.variable);
    const Eigen::Matrix3Xd& chain = jacobians[through.block];
    for (std::size_t k = 0; k < through.columns.size(); ++k)
      if (through.columns[k] < columns)
        workspace.expanded.col(through.columns[k]).noalias() +=
            local * chain.col(static_cast<int>(k));
  }
}

void expand_curvature(const ElementPlan& plan, const std::vector<Eigen::Matrix3Xd>& jacobians,
                      int columns, ElementWorkspace& workspace) {
  // First C·E, row by local variable; then Eᵀ times that. Rows of C that are all zero are skipped.
  const Eigen::MatrixXd& C = workspace.curvature;
  workspace.row.setZero(C.rows(), columns);
  for (const ElementPlan::Direct& direct : plan.direct)
    if (direct.column < columns) workspace.row.col(direct.column) += C.col(direct.variable);
  for (const ElementPlan::Through& through : plan.through) {
    const auto local = C.middleCols<3>(through.variable);
    if (local.isZero(0.0)) continue;
    const Eigen::Matrix3Xd& chain = jacobians[through.block];
    for (std::size_t k = 0; k < through.columns.size(); ++k)
      if (through.columns[k] < columns)
        workspace.row.col(through.columns[k]).noalias() += local * chain.col(static_cast<int>(k));
  }
  for (const ElementPlan::Direct& direct : plan.direct)
    if (direct.column < columns)
      workspace.hessian.row(direct.column) += workspace.row.row(direct.variable);
  for (const ElementPlan::Through& through : plan.through) {
    const auto local = workspace.row.middleRows<3>(through.variable);
    if (local.isZero(0.0)) continue;
    const Eigen::Matrix3Xd& chain = jacobians[through.block];
    for (std::size_t k = 0; k < through.columns.size(); ++k)
      if (through.columns[k] < columns)
        workspace.hessian.row(through.columns[k]).noalias() +=
            chain.col(static_cast<int>(k)).transpose() * local;
  }
}

}  // namespace legwright
