// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/joint_torque.hpp"

#include <array>

#include "optimizer/objective/derived/quantities.hpp"

namespace legwright {
namespace {

/// Torque of a joint's motor by inverse dynamics at a knot [N m], against armature, damper and
/// spring of the joint, too; not against dry friction.
class MotorTorque final : public DerivedQuantity {
 public:
  MotorTorque(const DerivedSetting& setting, int slot, int knot, int link)
      : DerivedQuantity(setting, slot, 1, knots(setting.layout, knot),
                        on_chain(setting.morphology, link) |
                            on_subtree(setting.morphology, setting.ancestry, link),
                        forces(setting, knot, link)),
        knot_(knot),
        last_(setting.layout.knot_count()),
        link_(link),
        time_step_(setting.task.gait.time_step()),
        along_(torque_along(setting.morphology.links[link].joint, time_step_)),
        spring_(setting.morphology.links[link].joint.stiffness *
                setting.morphology.links[link].joint.slack_angle),
        up_(setting.task.up) {
    const std::vector<int> poses = knots(setting.layout, knot);
    for (std::size_t k = 0; k < 3; ++k) angles_[k] = setting.layout.pose(poses[k]) + 5 + link;
    for (int j = 0; j < setting.layout.foot_count(); ++j) {
      const int force = setting.layout.force(knot, j);
      if (carries(setting, knot, link, j)) forces_.push_back({j, force, column_of(force)});
    }
  }

  std::unique_ptr<State> make_state() const override { return std::make_unique<Held>(); }
  bool needs_moments() const override { return true; }

  void value(const DerivedInput& input, State& state,
             Eigen::Ref<Eigen::VectorXd> y) const override {
    std::vector<FootForce>& forces = static_cast<Held&>(state).forces;
    const Eigen::VectorXd& x = input.extended;
    forces.clear();
    for (const Carried& each : forces_) forces.push_back({each.foot, x.segment<3>(each.slot)});
    y[0] = JointTorque::value(input.morphology, input.robot.geometry, triple(input.robot), link_,
                              time_step_, forces) +
           along_.dot(Eigen::Vector3d(x[angles_[0]], x[angles_[1]], x[angles_[2]])) - spring_;
  }
  void jacobian(const DerivedInput& input, State& state, Eigen::MatrixXd& jacobian) const override {
    Held& held = static_cast<Held&>(state);
    held.with_design = input.with_design();
    JointTorque::Slots where{&columns(0), &columns(1), &columns(2), {}};
    for (const Carried& each : forces_) where.force.push_back(each.column);
    held.torque.compute(input.morphology, input.robot.geometry, input.ancestry, triple(input.robot),
                        link_, time_step_, held.forces, where, static_cast<int>(jacobian.rows()));
    held.torque.add_jacobian(jacobian);
    for (std::size_t k = 0; k < 3; ++k)
      jacobian(columns(k)[5 + link_], 0) += along_[static_cast<Eigen::Index>(k)];
  }
  bool add_loads(const DerivedInput& input, const State& state, const double* multiplier,
                 MotionLoads& loads) const override {
    const std::size_t knot = static_cast<std::size_t>(knot_);
    static_cast<const Held&>(state).torque.add_loads(
        input.morphology, input.robot.geometry, input.ancestry, triple(input.robot), link_,
        multiplier[0],
        {loads.poses[pose_before()], loads.poses[knot], loads.poses[knot + 1],
         loads.pairs[pair_before()], loads.pairs[knot]});
    return false;
  }
  void curvature(const Ancestry& ancestry, const State& state, const double* multiplier,
                 Eigen::MatrixXd& hessian) const override {
    const Held& held = static_cast<const Held&>(state);
    if (held.with_design)
      held.torque.add_curvature(ancestry, multiplier[0], hessian);
    else  // the rest is in the loads
      held.torque.add_products(multiplier[0], hessian);
  }

 private:
  struct Held : State {
    JointTorque torque;
    std::vector<FootForce> forces;
    bool with_design = false;  // at the latest jacobian()
  };
  /// A force of a foot that the joint carries.
  struct Carried {
    int foot, slot, column;
  };

  /// armature q̈ + damping q̇ + stiffness q by differences.
  static Eigen::Vector3d torque_along(const Joint& joint, double h) {
    const double inertia = joint.armature / (h * h), damping = joint.damping / (2.0 * h);
    return {inertia - damping, joint.stiffness - 2.0 * inertia, inertia + damping};
  }
  static std::vector<int> knots(const Layout& layout, int knot) {
    return {knot > 0 ? knot - 1 : layout.knot_count() - 1, knot, knot + 1};
  }
  static bool carries(const DerivedSetting& setting, int knot, int link, int foot) {
    return setting.layout.force(knot, foot) >= 0 &&
           setting.ancestry.contains(link, setting.morphology.feet[foot].link);
  }
  static std::vector<int> forces(const DerivedSetting& setting, int knot, int link) {
    std::vector<int> out;
    for (int j = 0; j < setting.layout.foot_count(); ++j)
      if (carries(setting, knot, link, j)) out.push_back(setting.layout.force(knot, j));
    return out;
  }
  /// Entries of RobotAtPoint.
  std::size_t pose_before() const {
    return static_cast<std::size_t>(knot_ > 0 ? knot_ - 1 : last_ + 1);
  }
  std::size_t pair_before() const {
    return static_cast<std::size_t>(knot_ > 0 ? knot_ - 1 : last_);
  }
  PoseTriple triple(const RobotAtPoint& robot) const {
    return {&robot.poses[pose_before()],   &robot.poses[knot_],   &robot.poses[knot_ + 1],
            &robot.moments[pair_before()], &robot.moments[knot_], up_};
  }

  int knot_, last_, link_;
  double time_step_;
  Eigen::Vector3d along_;      // angles before, at and after the knot [N m/rad]
  double spring_;              // stiffness times slack angle [N m]
  Eigen::Vector3d up_;         // against gravity
  std::array<int, 3> angles_;  // slots of the joint's angle before, at and after the knot
  std::vector<Carried> forces_;
};

}  // namespace

void list_joint_torques(int knot, DerivedList& out) {
  const Layout& layout = out.setting().layout;
  if (knot == layout.knot_count()) return;
  for (int a = 0; a < layout.joint_count(); ++a)
    out.add<MotorTorque>(layout.joint_torque(knot, a), 1, knot, a + 1);
}

}  // namespace legwright
