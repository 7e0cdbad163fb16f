// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "optimizer/motion/limited_motors.hpp"
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"
#include "optimizer/terms/penalty.hpp"

namespace legwright {
namespace {

/// Not in the paper: no motor exerts more than its torque limit, less the task's margin, nor more
/// than it has left at its speed. The torque is that of inverse dynamics (Layout::joint_torque),
/// the speed ω that of the angles a knot before and after. Residuals (1 ∓ used)/0.3 ≥ 0 with
///   used = τ/allowed,   allowed = (1 − margin)·limit,
/// and where the motor is known besides
///   used = τ/((1 − margin)·stall torque) + ω/no-load speed,
/// kept by a barrier that is zero up to 0.7 of what is allowed; motors without a limit have none.
class TorqueLimits final : public LinearTerm {
 public:
  explicit TorqueLimits(const TermContext& context)
      : motors_(limited_motors(context.morphology, context.layout)),
        running_(motors_at_speed(context.morphology, context.layout)),
        two_steps_(2.0 * context.task.gait.time_step()) {
    Eigen::MatrixXd sides(2, 1);
    sides << -1.0, 1.0;
    const Eigen::VectorXd target = Eigen::VectorXd::Constant(2, -1.0 / kTorqueBarrierRange);
    for (LimitedMotor& motor : motors_) {
      motor.limit *= 1.0 - context.task.torque_margin;
      add(motor.knot, -1, {{motor.slot, sides / (kTorqueBarrierRange * motor.limit)}}, target);
    }
    for (MotorAtSpeed& motor : running_) {
      motor.stall_torque *= 1.0 - context.task.torque_margin;
      const Eigen::MatrixXd by_angle =
          sides / (kTorqueBarrierRange * two_steps_ * motor.no_load_speed);
      add(motor.knot, -1,
          {{motor.torque_slot, sides / (kTorqueBarrierRange * motor.stall_torque)},
           {motor.before_slot, -by_angle},
           {motor.after_slot, by_angle}},
          target);
    }
  }
  std::string_view name() const override { return "torque_limits"; }
  Penalty penalty() const override { return Penalty::near_only; }

  bool select_active(const Eigen::VectorXd& extended, std::vector<int>& active) const override {
    const auto is_far = [](double used, double of) {
      return std::abs(used) <= (1.0 - kTorqueBarrierRange) * of;
    };
    const std::size_t count = motors_.size();
    for (std::size_t k = 0; k < count; ++k)
      if (!is_far(extended[motors_[k].slot], motors_[k].limit))
        active.push_back(static_cast<int>(k));
    for (std::size_t k = 0; k < running_.size(); ++k)
      if (!is_far(used(running_[k], extended), 1.0)) active.push_back(static_cast<int>(count + k));
    return true;
  }
  ResidualUnit unit(int element, int) const override {
    const MotorAtSpeed* const motor = running(element);
    const double allowed = motor ? motor->stall_torque : motors_[element].limit;
    return {kTorqueBarrierRange * allowed, "N m"};
  }
  std::string subject(int element, int) const override {
    const MotorAtSpeed* const motor = running(element);
    return motor ? motor->name + " at its speed" : motors_[element].name;
  }
  Eigen::VectorXd sample(int element, std::mt19937& random) const override {
    std::normal_distribution<double> normal;
    const double share = 1.0 + 0.2 * normal(random);
    const MotorAtSpeed* const motor = running(element);
    if (!motor) return Eigen::VectorXd::Constant(1, motors_[element].limit * share);
    const double turned = 0.4 * two_steps_ * motor->no_load_speed;
    return Eigen::Vector3d(motor->stall_torque * (share - 0.4), 0.1, 0.1 + turned);
  }

 private:
  /// Of what the motor has, at [s; m; y]: by torque and speed together.
  double used(const MotorAtSpeed& motor, const Eigen::VectorXd& x) const {
    const double turned = x[motor.after_slot] - x[motor.before_slot];
    return x[motor.torque_slot] / motor.stall_torque + turned / (two_steps_ * motor.no_load_speed);
  }
  /// Of an element of the second kind.
  const MotorAtSpeed* running(int element) const {
    const auto k = static_cast<std::size_t>(element);
    return k < motors_.size() ? nullptr : &running_[k - motors_.size()];
  }

  std::vector<LimitedMotor> motors_;   // of the first elements; limits less the margin
  std::vector<MotorAtSpeed> running_;  // of the others; likewise
  double two_steps_;                   // [s]
};

}  // namespace

std::unique_ptr<Term> make_torque_limits(const TermContext& context) {
  return std::make_unique<TorqueLimits>(context);
}

}  // namespace legwright
