// SPDX-License-Identifier: Apache-2.0
#include "optimizer/objective/derived.hpp"

#include "optimizer/objective/derived/quantities.hpp"

namespace legwright {

DerivedQuantities::DerivedQuantities(const Morphology& morphology, const Layout& layout,
                                     const Task& task, const WantedPath& path,
                                     const std::vector<char>& wanted)
    : ancestry_(morphology), path_(path) {
  const DerivedSetting setting{morphology, layout, task, ancestry_};
  DerivedList list(setting, wanted);
  list_derived(list);
  blocks_ = list.take();
  for (const auto& block : blocks_) {
    needs_moments_ |= block->needs_moments();
    extents_.push_back({block->slot(), block->size()});
  }
}

void DerivedQuantities::place_robot(const Morphology& morphology, const Layout& layout,
                                    PoseDetail detail, const Eigen::VectorXd& extended,
                                    RobotAtPoint& robot) const {
  const int T = layout.knot_count();
  robot.poses.resize(T + 2);
  for (int i = 0; i <= T; ++i)
    robot.poses[i].compute(morphology, robot.geometry,
                           extended.segment(layout.pose(i), layout.pose_size()), detail);
  if (!needs_moments_) return;
  const Eigen::Matrix3d back = path_.turn().transpose();
  robot.poses[T + 1].assign_moved(robot.poses[T - 1], robot.geometry, back, -back * path_.travel());
  robot.moments.resize(T + 1);
  for (int i = 0; i < T; ++i)
    robot.moments[i].compute(morphology, robot.poses[i], robot.poses[i + 1]);
  robot.moments[T].compute(morphology, robot.poses[T + 1], robot.poses[0]);
}

void DerivedQuantities::evaluate(const Morphology& morphology, const Layout& layout,
                                 PoseDetail detail, Eigen::VectorXd& extended,
                                 Workspace& workspace) const {
  RobotAtPoint& robot = workspace.robot;
  const auto s = extended.head(layout.design_size());
  const bool is_new = robot.geometry.links.empty();
  if (is_new)
    for (const auto& block : blocks_) workspace.states.push_back(block->make_state());
  if (is_new || robot.s != s) {
    robot.s = s;
    robot.geometry = GeometryAtDesign(morphology, robot.s);
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      blocks_[b]->prepare_design(morphology, robot.s, *workspace.states[b]);
  }
  workspace.jacobians.resize(blocks_.size());
  workspace.ready.assign(blocks_.size(), 0);
  place_robot(morphology, layout, detail, extended, robot);
  const DerivedInput input{morphology, ancestry_, robot, extended};
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    blocks_[b]->value(input, *workspace.states[b],
                      extended.segment(extents_[b].slot, extents_[b].size));
}

// Motion comes first: without the design's coordinates nothing is written behind it.
int DerivedQuantities::columns_of(const DerivedQuantity& block, const Workspace& workspace) {
  return workspace.robot.poses[0].with_design() ? static_cast<int>(block.slots().size())
                                                : block.motion_columns();
}

const Eigen::MatrixXd& DerivedQuantities::jacobian(const Morphology& morphology, int index,
                                                   const Eigen::VectorXd& extended,
                                                   Workspace& workspace) const {
  Eigen::MatrixXd& jacobian = workspace.jacobians[index];
  if (workspace.ready[index]) return jacobian;
  workspace.ready[index] = 1;
  const DerivedQuantity& block = *blocks_[index];
  jacobian.setZero(columns_of(block, workspace), block.size());
  block.jacobian({morphology, ancestry_, workspace.robot, extended}, *workspace.states[index],
                 jacobian);
  return jacobian;
}

bool DerivedQuantities::add_motion_gradient(const Morphology& morphology, int index,
                                            const double* multiplier,
                                            const Eigen::VectorXd& extended,
                                            const Workspace& workspace, double* gradient) const {
  return blocks_[index]->add_motion_gradient({morphology, ancestry_, workspace.robot, extended},
                                             multiplier, gradient);
}

void DerivedQuantities::clear_loads(Workspace& workspace) const {
  const RobotAtPoint& robot = workspace.robot;
  workspace.loads.poses.resize(robot.poses.size());
  workspace.loads.pairs.resize(robot.poses.size() - 1);
  for (PoseLoads& each : workspace.loads.poses) each.clear(robot.geometry.links.size());
  for (PairLoads& each : workspace.loads.pairs) each.clear(robot.geometry.links.size());
}

bool DerivedQuantities::add_loads(const Morphology& morphology, int index, const double* multiplier,
                                  const Eigen::VectorXd& extended, Workspace& workspace) const {
  return blocks_[index]->add_loads({morphology, ancestry_, workspace.robot, extended},
                                   *workspace.states[index], multiplier, workspace.loads);
}

void DerivedQuantities::curvature(int index, const double* multiplier, Workspace& workspace) const {
  const DerivedQuantity& block = *blocks_[index];
  const int size = columns_of(block, workspace);
  workspace.curvature.setZero(size, size);
  block.curvature(ancestry_, *workspace.states[index], multiplier, workspace.curvature);
}

}  // namespace legwright
