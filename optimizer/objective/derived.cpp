// SPDX-License-Identifier: Apache-2.0
#include "optimizer/objective/derived.hpp"

#include <algorithm>

#include "optimizer/objective/dependence.hpp"

namespace legwright {
namespace {

using Kind = DerivedBlock::Kind;

const Eigen::Vector3d& sole_axis(const Morphology& morphology, const DerivedBlock& block) {
  const Sole& sole = *morphology.feet[block.part / 2].sole;
  return block.part % 2 == 0 ? sole.ahead : sole.beside;
}

}  // namespace

/// Adds the wanted ones among all derived quantities of a layout.
class DerivedQuantities::BlockBuilder {
 public:
  BlockBuilder(DerivedQuantities& out, const Morphology& morphology, const Layout& layout,
               const std::vector<char>& wanted)
      : out_(out), morphology_(morphology), layout_(layout), wanted_(wanted) {}

  /// @param knots of the poses it depends on.
  void add(Kind kind, int slot, int knot, int part, std::initializer_list<int> knots) {
    DerivedBlock block{};
    block.kind = kind;
    block.slot = slot;
    const bool amount = kind == Kind::mass_share || kind == Kind::printed_volume;
    block.size = kind == Kind::joint_torque || amount ? 1 : 3;
    block.knot = knot;
    block.part = part;
    bool used = false;
    for (int k = 0; k < block.size; ++k) used |= wanted_[slot + k] != 0;
    if (!used) return;
    const Dependence on = dependence(morphology_, out_.ancestry_, kind, part);
    std::vector<int> coordinates{0, 1, 2, 3, 4, 5};  // of each pose
    for (int link : on.links) coordinates.push_back(5 + link);
    for (int pose : knots)
      for (int c : coordinates) block.slots.push_back(layout_.pose(pose) + c);
    if (kind == Kind::joint_torque) add_forces(block);
    std::sort(block.slots.begin(), block.slots.end());  // as a clique has them
    block.motion_columns = static_cast<int>(block.slots.size());
    for (int parameter : on.parameters) block.slots.push_back(layout_.design(parameter));
    const auto column = [&block](int wanted_slot) {
      return static_cast<int>(std::find(block.slots.begin(), block.slots.end(), wanted_slot) -
                              block.slots.begin());
    };
    int which = 0;
    for (int pose : knots) {
      Columns& columns = block.columns[which++];
      columns.assign(layout_.pose_size() + layout_.design_size(), -1);
      for (int c : coordinates) columns[c] = column(layout_.pose(pose) + c);
      for (int parameter : on.parameters)
        columns[layout_.pose_size() + parameter] = column(layout_.design(parameter));
    }
    for (int force : block.forces) block.force_columns.push_back(column(force));
    if (kind == Kind::joint_torque) {
      for (int k = 0; k < 3; ++k) block.angles[k] = block.slots[block.columns[k][5 + part]];
      block.armature = morphology_.links[part].joint.armature / (out_.time_step_ * out_.time_step_);
    }
    const bool pair = kind == Kind::momentum || kind == Kind::foot_turn;
    block.index = kind == Kind::actuator       ? part
                  : amount                     ? 0
                  : kind == Kind::joint_torque ? out_.torque_count_++
                  : pair                       ? out_.pair_count_++
                                               : out_.point_count_++;
    out_.has_moments_ |= kind == Kind::momentum || kind == Kind::joint_torque;
    out_.blocks_.push_back(std::move(block));
  }

 private:
  void add_forces(DerivedBlock& block) {
    for (int j = 0; j < layout_.foot_count(); ++j) {
      const int force = layout_.force(block.knot, j);
      if (force < 0 || !out_.ancestry_.contains(block.part, morphology_.feet[j].link)) continue;
      block.forces.push_back(force);
      block.feet.push_back(j);
      for (int k = 0; k < 3; ++k) block.slots.push_back(force + k);
    }
  }

  DerivedQuantities& out_;
  const Morphology& morphology_;
  const Layout& layout_;
  const std::vector<char>& wanted_;
};

DerivedQuantities::DerivedQuantities(const Morphology& morphology, const Layout& layout,
                                     const Task& task, const WantedPath& path,
                                     const std::vector<char>& wanted)
    : ancestry_(morphology),
      path_(path),
      knot_count_(layout.knot_count()),
      time_step_(task.gait.time_step()),
      up_(task.up) {
  const int T = knot_count_, feet = layout.foot_count(), joints = layout.joint_count();
  BlockBuilder builder(*this, morphology, layout, wanted);
  for (int i = 0; i <= T; ++i) {
    builder.add(Kind::com, layout.com_from_pose(i), i, -1, {i});
    for (int j = 0; j < feet; ++j) builder.add(Kind::foot, layout.foot_from_pose(i, j), i, j, {i});
    for (int link = 1; link <= joints; ++link)
      builder.add(Kind::anchor, layout.link_anchor(i, link), i, link, {i});
  }
  for (int i = 0; i < T; ++i) {
    builder.add(Kind::momentum, layout.swept_momentum(i), i, -1, {i, i + 1});
    for (int j = 0; j < feet; ++j)
      builder.add(Kind::foot_turn, layout.foot_turn(i, j), i, j, {i, i + 1});
    for (int a = 0; a < joints; ++a)
      builder.add(Kind::joint_torque, layout.joint_torque(i, a), i, a + 1,
                  {i > 0 ? i - 1 : T - 1, i, i + 1});
  }
  for (int i = 0; i < T; ++i)
    for (int end = 0; end < 2 * static_cast<int>(morphology.capsules.size()); ++end)
      builder.add(Kind::capsule_end, layout.capsule_end(i, end / 2, end % 2), i, end, {i});
  for (int i = 0; i <= T; ++i)
    for (int j = 0; j < feet; ++j)
      for (int which = 0; which < 2 && morphology.feet[j].sole; ++which)
        builder.add(Kind::sole_direction, layout.sole_direction(i, j, which), i, 2 * j + which,
                    {i});
  builder.add(Kind::momentum, layout.wrapping_momentum(), T, -1, {T - 1, 0});
  for (int k = 0; k < static_cast<int>(morphology.linear_actuators.size()); ++k)
    builder.add(Kind::actuator, layout.actuator_shape(k), 0, k, {});
  builder.add(Kind::mass_share, layout.mass_share(), 0, -1, {});
  builder.add(Kind::printed_volume, layout.printed_volume(), 0, -1, {});
}

void DerivedQuantities::measure_amounts(const Morphology& morphology, Workspace& workspace) {
  const auto measure = [&](Amount amount, double unit) {
    GrowthSum sum = growth_sum(morphology, amount, workspace.s);
    sum.value /= unit;
    sum.gradient /= unit;
    sum.hessian /= unit;
    return sum;
  };
  const double leg = morphology.leg_length;
  workspace.mass_share = measure(Amount::mass, morphology.total_mass());
  workspace.printed_volume = measure(Amount::printed_volume, leg * leg * leg);
}

void DerivedQuantities::evaluate(const Morphology& morphology, const Layout& layout,
                                 PoseDetail detail, Eigen::VectorXd& extended,
                                 Workspace& workspace) const {
  const int T = knot_count_;
  const auto s = extended.head(layout.design_size());
  if (workspace.geometry.links.empty() || workspace.s != s) {
    workspace.s = s;
    workspace.geometry = GeometryAtDesign(morphology, workspace.s);
    measure_amounts(morphology, workspace);
    workspace.shapes.clear();
    for (const LinearActuator& actuator : morphology.linear_actuators)
      workspace.shapes.push_back(actuator_shape(morphology, actuator, workspace.s));
  }
  const GeometryAtDesign& geometry = workspace.geometry;
  workspace.poses.resize(T + 2);
  workspace.points.resize(point_count_);
  workspace.pairs.resize(pair_count_);
  workspace.torques.resize(torque_count_);
  workspace.jacobians.resize(blocks_.size());
  workspace.ready.assign(blocks_.size(), 0);
  for (int i = 0; i <= T; ++i)
    workspace.poses[i].compute(morphology, geometry,
                               extended.segment(layout.pose(i), layout.pose_size()), detail);
  if (has_moments_) {
    const Eigen::Matrix3d back = path_.turn().transpose();
    workspace.poses[T + 1].assign_moved(workspace.poses[T - 1], geometry, back,
                                        -back * path_.travel());
    workspace.moments.resize(T + 1);
    for (int i = 0; i < T; ++i)
      workspace.moments[i].compute(morphology, workspace.poses[i], workspace.poses[i + 1]);
    workspace.moments[T].compute(morphology, workspace.poses[T + 1], workspace.poses[0]);
  }
  for (const DerivedBlock& block : blocks_) place_block(morphology, block, extended, workspace);
}

PoseTriple DerivedQuantities::triple(const DerivedBlock& block, const Workspace& workspace) const {
  const int i = block.knot, before = i > 0 ? i - 1 : knot_count_;  // of pairs
  return {&workspace.poses[i > 0 ? i - 1 : knot_count_ + 1],
          &workspace.poses[i],
          &workspace.poses[i + 1],
          &workspace.moments[before],
          &workspace.moments[i],
          up_};
}

void DerivedQuantities::collect_forces(const DerivedBlock& block, const Eigen::VectorXd& extended,
                                       Workspace& workspace) const {
  workspace.forces.clear();
  for (std::size_t k = 0; k < block.forces.size(); ++k)
    workspace.forces.push_back({block.feet[k], extended.segment<3>(block.forces[k])});
}

void DerivedQuantities::place_block(const Morphology& morphology, const DerivedBlock& block,
                                    Eigen::VectorXd& extended, Workspace& workspace) const {
  const GeometryAtDesign& geometry = workspace.geometry;
  const PoseKinematics& pose = workspace.poses[block.knot];
  auto value = extended.segment(block.slot, block.size);
  switch (block.kind) {
    case Kind::com:
      value = pose.first_moment(0) / geometry.total_mass;
      break;
    case Kind::foot:
      value = foot_place(morphology, geometry, pose, block.part);
      break;
    case Kind::anchor:
      value = pose.origin(block.part);
      break;
    case Kind::capsule_end:
      value = capsule_end_place(morphology, geometry, pose, block.part);
      break;
    case Kind::sole_direction:
      value = pose.rotation(morphology.feet[block.part / 2].link) * sole_axis(morphology, block);
      break;
    case Kind::momentum:
      value = workspace.moments[block.knot].swept(0);
      break;
    case Kind::foot_turn:
      value =
          PairDerivatives::foot_turn(morphology, block.part, pose, workspace.poses[block.knot + 1]);
      break;
    case Kind::joint_torque:
      collect_forces(block, extended, workspace);
      value[0] = JointTorque::value(morphology, geometry, triple(block, workspace), block.part,
                                    time_step_, workspace.forces) +
                 block.armature * (extended[block.angles[0]] - 2.0 * extended[block.angles[1]] +
                                   extended[block.angles[2]]);
      break;
    case Kind::actuator:
      value = workspace.shapes[block.index].value;
      break;
    case Kind::mass_share:
      value[0] = workspace.mass_share.value;
      break;
    case Kind::printed_volume:
      value[0] = workspace.printed_volume.value;
      break;
  }
}

// Motion comes first: without the design's coordinates nothing is written behind it.
int DerivedQuantities::columns_of(const DerivedBlock& block, const Workspace& workspace) {
  return workspace.poses[0].with_design() ? static_cast<int>(block.slots.size())
                                          : block.motion_columns;
}

void DerivedQuantities::compute_torque(const Morphology& morphology, const DerivedBlock& block,
                                       const Eigen::VectorXd& extended,
                                       Workspace& workspace) const {
  collect_forces(block, extended, workspace);
  const JointTorque::Slots slots{&block.columns[0], &block.columns[1], &block.columns[2],
                                 block.force_columns};
  workspace.torques[block.index].compute(morphology, workspace.geometry, ancestry_,
                                         triple(block, workspace), block.part, time_step_,
                                         workspace.forces, slots, columns_of(block, workspace));
}

const Eigen::MatrixXd& DerivedQuantities::jacobian(const Morphology& morphology, int index,
                                                   const Eigen::VectorXd& extended,
                                                   Workspace& workspace) const {
  Eigen::MatrixXd& jacobian = workspace.jacobians[index];
  if (workspace.ready[index]) return jacobian;
  workspace.ready[index] = 1;
  const DerivedBlock& block = blocks_[index];
  const GeometryAtDesign& geometry = workspace.geometry;
  const bool wraps = block.kind == Kind::momentum && block.knot == knot_count_;
  const PoseKinematics& pose = workspace.poses[wraps ? knot_count_ + 1 : block.knot];
  const PoseKinematics& next = workspace.poses[wraps ? 0 : block.knot + 1];
  jacobian.setZero(columns_of(block, workspace), block.size);
  if (block.kind == Kind::actuator) {
    jacobian = workspace.shapes[block.index].jacobian.transpose();
    return jacobian;
  }
  if (block.kind == Kind::mass_share || block.kind == Kind::printed_volume) {
    jacobian = block.kind == Kind::mass_share ? workspace.mass_share.gradient
                                              : workspace.printed_volume.gradient;
    return jacobian;
  }
  if (block.kind == Kind::joint_torque) {
    compute_torque(morphology, block, extended, workspace);
    workspace.torques[block.index].add_jacobian(jacobian);
    for (int k = 0; k < 3; ++k)
      jacobian(block.columns[k][5 + block.part], 0) += (k == 1 ? -2.0 : 1.0) * block.armature;
    return jacobian;
  }
  if (block.kind == Kind::momentum || block.kind == Kind::foot_turn) {
    PairDerivatives& pair = workspace.pairs[block.index];
    if (block.kind == Kind::momentum)
      pair.compute_swept_momentum(geometry, ancestry_, 0, workspace.moments[block.knot], pose, next,
                                  block.columns[0], block.columns[1]);
    else
      pair.compute_foot_turn(morphology, ancestry_, block.part, pose, next, block.columns[0],
                             block.columns[1]);
    pair.add_jacobian(jacobian);
    return jacobian;
  }
  PointDerivatives& point = workspace.points[block.index];
  if (block.kind == Kind::com)
    com_from_pose(geometry, ancestry_, pose, block.columns[0], point);
  else if (block.kind == Kind::foot)
    foot_from_pose(morphology, geometry, ancestry_, pose, block.part, block.columns[0], point);
  else if (block.kind == Kind::capsule_end)
    capsule_end_from_pose(morphology, geometry, ancestry_, pose, block.part, block.columns[0],
                          point);
  else if (block.kind == Kind::sole_direction)
    direction_from_pose(ancestry_, pose, morphology.feet[block.part / 2].link,
                        sole_axis(morphology, block), block.columns[0], point);
  else
    anchor_from_pose(ancestry_, pose, block.part, block.columns[0], point);
  point.add_jacobian(jacobian);
  return jacobian;
}

void DerivedQuantities::curvature(int index, const double* multiplier, Workspace& workspace) const {
  const DerivedBlock& block = blocks_[index];
  const int size = columns_of(block, workspace);
  workspace.curvature.setZero(size, size);
  if (block.kind == Kind::joint_torque) {
    workspace.torques[block.index].add_curvature(ancestry_, multiplier[0], workspace.curvature);
    return;
  }
  if (block.kind == Kind::actuator) {
    const auto parameters = static_cast<int>(block.slots.size());
    workspace.curvature.setZero(parameters, parameters);
    for (int k = 0; k < 3; ++k)
      workspace.curvature += multiplier[k] * workspace.shapes[block.index].hessian[k];
    return;
  }
  if (block.kind == Kind::mass_share || block.kind == Kind::printed_volume) {
    workspace.curvature =
        multiplier[0] * (block.kind == Kind::mass_share ? workspace.mass_share.hessian
                                                        : workspace.printed_volume.hessian);
    return;
  }
  const Eigen::Map<const Eigen::Vector3d> wanted(multiplier);
  if (block.kind == Kind::momentum || block.kind == Kind::foot_turn)
    workspace.pairs[block.index].add_curvature(ancestry_, wanted, workspace.curvature);
  else
    workspace.points[block.index].add_curvature(ancestry_, wanted, workspace.curvature);
}

}  // namespace legwright
