// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "optimizer/terms/factories.hpp"

namespace legwright {
namespace {

constexpr double kWorkRounding = 1e-4;  // of |work| at zero, share of weight times length

/// Not in the paper, for outer objectives (weight zero unless asked for): positive mechanical work
/// of the motors over one cycle, Σ max(0, τ_a,i · Δq_a,i) over knots and joints, Δq = (q_{i+1} −
/// q_{i−1})/2; braking gives nothing back. Residual ½ (x + √(x² + ε²) − ε)/(weight · length),
/// x = τ Δq [J], counted as it is: value times weight times length is the work in joules.
class MechanicalWork final : public Term {
 public:
  explicit MechanicalWork(const TermContext& context) : unit_(context.weight * context.length) {
    const Layout& layout = context.layout;
    for (int i = 0; i < layout.knot_count(); ++i)
      for (int a = 0; a < layout.joint_count(); ++a) {
        const int before = i > 0 ? i - 1 : layout.knot_count() - 1;
        elements_.push_back(
            {i,
             -1,
             1,
             {layout.joint_torque(i, a), layout.pose(before) + 6 + a, layout.pose(i + 1) + 6 + a}});
        names_.push_back(context.morphology.links[a + 1].joint.name);
      }
  }
  std::string_view name() const override { return "mechanical_work"; }
  Penalty penalty() const override { return Penalty::linear; }

  void residual(int, const Eigen::VectorXd& z, Eigen::VectorXd& r) const override {
    const double epsilon = kWorkRounding * unit_;
    r[0] = 0.5 * (work(z) + root(z) - epsilon) / unit_;
  }
  void jacobian(int, const Eigen::VectorXd& z, Eigen::MatrixXd& jacobian) const override {
    jacobian = 0.5 * (1.0 + work(z) / root(z)) / unit_ * slope(z).transpose();
  }
  void add_curvature(int, const Eigen::VectorXd& z, const Eigen::VectorXd& multiplier,
                     Eigen::MatrixXd& hessian) const override {
    const double length = root(z), x = work(z), epsilon = kWorkRounding * unit_;
    const double first = 0.5 * multiplier[0] * (1.0 + x / length) / unit_;
    const double second =
        0.5 * multiplier[0] * epsilon * epsilon / (length * length * length * unit_);
    const Eigen::Vector3d g = slope(z);
    hessian += second * g * g.transpose();
    hessian(0, 1) -= 0.5 * first;
    hessian(1, 0) -= 0.5 * first;
    hessian(0, 2) += 0.5 * first;
    hessian(2, 0) += 0.5 * first;
  }
  ResidualUnit unit(int, int) const override { return {unit_, "J"}; }
  std::string subject(int element, int) const override { return names_[element]; }
  Eigen::VectorXd sample(int, std::mt19937& random) const override {
    std::normal_distribution<double> normal;
    return Eigen::Vector3d(0.1 * unit_ * (1.0 + 0.2 * normal(random)), 0.1 * normal(random),
                           0.5 + 0.1 * normal(random));
  }

 private:
  static double work(const Eigen::VectorXd& z) { return 0.5 * z[0] * (z[2] - z[1]); }
  static Eigen::Vector3d slope(const Eigen::VectorXd& z) {
    return {0.5 * (z[2] - z[1]), -0.5 * z[0], 0.5 * z[0]};
  }
  double root(const Eigen::VectorXd& z) const {
    const double x = work(z), epsilon = kWorkRounding * unit_;
    return std::sqrt(x * x + epsilon * epsilon);
  }

  double unit_;
  std::vector<std::string> names_;  // by element
};

}  // namespace

std::unique_ptr<Term> make_mechanical_work(const TermContext& context) {
  return std::make_unique<MechanicalWork>(context);
}

}  // namespace legwright
