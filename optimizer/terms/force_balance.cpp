// SPDX-License-Identifier: Apache-2.0
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Eq (13), first half, with the gravity that the paper's print leaves out: Σ_j f_iʲ = M (ẍ_i + g),
/// g along the task's up. Residual over the weight; ẍ_i = (x_{i−1} − 2 x_i + x_{i+1})/h². Before
/// knot 0 stands knot T − 1 moved back by one cycle.
class ForceBalance final : public LinearTerm {
 public:
  explicit ForceBalance(const TermContext& context) : weight_(context.weight) {
    const Layout& layout = context.layout;
    const double h = context.task.gait.time_step(),
                 inertia = context.mass / (h * h * context.weight);
    const WantedPath& path = context.path;
    for (int i = 0; i < layout.knot_count(); ++i) {
      Eigen::Vector3d target = context.mass * kGravity / context.weight * context.task.up;
      std::vector<Block> blocks{{layout.com(i), times(2 * inertia)},
                                {layout.com(i + 1), times(-inertia)}};
      if (i > 0) {
        blocks.push_back({layout.com(i - 1), times(-inertia)});
      } else {
        const Eigen::Matrix3d back = path.turn().transpose();
        blocks.push_back({layout.com(layout.knot_count() - 1), -inertia * back});
        target -= inertia * back * path.travel();
      }
      for (int j = 0; j < layout.foot_count(); ++j)
        if (layout.force(i, j) >= 0)
          blocks.push_back({layout.force(i, j), times(1.0 / context.weight)});
      add(i, -1, blocks, target);
    }
  }
  std::string_view name() const override { return "force_balance"; }
  ResidualUnit unit(int, int) const override { return {weight_, "N"}; }

 private:
  double weight_;
};

/// The same for a robot whose mass depends on its design: Σ_j f_iʲ = μ(s) M₀ (ẍ_i + g) with the
/// mass share μ.
class GrowingForceBalance final : public Term {
 public:
  explicit GrowingForceBalance(const TermContext& context)
      : path_(context.path), up_(context.task.up), weight_(context.weight) {
    const Layout& layout = context.layout;
    const double h = context.task.gait.time_step();
    inertia_ = context.mass / (h * h * context.weight);
    for (int i = 0; i < layout.knot_count(); ++i) {
      Element element{i, -1, 3, {layout.mass_share()}};
      const auto push = [&element](int slot) {
        for (int k = 0; k < 3; ++k) element.slots.push_back(slot + k);
      };
      push(layout.com(i > 0 ? i - 1 : layout.knot_count() - 1));
      push(layout.com(i));
      push(layout.com(i + 1));
      for (int j = 0; j < layout.foot_count(); ++j)
        if (layout.force(i, j) >= 0) push(layout.force(i, j));
      elements_.push_back(std::move(element));
    }
  }
  std::string_view name() const override { return "force_balance"; }
  void residual(int element, const Eigen::VectorXd& z, Eigen::VectorXd& r) const override {
    r = -z[0] * wanted(element, z);
    for (Eigen::Index k = kForces; k < z.size(); k += 3) r += z.segment<3>(k) / weight_;
  }
  void jacobian(int element, const Eigen::VectorXd& z, Eigen::MatrixXd& jacobian) const override {
    jacobian.col(0) = -wanted(element, z);
    for (int at = 0; at < 3; ++at) jacobian.middleCols<3>(1 + 3 * at) = -z[0] * share(element, at);
    for (Eigen::Index k = kForces; k < z.size(); k += 3)
      jacobian.middleCols<3>(k) = Eigen::Matrix3d::Identity() / weight_;
  }
  void add_curvature(int element, const Eigen::VectorXd&, const Eigen::VectorXd& multiplier,
                     Eigen::MatrixXd& hessian) const override {
    for (int at = 0; at < 3; ++at) {
      const Eigen::Vector3d mixed = -share(element, at).transpose() * multiplier.head<3>();
      hessian.block<3, 1>(1 + 3 * at, 0) += mixed;
      hessian.block<1, 3>(0, 1 + 3 * at) += mixed.transpose();
    }
  }
  ResidualUnit unit(int, int) const override { return {weight_, "N"}; }
  Eigen::VectorXd sample(int element, std::mt19937& random) const override {
    std::normal_distribution<double> normal;
    Eigen::VectorXd z(static_cast<int>(elements_[element].slots.size()));
    for (double& value : z) value = 0.1 * normal(random);
    z[0] = 1.0 + 0.2 * normal(random);
    for (Eigen::Index k = kForces; k < z.size(); ++k) z[k] *= weight_;
    return z;
  }

 private:
  static constexpr int kForces = 10;

  /// ∂(ẍ M₀/weight) by the place at the knot before, at, after; before knot 0 stands knot T − 1,
  /// moved back.
  Eigen::Matrix3d share(int knot, int at) const {
    if (at == 0 && knot == 0) return inertia_ * path_.turn().transpose();
    return (at == 1 ? -2.0 : 1.0) * inertia_ * Eigen::Matrix3d::Identity();
  }
  /// M₀ (ẍ + g)/weight.
  Eigen::Vector3d wanted(int knot, const Eigen::VectorXd& z) const {
    Eigen::Vector3d before = z.segment<3>(1);
    if (knot == 0) before -= path_.travel();
    return share(knot, 0) * before + share(knot, 1) * z.segment<3>(4) +
           share(knot, 2) * z.segment<3>(7) + up_;
  }

  WantedPath path_;
  Eigen::Vector3d up_;
  double weight_, inertia_ = 0.0;
};

}  // namespace

std::unique_ptr<Term> make_force_balance(const TermContext& context) {
  if (context.morphology.grows()) return std::make_unique<GrowingForceBalance>(context);
  return std::make_unique<ForceBalance>(context);
}

}  // namespace legwright
