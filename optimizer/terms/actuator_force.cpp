// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "optimizer/design/actuator_length.hpp"
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/penalty.hpp"

namespace legwright {
namespace {

/// Not in the paper: no linear actuator pushes or pulls harder than its limit F, less the task's
/// margin: |τ| ≤ F |∂L/∂q| with the joint's torque τ of inverse dynamics and the moment arm ∂L/∂q,
/// which keeps the sign it has in the home pose. Residuals (σ ∂L/∂q ∓ τ/allowed)/(0.3 arm at
/// home) ≥ 0, σ that sign, allowed = (1 − margin) F.
class ActuatorForce final : public Term {
 public:
  explicit ActuatorForce(const TermContext& context) {
    const Layout& layout = context.layout;
    const Morphology& robot = context.morphology;
    const Eigen::VectorXd initial = context.space.initial();
    for (int i = 0; i < layout.knot_count(); ++i)
      for (std::size_t k = 0; k < robot.linear_actuators.size(); ++k) {
        const LinearActuator& actuator = robot.linear_actuators[k];
        if (!std::isfinite(actuator.force_limit)) continue;
        const double home = moment_arm(actuator_shape(robot, actuator, initial).value,
                                       robot.links[actuator.joint + 1].joint.nominal);
        const int shape = layout.actuator_shape(static_cast<int>(k));
        elements_.push_back({i,
                             -1,
                             2,
                             {shape, shape + 1, shape + 2, layout.pose(i) + 6 + actuator.joint,
                              layout.joint_torque(i, actuator.joint)}});
        limits_.push_back(
            {1.0 / (kTorqueBarrierRange * home), kTorqueBarrierRange * std::abs(home),
             (1.0 - context.task.torque_margin) * actuator.force_limit * context.length,
             actuator.name});
      }
  }
  std::string_view name() const override { return "actuator_force"; }
  Penalty penalty() const override { return Penalty::near_only; }

  void residual(int element, const Eigen::VectorXd& z, Eigen::VectorXd& r) const override {
    const Limit& limit = limits_[element];
    const double arm = limit.scale * moment_arm(z.head<3>(), z[3]), share = torque_share(limit, z);
    r[0] = arm - share;
    r[1] = arm + share;
  }
  void jacobian(int element, const Eigen::VectorXd& z, Eigen::MatrixXd& jacobian) const override {
    const Limit& limit = limits_[element];
    const Arm arm = arm_at(z);
    for (int side = 0; side < 2; ++side) {
      jacobian.row(side).head<4>() = limit.scale * arm.gradient.transpose();
      jacobian(side, 4) = (side == 0 ? -1.0 : 1.0) / (limit.range * limit.torque);
    }
  }
  void add_curvature(int element, const Eigen::VectorXd& z, const Eigen::VectorXd& multiplier,
                     Eigen::MatrixXd& hessian) const override {
    hessian.topLeftCorner<4, 4>() +=
        limits_[element].scale * (multiplier[0] + multiplier[1]) * arm_at(z).hessian;
  }
  bool select_active(const Eigen::VectorXd& extended, std::vector<int>& active) const override {
    for (std::size_t k = 0; k < elements_.size(); ++k) {
      const std::vector<int>& slots = elements_[k].slots;
      const double arm =
          limits_[k].scale * moment_arm(extended.segment<3>(slots[0]), extended[slots[3]]);
      const double share = std::abs(extended[slots[4]]) / (limits_[k].range * limits_[k].torque);
      if (!(arm - share >= 1.0)) active.push_back(static_cast<int>(k));
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
    Eigen::VectorXd z(5);
    z << 0.08, 0.02 * part(random), (limit.scale > 0.0 ? 0.05 : -0.05) + 0.02 * part(random),
        angle(random), 0.0;
    z[4] = share(random) * std::abs(moment_arm(z.head<3>(), z[3])) * limit.torque;
    return z;
  }

 private:
  struct Limit {
    double scale;   // 1/(0.3 arm at home), with the arm's sign [1/leg length]
    double range;   // 0.3 |arm at home| [leg length]
    double torque;  // of the allowed force at an arm of one leg length [N m]
    std::string name;
  };
  /// The moment arm with its derivatives in (A, B, C, q).
  struct Arm {
    Eigen::Vector4d gradient;
    Eigen::Matrix4d hessian;
  };

  static double torque_share(const Limit& limit, const Eigen::VectorXd& z) {
    return z[4] / (limit.range * limit.torque);
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
    return {slope_first / (2 * length) - slope / (4 * l3) * first,
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
