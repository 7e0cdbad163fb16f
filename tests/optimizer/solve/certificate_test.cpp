// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/certificate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/optimizer/solve/toy_cost.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;
using toy::kDesignSize;
using toy::kMotionSize;

WeightedCost task_of(CostFunction& cost) {
  WeightedCost task;
  task.cost = &cost;
  task.initial_motion = VectorXd::Zero(kMotionSize);
  return task;
}

CodesignResult solve(const WeightedCost& task, double half, bool motion_only = false) {
  CodesignOptions options;
  options.design_tolerance = 1e-7;
  options.value_tolerance = 1e-14;
  options.final_tolerance = 1e-10;
  options.motion_only = motion_only;
  return codesign({task}, toy::box(half), toy::box(half).initial(), options);
}

TEST(Certificate, ProvesAMinimum) {
  toy::CoupledCost cost(kMotionSize, kDesignSize);
  const WeightedCost task = task_of(cost);
  const CodesignResult result = solve(task, 10.0);
  const Certificate proof = certify({task}, toy::box(10.0), result.best);
  ASSERT_EQ(proof.tasks.size(), 1u);
  EXPECT_TRUE(proof.tasks[0].minimum_in_motion);
  EXPECT_TRUE(proof.tasks[0].resolved);
  EXPECT_LT(proof.tasks[0].stationarity, 1e-8);
  EXPECT_LT(proof.projected_gradient_norm, 1e-6);
  ASSERT_EQ(proof.curvatures.size(), kDesignSize);
  EXPECT_GT(proof.curvatures.minCoeff(), 0.0);
  EXPECT_TRUE(proof.active.empty());
}

TEST(Certificate, AdjointAndDifferencesAgreeAwayFromTheMinimum) {
  toy::CoupledCost cost(kMotionSize, kDesignSize);
  const WeightedCost task = task_of(cost);
  const CodesignResult result = solve(task, 10.0, true);
  const Certificate proof = certify({task}, toy::box(10.0), result.best);
  EXPECT_GT(proof.tasks[0].largest, 1e-2) << "nothing to compare";
  EXPECT_LT(proof.worst_gradient_error(), 1e-6);
}

// The chord method must find what Newton's method finds.
TEST(Certificate, DifferencesAreThoseOfMotionsSolvedByNewton) {
  toy::CoupledCost cost(kMotionSize, kDesignSize);
  const WeightedCost task = task_of(cost);
  const CodesignResult result = solve(task, 10.0, true);
  const CertificateOptions options;
  const Certificate proof = certify({task}, toy::box(10.0), result.best, options);
  NewtonOptions rules;
  rules.tolerance = 1e-11;
  NewtonWorkspace workspace;
  const VectorXd scale = toy::box(10.0).scale();
  for (int k = 0; k < kDesignSize; ++k) {
    const double h = options.step * scale[k];
    double sides = 0.0;
    for (const double sign : {1.0, -1.0}) {
      VectorXd s = result.best.s, m = result.best.tasks[0].m;
      s[k] += sign * h;
      sides += sign * newton(cost, s, m, rules, workspace).value;
    }
    EXPECT_NEAR(proof.tasks[0].difference[k], sides / (2.0 * h), 1e-9) << k;
  }
}

/// Its ∂F/∂m is right to so much only, as that of stiff terms is by rounding.
class Rough final : public CostFunction {
 public:
  explicit Rough(double roughness) : roughness_(roughness) {}
  void evaluate(const VectorXd& s, const VectorXd& m, Order order, Evaluation& out) override {
    inner_.evaluate(s, m, order, out);
    if (order < Order::gradient) return;
    for (int k = 0; k < out.stationarity.size(); ++k)
      out.stationarity[k] += roughness_ * std::sin(1e9 * m[k] + k);
    if (order == Order::hessian) ++hessians;
  }
  const VectorXd& motion_units() const override { return inner_.motion_units(); }
  int hessians = 0;

 private:
  double roughness_;
  toy::CoupledCost inner_{kMotionSize, kDesignSize};
};

TEST(Certificate, MotionsRestWhereRoundingKeepsTheGradientFromFalling) {
  for (const double roughness : {3e-9, 1e-7}) {
    Rough cost(roughness);
    const WeightedCost task = task_of(cost);
    CodesignOptions options;
    options.final_tolerance = 1e-6;
    options.motion_only = true;
    const CodesignResult result =
        codesign({task}, toy::box(10.0), toy::box(10.0).initial(), options);
    cost.hessians = 0;
    const Certificate proof = certify({task}, toy::box(10.0), result.best);
    EXPECT_TRUE(proof.tasks[0].resolved);
    EXPECT_LT(proof.worst_gradient_error(), 1e-5);
    EXPECT_EQ(cost.hessians, 0) << "one factor serves all differences, rough to " << roughness;
  }
}

TEST(Certificate, NamesActiveBoundsAndWhatTheyHoldBack) {
  toy::CoupledCost cost(kMotionSize, kDesignSize);
  const WeightedCost task = task_of(cost);
  const CodesignResult result = solve(task, 0.02);
  const Certificate proof = certify({task}, toy::box(0.02), result.best);
  ASSERT_FALSE(proof.active.empty());
  for (const ActiveBound& bound : proof.active)
    EXPECT_EQ(bound.upper, bound.gradient < 0.0) << "pushes outwards";
  EXPECT_EQ(proof.curvatures.size() + static_cast<long>(proof.active.size()), kDesignSize);
}

/// ∂F/∂s off by a tenth: a certificate must not be had for it.
class Wrong final : public CostFunction {
 public:
  void evaluate(const VectorXd& s, const VectorXd& m, Order order, Evaluation& out) override {
    inner_.evaluate(s, m, order, out);
    if (order >= Order::design) out.partial_s *= 1.1;
  }
  const VectorXd& motion_units() const override { return inner_.motion_units(); }

 private:
  toy::CoupledCost inner_{kMotionSize, kDesignSize};
};

TEST(Certificate, ShowsAWrongGradient) {
  Wrong cost;
  const WeightedCost task = task_of(cost);
  const CodesignResult result = solve(task, 10.0, true);
  EXPECT_GT(certify({task}, toy::box(10.0), result.best).worst_gradient_error(), 1e-2);
}

TEST(Certificate, ANumberThatIsNoneIsNoProof) {
  Certificate certificate;
  certificate.tasks.resize(1);
  certificate.tasks[0].adjoint = VectorXd::Ones(2);
  certificate.tasks[0].error = VectorXd::Zero(2);
  EXPECT_EQ(certificate.worst_gradient_error(), 0.0);
  certificate.tasks[0].error[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(std::isfinite(certificate.worst_gradient_error()));
}

TEST(Certificate, WithoutAMinimumThereIsNone) {
  const auto saddle = [](const VectorXd& m) {
    const Eigen::MatrixXd h = Eigen::Vector2d(1.0, -1.0).asDiagonal();
    return toy::MotionFunction::Derivatives{0.5 * m.dot(h * m), h * m, h};
  };
  class Saddle final : public CostFunction {
   public:
    explicit Saddle(toy::MotionFunction::Function f) : inner_(std::move(f), VectorXd::Ones(2)) {}
    void evaluate(const VectorXd& s, const VectorXd& m, Order order, Evaluation& out) override {
      inner_.evaluate(s, m, order, out);
      if (order < Order::design) return;
      out.partial_s = VectorXd::Zero(s.size());
      out.hessian_ms = Eigen::MatrixXd::Zero(2, s.size());
    }
    const VectorXd& motion_units() const override { return inner_.motion_units(); }

   private:
    toy::MotionFunction inner_;
  } cost(saddle);
  DesignIteration iterate;
  iterate.s = toy::box(1.0).initial();
  iterate.design_gradient = VectorXd::Zero(kDesignSize);
  iterate.tasks.resize(1);
  iterate.tasks[0].m = VectorXd::Zero(2);
  const Certificate proof = certify({task_of(cost)}, toy::box(1.0), iterate);
  EXPECT_FALSE(proof.tasks[0].minimum_in_motion);
  EXPECT_FALSE(std::isfinite(proof.worst_gradient_error()));
}

}  // namespace
}  // namespace legwright
