// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "optimizer/motion/limited_motors.hpp"
#include "optimizer/terms/factories.hpp"

namespace legwright {
namespace {

/// Not in the paper, for outer objectives (weight zero unless asked for): the largest torque of any
/// motor at any knot as a share of its limit, by the 8-norm, which a smooth maximum needs no
/// rounding for. Residual (τ/limit)⁴, counted ½ r², so that the term is half the eighth power of
/// the norm and stays a sum over knots and joints: the peak is about (2 · value)^(1/8). Motors
/// without a limit count nothing.
class PeakTorque final : public Term {
 public:
  explicit PeakTorque(const TermContext& context)
      : motors_(limited_motors(context.morphology, context.layout)) {
    for (const LimitedMotor& motor : motors_)
      elements_.push_back({motor.knot, -1, 1, {motor.slot}});
  }
  std::string_view name() const override { return "peak_torque"; }

  void residual(int element, const Eigen::VectorXd& z, Eigen::VectorXd& r) const override {
    r[0] = std::pow(z[0] / motors_[element].limit, 4);
  }
  void jacobian(int element, const Eigen::VectorXd& z, Eigen::MatrixXd& jacobian) const override {
    const double limit = motors_[element].limit;
    jacobian(0, 0) = 4.0 * std::pow(z[0] / limit, 3) / limit;
  }
  void add_curvature(int element, const Eigen::VectorXd& z, const Eigen::VectorXd& multiplier,
                     Eigen::MatrixXd& hessian) const override {
    const double limit = motors_[element].limit;
    hessian(0, 0) += multiplier[0] * 12.0 * std::pow(z[0] / limit, 2) / (limit * limit);
  }
  std::string subject(int element, int) const override { return motors_[element].name; }
  Eigen::VectorXd sample(int element, std::mt19937& random) const override {
    std::normal_distribution<double> normal;
    return Eigen::VectorXd::Constant(1, motors_[element].limit * (0.5 + 0.3 * normal(random)));
  }

 private:
  std::vector<LimitedMotor> motors_;  // by element
};

}  // namespace

std::unique_ptr<Term> make_peak_torque(const TermContext& context) {
  return std::make_unique<PeakTorque>(context);
}

}  // namespace legwright
