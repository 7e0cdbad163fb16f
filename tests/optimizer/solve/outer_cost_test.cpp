// SPDX-License-Identifier: Apache-2.0
// J on a real robot: its gradients, and that the peak it tells is the largest torque or a bit more.
#include "optimizer/solve/outer_cost.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <string>

#include "tests/support/puppy.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

class OuterCosts : public testing::TestWithParam<const char*> {
 protected:
  static OuterTerm make(const std::string& term, double weight) {
    test::Puppy puppy = test::make_puppy(true);
    test::print_bodies(puppy);
    for (Link& link : puppy.morphology.links) {
      link.joint.servo_kp = 80.0;
      link.joint.servo_kd = 0.8;
    }
    Task task = test::make_sideways_task(false, 12);
    for (const TermEntry& entry : term_registry())
      task.weights[std::string(entry.name)] = entry.name == term ? 1.0 : 0.0;
    return {Objective(puppy.morphology, puppy.space, task), term, weight};
  }
  OuterCosts() : outer_(make(GetParam(), 3.0)), cost_(outer_.make_cost()) {
    s_ = outer_.quantity().space().initial();
    m_ = initial_guess(outer_.quantity(), s_);
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (int k = 0; k < m_.size(); ++k) m_[k] += 0.01 * cost_->motion_units()[k] * normal(random);
  }
  double value(const VectorXd& s, const VectorXd& m) {
    Evaluation at;
    cost_->evaluate(s, m, Order::value, at);
    return at.value;
  }
  OuterTerm outer_;
  std::unique_ptr<CostFunction> cost_;
  VectorXd s_, m_;
};

TEST_P(OuterCosts, GradientsMatchDifferences) {
  Evaluation at;
  cost_->evaluate(s_, m_, Order::gradients, at);
  EXPECT_DOUBLE_EQ(at.value, value(s_, m_));
  const VectorXd units = cost_->motion_units(), scale = outer_.quantity().space().scale();
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const double h = 1e-6;
  for (int trial = 0; trial < 5; ++trial) {
    const VectorXd u = VectorXd::NullaryExpr(m_.size(), [&] { return normal(random); });
    const VectorXd v = VectorXd::NullaryExpr(s_.size(), [&] { return normal(random); });
    const VectorXd dm = u.cwiseProduct(units), ds = v.cwiseProduct(scale);
    const double by_m = (value(s_, m_ + h * dm) - value(s_, m_ - h * dm)) / (2 * h);
    const double by_s = (value(s_ + h * ds, m_) - value(s_ - h * ds, m_)) / (2 * h);
    EXPECT_NEAR(at.stationarity.dot(dm), by_m, 1e-5 * (1.0 + std::abs(by_m)));
    EXPECT_NEAR(at.partial_s.dot(ds), by_s, 1e-5 * (1.0 + std::abs(by_s)));
  }
}

TEST_P(OuterCosts, IsWeightTimesShareOfTheReference) {
  const double amount = outer_.amount_at(s_, m_);
  EXPECT_GT(amount, 0.0);
  EXPECT_DOUBLE_EQ(value(s_, m_), 3.0 * amount / outer_.reference());
}

INSTANTIATE_TEST_SUITE_P(Terms, OuterCosts,
                         testing::Values("mechanical_work", "peak_torque", "printed_volume"),
                         [](const auto& instance) { return std::string(instance.param); });

TEST(OuterCost, APeakIsTheLargestOfAllTorques) {
  // n equal torques have a p-norm of n^(1/p) times one of them.
  test::Puppy puppy = test::make_puppy(true);
  Task task = test::make_sideways_task(false, 12);
  for (const TermEntry& entry : term_registry())
    task.weights[std::string(entry.name)] = entry.name == "peak_torque" ? 1.0 : 0.0;
  const OuterTerm outer(Objective(puppy.morphology, puppy.space, task), "peak_torque", 1.0);
  const double unit = 2.0 * outer.reference();
  EXPECT_NEAR(outer.amount(std::pow(0.5, kPeakNorm)), 0.5 * unit, 1e-12);
  EXPECT_NEAR(outer.amount(100 * std::pow(0.5, kPeakNorm)), 0.5 * unit * std::pow(100.0, 1.0 / 16),
              1e-12);
  EXPECT_EQ(outer.amount(0.0), 0.0);
}

TEST(OuterCost, RefusesWhatABodyHasNothingOf) {
  test::Puppy puppy = test::make_puppy(true);  // nothing of it is printed
  Task task = test::make_sideways_task(false, 12);
  for (const TermEntry& entry : term_registry())
    task.weights[std::string(entry.name)] = entry.name == "printed_volume" ? 1.0 : 0.0;
  EXPECT_THROW(OuterTerm(Objective(puppy.morphology, puppy.space, task), "printed_volume", 1.0),
               std::invalid_argument);
}

}  // namespace
}  // namespace legwright
