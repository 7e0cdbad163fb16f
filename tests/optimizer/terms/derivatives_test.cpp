// SPDX-License-Identifier: Apache-2.0
// Every term of the registry on its own: residual, Jacobian and curvature in its local variables. A
// new term is covered as soon as it has its row in the registry.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <set>

#include "optimizer/terms/registry.hpp"
#include "tests/optimizer/terms/term_bench.hpp"
#include "tests/support/puppy.hpp"
#include "tests/support/term_context.hpp"

namespace legwright {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd jacobian(const Term& term, int element, const VectorXd& z) {
  MatrixXd out = MatrixXd::Zero(term.elements()[element].rows, z.size());
  term.jacobian(element, z, out);
  return out;
}

VectorXd residual(const Term& term, int element, const VectorXd& z) {
  VectorXd out(term.elements()[element].rows);
  term.residual(element, z, out);
  return out;
}

/// Largest relative error of the Jacobian and of the contracted second derivative against central
/// differences.
double worst_error(const Term& term, int element, const VectorXd& z, std::mt19937& random) {
  const int n = static_cast<int>(z.size()), rows = term.elements()[element].rows;
  std::normal_distribution<double> normal;
  VectorXd multiplier(rows);
  for (double& value : multiplier) value = normal(random);
  MatrixXd numeric(rows, n), curvature = MatrixXd::Zero(n, n), numeric_curvature(n, n);
  term.add_curvature(element, z, multiplier, curvature);
  for (int k = 0; k < n; ++k) {
    const double step = 1e-5 * (1.0 + std::abs(z[k]));
    VectorXd up = z, down = z;
    up[k] += step;
    down[k] -= step;
    numeric.col(k) = (residual(term, element, up) - residual(term, element, down)) / (2 * step);
    numeric_curvature.col(k) =
        (jacobian(term, element, up) - jacobian(term, element, down)).transpose() * multiplier /
        (2 * step);
  }
  const auto relative = [](const MatrixXd& a, const MatrixXd& b) {
    return (a - b).cwiseAbs().maxCoeff() /
           std::max(1e-9, std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()));
  };
  const double asymmetry = (curvature - curvature.transpose()).cwiseAbs().maxCoeff();
  if (!term.curved() && curvature.norm() > 0.0) return 1.0;
  return std::max({relative(jacobian(term, element, z), numeric),
                   relative(curvature, numeric_curvature), asymmetry});
}

std::set<int> probes(const Term& term) {
  const int last = static_cast<int>(term.elements().size()) - 1;
  return {0, last / 2, last};
}

class TermDerivatives : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<Term> make(bool printed = false) const {
    for (const TermEntry& entry : term_registry())
      if (entry.name == GetParam()) return entry.make((printed ? printed_ : setting_).context());
    return nullptr;
  }
  test::TermSetting setting_, printed_{true};
};

TEST_P(TermDerivatives, MatchCentralDifferences) {
  for (const bool printed : {false, true}) {
    const std::unique_ptr<Term> term = make(printed);
    ASSERT_FALSE(term->elements().empty());
    std::mt19937 random(3);
    for (int element : probes(*term))
      for (int repeat = 0; repeat < 20; ++repeat)
        EXPECT_LT(worst_error(*term, element, term->sample(element, random), random), 1e-6)
            << "element " << element << (printed ? " of the printed robot" : "");
  }
}

TEST_P(TermDerivatives, SamplesAreWorthChecking) {
  const std::unique_ptr<Term> term = make();
  std::mt19937 random(4);
  bool above = false, below = false;
  for (int repeat = 0; repeat < 200; ++repeat) {
    const VectorXd r = residual(*term, 0, term->sample(0, random));
    EXPECT_GT(r.norm(), 0.0);
    above |= r[0] > 0.02;
    below |= r[0] < 0.02;
  }
  EXPECT_TRUE(above && below) << "one side of the barrier's edge was never seen";
}

TEST_P(TermDerivatives, NameIsTheRegistrys) { EXPECT_EQ(make()->name(), GetParam()); }

INSTANTIATE_TEST_SUITE_P(Registry, TermDerivatives, testing::ValuesIn(test::registered_terms()),
                         [](const auto& instance) { return instance.param; });

TEST(TermDerivativesOfConstantInertia, MatchCentralDifferences) {
  for (const bool printed : {false, true}) {
    test::TermSetting setting(printed);
    setting.task.dynamics = Dynamics::constant_inertia;
    const std::unique_ptr<Term> term = find_term("torque_balance")->make(setting.context());
    EXPECT_EQ(term->name(), "torque_balance");
    std::mt19937 random(3);
    for (int element : probes(*term))
      for (int repeat = 0; repeat < 20; ++repeat)
        EXPECT_LT(worst_error(*term, element, term->sample(element, random), random), 1e-6)
            << "element " << element;
  }
}

/// A term with one wrong entry, which the checker above must see.
class Poisoned final : public Term {
 public:
  Poisoned(std::unique_ptr<Term> inner, bool poison_jacobian)
      : inner_(std::move(inner)), jacobian_(poison_jacobian) {
    elements_ = inner_->elements();
  }
  std::string_view name() const override { return inner_->name(); }
  void residual(int e, const VectorXd& z, VectorXd& r) const override { inner_->residual(e, z, r); }
  void jacobian(int e, const VectorXd& z, MatrixXd& J) const override {
    inner_->jacobian(e, z, J);
    if (jacobian_) J(0, 0) += 1e-4 * J.cwiseAbs().maxCoeff();
  }
  void add_curvature(int e, const VectorXd& z, const VectorXd& multiplier,
                     MatrixXd& H) const override {
    inner_->add_curvature(e, z, multiplier, H);
    if (!jacobian_) H(0, 0) += 1e-4 * H.cwiseAbs().maxCoeff();
  }
  VectorXd sample(int e, std::mt19937& random) const override { return inner_->sample(e, random); }

 private:
  std::unique_ptr<Term> inner_;
  bool jacobian_;
};

TEST(TermDerivativesControl, PoisonIsNoticed) {
  const test::TermSetting setting;
  for (const bool in_jacobian : {true, false}) {
    for (const TermEntry& entry : term_registry()) {
      if (entry.name != "torque_balance" && entry.name != "friction_cone") continue;
      const Poisoned term(entry.make(setting.context()), in_jacobian);
      std::mt19937 random(5);
      EXPECT_GT(worst_error(term, 0, term.sample(0, random), random), 1e-6) << entry.name;
    }
  }
}

}  // namespace
}  // namespace legwright
