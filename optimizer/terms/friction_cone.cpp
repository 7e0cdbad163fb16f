// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "optimizer/terms/factories.hpp"

namespace legwright {
namespace {

constexpr double kApex = 1e-3;  // rounding of the cone's apex, share of the weight

/// Eq (15): the contact force stays inside the friction cone, ‖f_t‖ ≤ μ f_n.
/// Residual (μ f_z − √(f_x² + f_y² + ε²))/weight ≥ 0, kept by the barrier. Rounded at the apex,
/// where the paper's norm has no derivative; not squared, because ‖f_t‖² ≤ μ² f_n² also admits
/// f_n < 0.
class FrictionCone final : public Term {
 public:
  explicit FrictionCone(const TermContext& context)
      : friction_(context.task.friction), weight_(context.weight) {
    const Layout& layout = context.layout;
    for (int i = 0; i < layout.knot_count(); ++i)
      for (int j = 0; j < layout.foot_count(); ++j)
        if (const int f = layout.force(i, j); f >= 0)
          elements_.push_back({i, j, 1, {f, f + 1, f + 2}});
  }
  std::string_view name() const override { return "friction_cone"; }
  ResidualUnit unit(int, int) const override { return {weight_, "N"}; }
  Penalty penalty() const override { return Penalty::barrier; }

  void residual(int, const Eigen::VectorXd& z, Eigen::VectorXd& r) const override {
    r[0] = (friction_ * z[2] - tangential(z)) / weight_;
  }
  void jacobian(int, const Eigen::VectorXd& z, Eigen::MatrixXd& jacobian) const override {
    const double t = tangential(z);
    jacobian << -z[0] / (t * weight_), -z[1] / (t * weight_), friction_ / weight_;
  }
  void add_curvature(int, const Eigen::VectorXd& z, const Eigen::VectorXd& multiplier,
                     Eigen::MatrixXd& hessian) const override {
    const double t = tangential(z), scale = -multiplier[0] / (t * weight_);
    const Eigen::Vector2d direction = z.head<2>() / t;
    hessian.topLeftCorner<2, 2>() +=
        scale * (Eigen::Matrix2d::Identity() - direction * direction.transpose());
  }
  Eigen::VectorXd sample(int, std::mt19937& random) const override {
    std::normal_distribution<double> normal;
    Eigen::Vector3d z(0.1 * weight_ * normal(random), 0.1 * weight_ * normal(random), 0.0);
    z[2] = (tangential(z) + 0.05 * weight_ * normal(random)) / friction_;
    return z;
  }

 private:
  double tangential(const Eigen::VectorXd& z) const {
    const double apex = kApex * weight_;
    return std::sqrt(z[0] * z[0] + z[1] * z[1] + apex * apex);
  }

  double friction_, weight_;
};

}  // namespace

std::unique_ptr<Term> make_friction_cone(const TermContext& context) {
  return std::make_unique<FrictionCone>(context);
}

}  // namespace legwright
