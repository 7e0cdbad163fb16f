// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "optimizer/design/actuator_length.hpp"
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/penalty.hpp"

namespace legwright {
namespace {

/// Not in the paper: no linear actuator pushes or pulls harder than its limit F, less the task's
/// margin: |τ| ≤ F |∂L/∂q| with the joint's torque τ of inverse dynamics and the moment arm ∂L/∂q,
/// which keeps the sign it has in the home pose. Residuals (σ ∂L/∂q ∓ used)/(0.3 arm at home) ≥ 0,
/// σ that sign, with
///   used = τ/allowed,   allowed = (1 − margin) F,
/// and where the motor is known besides, with the hinge's speed ω that of the angles a knot before
/// and after,
///   used = τ/((1 − margin)·force at rest) + (∂L/∂q)² ω/speed without load.
class ActuatorForce final : public Term {
 public:
  explicit ActuatorForce(const TermContext& context) {
    const Layout& layout = context.layout;
    const Morphology& robot = context.morphology;
    const Eigen::VectorXd initial = context.space.initial();
    for (int i = 0; i < layout.knot_count(); ++i)
      for (std::size_t k = 0; k < robot.linear_actuators.size(); ++k) {
        const LinearActuator& actuator = robot.linear_actuators[k];
        const double home = moment_arm(actuator_shape(robot, actuator, initial).value,
                                       robot.links[actuator.joint + 1].joint.nominal),
                     left = (1.0 - context.task.torque_margin) * context.length;
        const int shape = layout.actuator_shape(static_cast<int>(k)), angle = 6 + actuator.joint;
        const std::vector<int> slots{shape, shape + 1, shape + 2, layout.pose(i) + angle,
                                     layout.joint_torque(i, actuator.joint)};
        const Limit limit{1.0 / (kTorqueBarrierRange * home), kTorqueBarrierRange * std::abs(home),
                          left * actuator.force_limit, 0.0, actuator.name};
        if (std::isfinite(actuator.force_limit)) add({i, -1, 2, slots}, limit);
        const auto& motor = robot.links[actuator.joint + 1].joint.line;
        if (!motor) continue;
        Element element{i, -1, 2, slots};
        element.slots.push_back(layout.pose(i > 0 ? i - 1 : layout.knot_count() - 1) + angle);
        element.slots.push_back(layout.pose(i + 1) + angle);
        Limit line = limit;
        line.torque = left * motor->stall_torque;
        line.turned = context.length / (2.0 * context.task.gait.time_step() * motor->no_load_speed);
        line.name += " at its speed";
        add(element, line);
      }
  }
  std::string_view name() const override { return "actuator_force"; }
  Penalty penalty() const override { return Penalty::near_only; }

  void residual(int element, const Eigen::VectorXd& z, Eigen::VectorXd& r) const override {
    const Limit& limit = limits_[element];
    const double arm = moment_arm(z.head<3>(), z[3]), share = used(limit, z, arm);
    r[0] = limit.scale * arm - share;
    r[1] = limit.scale * arm + share;
  }
  void jacobian(int element, const Eigen::VectorXd& z, Eigen::MatrixXd& jacobian) const override {
    const Limit& limit = limits_[element];
    const Arm arm = arm_at(z);
    for (int side = 0; side < 2; ++side) {
      const double per_used = (side == 0 ? -1.0 : 1.0) / limit.range;
      jacobian.row(side).head<4>() = limit.scale * arm.gradient.transpose();
      jacobian(side, 4) = per_used / limit.torque;
      if (limit.turned == 0.0) continue;
      jacobian.row(side).head<4>() +=
          per_used * 2.0 * arm.value * limit.turned * (z[6] - z[5]) * arm.gradient.transpose();
      jacobian(side, 6) = per_used * arm.value * arm.value * limit.turned;
      jacobian(side, 5) = -jacobian(side, 6);
    }
  }
  void add_curvature(int element, const Eigen::VectorXd& z, const Eigen::VectorXd& multiplier,
                     Eigen::MatrixXd& hessian) const override {
    const Limit& limit = limits_[element];
    const Arm arm = arm_at(z);
    hessian.topLeftCorner<4, 4>() += limit.scale * (multiplier[0] + multiplier[1]) * arm.hessian;
    if (limit.turned == 0.0) return;
    const double per_used = 2.0 * (multiplier[1] - multiplier[0]) / limit.range * limit.turned;
    hessian.topLeftCorner<4, 4>() +=
        per_used * (z[6] - z[5]) *
        (arm.gradient * arm.gradient.transpose() + arm.value * arm.hessian);
    const Eigen::Vector4d mixed = per_used * arm.value * arm.gradient;
    hessian.block<4, 1>(0, 6) += mixed;
    hessian.block<1, 4>(6, 0) += mixed.transpose();
    hessian.block<4, 1>(0, 5) -= mixed;
    hessian.block<1, 4>(5, 0) -= mixed.transpose();
  }
  bool select_active(const Eigen::VectorXd& extended, std::vector<int>& active) const override {
    for (std::size_t k = 0; k < elements_.size(); ++k) {
      const std::vector<int>& slots = elements_[k].slots;
      const Limit& limit = limits_[k];
      const double arm = moment_arm(extended.segment<3>(slots[0]), extended[slots[3]]);
      double share = extended[slots[4]] / limit.torque;
      if (limit.turned > 0.0)
        share += arm * arm * limit.turned * (extended[slots[6]] - extended[slots[5]]);
      if (!(limit.scale * arm - std::abs(share) / limit.range >= 1.0))
        active.push_back(static_cast<int>(k));
    }
    return true;
  }
  ResidualUnit unit(int element, int) const override {
    return {limits_[element].range * limits_[element].torque, "N m"};
  }
  std::string subject(int element, int) const override { return limits_[element].name; }
  Eigen::VectorXd sample(int element, std::mt19937& random) const override {
    std::uniform_real_distribution<double> part(-0.3, 0.3), angle(-0.5, 0.5), share(-1.5, 1.5);
    const Limit& limit = limits_[element];
    Eigen::VectorXd z = Eigen::VectorXd::Zero(limit.turned > 0.0 ? 7 : 5);
    z.head<5>() << 0.08, 0.02 * part(random),
        (limit.scale > 0.0 ? 0.05 : -0.05) + 0.02 * part(random), angle(random), 0.0;
    const double arm = std::abs(moment_arm(z.head<3>(), z[3]));
    z[4] = share(random) * arm * limit.torque;
    if (limit.turned == 0.0) return z;
    const double turned = share(random) / (arm * limit.turned);
    z[5] = z[3] - 0.5 * turned;
    z[6] = z[3] + 0.5 * turned;
    return z;
  }

 private:
  struct Limit {
    double scale;   // 1/(0.3 arm at home), with the arm's sign [1/leg length]
    double range;   // 0.3 |arm at home| [leg length]
    double torque;  // of the allowed force at an arm of one leg length [N m]
    // Of its speed without load, with an arm of one leg length, for each rad from the knot before
    // to the one after; zero: at any speed.
    double turned;
    std::string name;
  };
  /// The moment arm with its derivatives in (A, B, C, q).
  struct Arm {
    double value;  // [leg length]
    Eigen::Vector4d gradient;
    Eigen::Matrix4d hessian;
  };

  void add(const Element& element, const Limit& limit) {
    elements_.push_back(element);
    limits_.push_back(limit);
  }

  /// Of the arm, over its range.
  static double used(const Limit& limit, const Eigen::VectorXd& z, double arm) {
    double out = z[4] / limit.torque;
    if (limit.turned > 0.0) out += arm * arm * limit.turned * (z[6] - z[5]);
    return out / limit.range;
  }

  /// ∂L/∂q = S′/(2L) with S = L² = A + B cos q + C sin q, S′ = ∂S/∂q.
  static Arm arm_at(const Eigen::VectorXd& z) {
    const double c = std::cos(z[3]), s = std::sin(z[3]),
                 length = actuator_length(z.head<3>(), z[3]);
    const double slope = z[2] * c - z[1] * s, bend = -z[1] * c - z[2] * s;
    const double l3 = std::pow(length, 3), l5 = std::pow(length, 5);
    const Eigen::Vector4d first(1.0, c, s, slope), slope_first(0.0, -s, c, bend);
    Eigen::Matrix4d second = Eigen::Matrix4d::Zero(), slope_second = Eigen::Matrix4d::Zero();
    second(1, 3) = second(3, 1) = -s;
    second(2, 3) = second(3, 2) = c;
    second(3, 3) = bend;
    slope_second(1, 3) = slope_second(3, 1) = -c;
    slope_second(2, 3) = slope_second(3, 2) = -s;
    slope_second(3, 3) = -slope;
    const Eigen::Matrix4d mixed = slope_first * first.transpose();
    return {slope / (2 * length), slope_first / (2 * length) - slope / (4 * l3) * first,
            slope_second / (2 * length) - (mixed + mixed.transpose() + slope * second) / (4 * l3) +
                3 * slope / (8 * l5) * first * first.transpose()};
  }

  std::vector<Limit> limits_;  // by element
};

}  // namespace

std::unique_ptr<Term> make_actuator_force(const TermContext& context) {
  return std::make_unique<ActuatorForce>(context);
}

}  // namespace legwright
