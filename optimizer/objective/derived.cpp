// SPDX-License-Identifier: Apache-2.0
#include "optimizer/objective/derived.hpp"

#include <set>

namespace legwright {
namespace {

/// Parameters that change a foot's place in its trunk, or (foot −1) anything about the robot.
std::set<int> design_dependence(const Morphology& morphology, int foot) {
  std::set<int> parameters;
  const auto add_vector = [&](const AffineVector& v) {
    for (const AffineVector::Slope& slope : v.slopes) parameters.insert(slope.parameter);
  };
  const auto add_link = [&](const Link& link) {
    add_vector(link.origin);
    for (const JointAxis::Turn& turn : link.joint.axis.turns) parameters.insert(turn.parameter);
  };
  if (foot >= 0) {
    for (int link : morphology.chain_to(morphology.feet[foot].link))
      add_link(morphology.links[link]);
    add_vector(morphology.feet[foot].position);
  } else {
    for (const Link& link : morphology.links) {
      add_link(link);
      for (const PointMass& point : link.masses) add_vector(point.position);
    }
  }
  return parameters;
}

}  // namespace

DerivedQuantities::DerivedQuantities(const Morphology& morphology, const Layout& layout,
                                     const Task& task, const WantedPath& path)
    : ancestry_(morphology), path_(path) {
  using Kind = DerivedBlock::Kind;
  const int T = layout.knot_count();
  for (int i = 0; i <= T; ++i) {
    add_block(Kind::com, layout.com_from_pose(i), i, -1, morphology, layout);
    for (int j = 0; j < layout.foot_count(); ++j)
      add_block(Kind::foot, layout.foot_from_pose(i, j), i, j, morphology, layout);
  }
  for (int i = 0; i <= T; ++i)
    add_block(Kind::momentum, layout.swept_momentum(i), i, -1, morphology, layout);
  const int margin = layout.planted_margin();
  for (int i = 0; i < T; ++i)
    for (int j = 0; j < layout.foot_count(); ++j)
      if (task.gait.planted(i, j, margin) && task.gait.planted(i + 1, j, margin))
        add_block(Kind::foot_turn, layout.foot_turn(i, j), i, j, morphology, layout);
  for (int k = 0; k < static_cast<int>(morphology.linear_actuators.size()); ++k)
    add_actuator_block(k, morphology, layout);
}

void DerivedQuantities::add_actuator_block(int actuator, const Morphology& morphology,
                                           const Layout& layout) {
  DerivedBlock block{
      DerivedBlock::Kind::actuator, layout.actuator_shape(actuator), 0, actuator, {}, 0, {}, {}};
  for (int parameter : actuator_parameters(morphology, morphology.linear_actuators[actuator]))
    block.slots.push_back(layout.design(parameter));
  blocks_.push_back(std::move(block));
}

void DerivedQuantities::add_block(DerivedBlock::Kind kind, int slot, int knot, int foot,
                                  const Morphology& morphology, const Layout& layout) {
  DerivedBlock block{kind, slot, knot, foot, {}, 0, {}, {}};
  std::vector<int> coordinates;  // of a pose, that matter
  for (int c = 0; c < 6; ++c) coordinates.push_back(c);
  if (foot >= 0)
    for (int link : morphology.chain_to(morphology.feet[foot].link))
      coordinates.push_back(5 + link);
  else
    for (int c = 6; c < layout.pose_size(); ++c) coordinates.push_back(c);
  const auto add_pose = [&](int pose_knot, Columns& columns) {
    columns.assign(layout.pose_size() + layout.design_size(), -1);
    for (int c : coordinates) {
      columns[c] = static_cast<int>(block.slots.size());
      block.slots.push_back(layout.pose(pose_knot) + c);
    }
  };
  const bool wraps = kind == DerivedBlock::Kind::momentum && knot == layout.knot_count();
  const bool pair = kind == DerivedBlock::Kind::momentum || kind == DerivedBlock::Kind::foot_turn;
  add_pose(wraps ? knot - 1 : knot, block.first);
  if (pair) add_pose(wraps ? 0 : knot + 1, block.second);
  block.motion_columns = static_cast<int>(block.slots.size());
  for (int parameter : design_dependence(morphology, foot)) {
    const int column = static_cast<int>(block.slots.size());
    block.first[layout.pose_size() + parameter] = column;
    if (pair) block.second[layout.pose_size() + parameter] = column;
    block.slots.push_back(layout.design(parameter));
  }
  blocks_.push_back(std::move(block));
}

void DerivedQuantities::evaluate(const Morphology& morphology, const Layout& layout,
                                 bool with_jacobian, bool with_design, Eigen::VectorXd& extended,
                                 Workspace& workspace) const {
  const int T = layout.knot_count();
  const auto s = extended.head(layout.design_size());
  if (workspace.geometry.links.empty() || workspace.s != s) {
    workspace.s = s;
    workspace.geometry = GeometryAtDesign(morphology, workspace.s);
    workspace.shapes.clear();
    for (const LinearActuator& actuator : morphology.linear_actuators)
      workspace.shapes.push_back(actuator_shape(morphology, actuator, workspace.s));
  }
  const GeometryAtDesign& geometry = workspace.geometry;
  workspace.poses.resize(T + 2);
  workspace.points.resize(blocks_.size());
  workspace.pairs.resize(blocks_.size());
  workspace.jacobians.resize(blocks_.size());
  for (int i = 0; i <= T; ++i)
    workspace.poses[i].compute(morphology, geometry,
                               extended.segment(layout.pose(i), layout.pose_size()), with_design);
  const Eigen::Matrix3d back = path_.turn().transpose();
  workspace.poses[T + 1] = workspace.poses[T - 1].moved(back, -back * path_.travel());
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const DerivedBlock& block = blocks_[b];
    if (block.kind == DerivedBlock::Kind::actuator) {
      const ActuatorShape& shape = workspace.shapes[block.foot];
      extended.segment<3>(block.slot) = shape.value;
      if (with_jacobian) workspace.jacobians[b] = shape.jacobian;
      continue;
    }
    const int first =
        block.kind == DerivedBlock::Kind::momentum && block.knot == T ? T + 1 : block.knot;
    const int second = first == T + 1 ? 0 : block.knot + 1;
    const PoseKinematics& pose = workspace.poses[first];
    PointDerivatives& point = workspace.points[b];
    PairDerivatives& pair = workspace.pairs[b];
    const bool is_point = block.second.empty();
    switch (block.kind) {
      case DerivedBlock::Kind::com:
        com_from_pose(morphology, geometry, pose, block.first, point);
        break;
      case DerivedBlock::Kind::foot:
        foot_from_pose(morphology, geometry, ancestry_, pose, block.foot, block.first, point);
        break;
      case DerivedBlock::Kind::momentum:
        pair.compute_swept_momentum(morphology, geometry, pose, workspace.poses[second],
                                    block.first, block.second);
        break;
      case DerivedBlock::Kind::foot_turn:
        pair.compute_foot_turn(morphology, ancestry_, block.foot, pose, workspace.poses[second],
                               block.first, block.second);
        break;
      case DerivedBlock::Kind::actuator:
        break;  // done above
    }
    extended.segment<3>(block.slot) = is_point ? point.value : pair.value;
    if (!with_jacobian) continue;
    workspace.jacobians[b].setZero(3, static_cast<int>(block.slots.size()));
    if (is_point)
      point.add_jacobian(workspace.jacobians[b]);
    else
      pair.add_jacobian(workspace.jacobians[b]);
  }
}

void DerivedQuantities::curvature(int block, const Eigen::Vector3d& multiplier,
                                  Workspace& workspace) const {
  const int size = static_cast<int>(blocks_[block].slots.size());
  workspace.curvature.setZero(size, size);
  if (blocks_[block].kind == DerivedBlock::Kind::actuator)
    for (int k = 0; k < 3; ++k)
      workspace.curvature += multiplier[k] * workspace.shapes[blocks_[block].foot].hessian[k];
  else if (blocks_[block].second.empty())
    workspace.points[block].add_curvature(ancestry_, multiplier, workspace.curvature);
  else
    workspace.pairs[block].add_curvature(ancestry_, multiplier, workspace.curvature);
}

}  // namespace legwright
