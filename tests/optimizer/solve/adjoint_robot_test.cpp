// SPDX-License-Identifier: Apache-2.0
// The adjoint on a real F: the puppy standing on the task of walking, with a cost that F does not
// contain.
#include <gtest/gtest.h>

#include "optimizer/solve/adjoint.hpp"
#include "optimizer/solve/newton.hpp"
#include "tests/support/puppy.hpp"
#include "tests/support/standing.hpp"

namespace legwright {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Foreign outer cost J(s, m) = ½ ‖m/unit − 1‖² + ½ ‖s/scale‖²: neither zero nor stationary at m*.
/// Its thighs hang freely, or so near the trunk that (16) has a say.
class PuppyAdjoint : public testing::TestWithParam<bool> {
 protected:
  static test::Puppy make() {
    test::Puppy puppy = test::make_puppy(true);
    if (GetParam()) test::add_capsules(puppy, 0.0, 0.04);
    return puppy;
  }
  static Task task() {
    Task task = test::make_sideways_task(false, 8);
    if (GetParam()) task.limb_pairs.emplace();  // of (16) the trunk alone
    return task;
  }
  PuppyAdjoint() : puppy_(make()), objective_(puppy_.morphology, puppy_.space, task()) {
    s_ = puppy_.space.initial();
    s_[6] = 0.5;   // front hips turned outwards: a body that can step sideways
    s_[12] = 0.5;  // hind hips
    m_ = solve(s_, test::standing_motion(objective_, s_));
  }
  VectorXd solve(const VectorXd& s, VectorXd m) const {
    const SolveReport report =
        newton(objective_, s, m, NewtonOptions{.tolerance = 1e-9, .max_iterations = 400});
    EXPECT_EQ(report.status, SolveStatus::converged) << report.stationarity;
    return m;
  }
  double outer(const VectorXd& s, const VectorXd& m) const {
    return 0.5 * (m.cwiseQuotient(objective_.motion_units()).array() - 1.0).matrix().squaredNorm() +
           0.5 * s.cwiseQuotient(puppy_.space.scale()).squaredNorm();
  }
  AdjointResult adjoint_at(const VectorXd& s, const VectorXd& m) const {
    const Evaluation at = objective_.evaluate(s, m, Order::design);
    const VectorXd units = objective_.motion_units(), scale = puppy_.space.scale();
    const VectorXd dJ_dm = (m.cwiseQuotient(units).array() - 1.0).matrix().cwiseQuotient(units);
    const VectorXd partial = s.cwiseQuotient(scale).cwiseQuotient(scale);
    HessianFactor factor;
    EXPECT_TRUE(factor.factor(at.hessian_mm, {}));
    return adjoint(factor, dJ_dm, at.hessian_ms, partial);
  }

  test::Puppy puppy_;
  Objective objective_;
  VectorXd s_, m_;
};

TEST_P(PuppyAdjoint, ForeignCostMatchesDifferencesOfTheResolvedMotion) {
  for (const TermValue& term : objective_.terms(s_, m_))
    if (GetParam() && term.name == "limb_clearance") {
      EXPECT_GT(term.value, 1e-9);
    }
  const AdjointResult result = adjoint_at(s_, m_);
  ASSERT_EQ(result.status, SolveStatus::converged);
  const VectorXd scale = puppy_.space.scale();
  VectorXd differences(s_.size());
  for (int k = 0; k < s_.size(); ++k) {
    const double step = 1e-5 * scale[k];  // third derivatives of some terms jump nearby
    VectorXd up = s_, down = s_;
    up[k] += step;
    down[k] -= step;
    differences[k] = (outer(up, solve(up, m_)) - outer(down, solve(down, m_))) / (2 * step);
  }
  const VectorXd error = scale.cwiseProduct(result.dJ_ds - differences);
  const double size = scale.cwiseProduct(differences).lpNorm<Eigen::Infinity>();
  EXPECT_LT(error.lpNorm<Eigen::Infinity>() / size, 1e-5);
  // Negative control: without the adjoint part the gradient is far off.
  const VectorXd partial = s_.cwiseQuotient(scale);
  EXPECT_GT((scale.cwiseProduct(differences) - partial).lpNorm<Eigen::Infinity>() / size, 1e-2);
}

INSTANTIATE_TEST_SUITE_P(Robots, PuppyAdjoint, testing::Bool(), [](const auto& instance) {
  return instance.param ? "BesideItsTrunk" : "Free";
});

}  // namespace
}  // namespace legwright
