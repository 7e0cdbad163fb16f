// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "optimizer/motion/limited_motors.hpp"
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"
#include "optimizer/terms/penalty.hpp"

namespace legwright {
namespace {

/// Not in the paper: no motor exerts more than its torque limit, less the task's margin. The torque
/// is that of inverse dynamics (Layout::joint_torque). Residuals (1 ∓ τ/allowed)/0.3 ≥ 0,
/// allowed = (1 − margin)·limit, kept by a barrier that is zero up to 0.7 of what is allowed;
/// motors without a limit have none.
class TorqueLimits final : public LinearTerm {
 public:
  explicit TorqueLimits(const TermContext& context)
      : motors_(limited_motors(context.morphology, context.layout)) {
    Eigen::MatrixXd sides(2, 1);
    sides << -1.0, 1.0;
    for (LimitedMotor& motor : motors_) {
      motor.limit *= 1.0 - context.task.torque_margin;
      add(motor.knot, -1, {{motor.slot, sides / (kTorqueBarrierRange * motor.limit)}},
          Eigen::VectorXd::Constant(2, -1.0 / kTorqueBarrierRange));
    }
  }
  std::string_view name() const override { return "torque_limits"; }
  Penalty penalty() const override { return Penalty::near_only; }

  bool select_active(const Eigen::VectorXd& extended, std::vector<int>& active) const override {
    for (std::size_t k = 0; k < elements_.size(); ++k)
      if (!(std::abs(extended[elements_[k].slots[0]]) <=
            (1.0 - kTorqueBarrierRange) * motors_[k].limit))
        active.push_back(static_cast<int>(k));
    return true;
  }
  ResidualUnit unit(int element, int) const override {
    return {kTorqueBarrierRange * motors_[element].limit, "N m"};
  }
  std::string subject(int element, int) const override { return motors_[element].name; }
  Eigen::VectorXd sample(int element, std::mt19937& random) const override {
    std::normal_distribution<double> normal;
    return Eigen::VectorXd::Constant(1, motors_[element].limit * (1.0 + 0.2 * normal(random)));
  }

 private:
  std::vector<LimitedMotor> motors_;  // by element; limits less the margin
};

}  // namespace

std::unique_ptr<Term> make_torque_limits(const TermContext& context) {
  return std::make_unique<TorqueLimits>(context);
}

}  // namespace legwright
