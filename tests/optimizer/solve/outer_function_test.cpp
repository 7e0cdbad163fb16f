// SPDX-License-Identifier: Apache-2.0
// J of a function of the arrays: the same numbers as the terms that compute the same, and the chain
// rule through what follows from body and motion.
#include "optimizer/solve/outer_function.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "tests/support/puppy.hpp"

namespace legwright {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

Objective puppy_objective(const std::string& only = "") {
  test::Puppy puppy = test::make_puppy(true);
  test::print_bodies(puppy);
  Task task = test::make_sideways_task(false, 12);
  if (!only.empty())
    for (const TermEntry& entry : term_registry())
      task.weights[std::string(entry.name)] = entry.name == only ? 1.0 : 0.0;
  return {puppy.morphology, puppy.space, task};
}

/// ½ Σ (w a)² over all arrays, with weights that differ from entry to entry, and a product of two
/// of them.
double all_of_it(const MotionArrays& at, MotionArrays* gradient) {
  double value = 0.0;
  int count = 0;
  const auto add = [&](const auto& array, auto* slope) {
    for (Eigen::Index i = 0; i < array.size(); ++i) {
      const double weight = 0.5 + 0.01 * (++count % 17);
      value += 0.5 * weight * array.data()[i] * array.data()[i];
      if (slope != nullptr) slope->data()[i] = weight * array.data()[i];
    }
  };
  const bool wanted = gradient != nullptr;
  add(at.s, wanted ? &gradient->s : nullptr);
  add(at.joints, wanted ? &gradient->joints : nullptr);
  add(at.torques, wanted ? &gradient->torques : nullptr);
  add(at.root, wanted ? &gradient->root : nullptr);
  add(at.com, wanted ? &gradient->com : nullptr);
  add(at.feet, wanted ? &gradient->feet : nullptr);
  add(at.forces, wanted ? &gradient->forces : nullptr);
  add(at.mass, wanted ? &gradient->mass : nullptr);
  add(at.printed_volume, wanted ? &gradient->printed_volume : nullptr);
  value += at.mass[0] * at.torques(3, 1);
  if (wanted) {
    gradient->mass[0] += at.torques(3, 1);
    gradient->torques(3, 1) += at.mass[0];
  }
  return value;
}

class OuterFunctions : public testing::Test {
 protected:
  OuterFunctions() : objective_(puppy_objective()) {
    s_ = objective_.space().initial();
    m_ = initial_guess(objective_, s_);
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (int k = 0; k < m_.size(); ++k)
      m_[k] += 0.01 * objective_.motion_units()[k] * normal(random);
  }
  static Evaluation at(const OuterObjective& outer, const VectorXd& s, const VectorXd& m) {
    Evaluation out;
    outer.make_cost()->evaluate(s, m, Order::gradients, out);
    return out;
  }
  void expect_same(const OuterObjective& a, const OuterObjective& b) const {
    EXPECT_NEAR(a.reference(), b.reference(), 1e-12 * b.reference());
    const Evaluation ours = at(a, s_, m_), theirs = at(b, s_, m_);
    EXPECT_NEAR(ours.value, theirs.value, 1e-12 * std::abs(theirs.value));
    EXPECT_NEAR((ours.stationarity - theirs.stationarity).norm(), 0.0,
                1e-12 * theirs.stationarity.norm());
    EXPECT_GT(theirs.partial_s.norm(), 0.0);
    EXPECT_NEAR((ours.partial_s - theirs.partial_s).norm(), 0.0, 1e-12 * theirs.partial_s.norm());
  }
  Objective objective_;
  VectorXd s_, m_;
};

TEST_F(OuterFunctions, GradientsMatchDifferences) {
  const OuterFunction outer(objective_, all_of_it, "", 2.0, 3.0);
  const Evaluation here = at(outer, s_, m_);
  EXPECT_DOUBLE_EQ(here.value, 2.0 * outer.amount_at(s_, m_) / 3.0);
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const double h = 1e-6;
  for (int trial = 0; trial < 5; ++trial) {
    const VectorXd dm = VectorXd::NullaryExpr(m_.size(), [&] {
                          return normal(random);
                        }).cwiseProduct(objective_.motion_units());
    const VectorXd ds = VectorXd::NullaryExpr(s_.size(), [&] {
                          return normal(random);
                        }).cwiseProduct(objective_.space().scale());
    const auto J = [&](const VectorXd& s, const VectorXd& m) {
      return outer.cost(outer.amount_at(s, m));
    };
    const double by_m = (J(s_, m_ + h * dm) - J(s_, m_ - h * dm)) / (2 * h);
    const double by_s = (J(s_ + h * ds, m_) - J(s_ - h * ds, m_)) / (2 * h);
    EXPECT_NEAR(here.stationarity.dot(dm), by_m, 1e-6 * (1.0 + std::abs(by_m)));
    EXPECT_NEAR(here.partial_s.dot(ds), by_s, 1e-6 * (1.0 + std::abs(by_s)));
  }
}

TEST_F(OuterFunctions, WorkIsThatOfTheTerm) {
  const double epsilon = 1e-4 * objective_.morphology().total_mass() * kGravity *
                         objective_.morphology().leg_length;  // rounding of |work| at zero
  const MotionQuantity work = [&](const MotionArrays& at, MotionArrays* gradient) {
    const int T = static_cast<int>(at.joints.rows()) - 1;
    double sum = 0.0;
    for (int i = 0; i < T; ++i)
      for (int a = 0; a < at.joints.cols(); ++a) {
        const int before = i > 0 ? i - 1 : T - 1;
        const double step = 0.5 * (at.joints(i + 1, a) - at.joints(before, a));
        const double x = at.torques(i, a) * step, root = std::sqrt(x * x + epsilon * epsilon);
        sum += 0.5 * (x + root - epsilon);
        if (gradient == nullptr) continue;
        const double slope = 0.5 * (1.0 + x / root);
        gradient->torques(i, a) += slope * step;
        gradient->joints(i + 1, a) += 0.5 * slope * at.torques(i, a);
        gradient->joints(before, a) -= 0.5 * slope * at.torques(i, a);
      }
    return sum;
  };
  expect_same(OuterFunction(objective_, work, "J", 2.0, {}),
              OuterTerm(puppy_objective("mechanical_work"), "mechanical_work", 2.0));
}

TEST_F(OuterFunctions, VolumeIsThatOfTheTerm) {
  const MotionQuantity volume = [](const MotionArrays& at, MotionArrays* gradient) {
    if (gradient != nullptr) gradient->printed_volume[0] = 1.0;
    return at.printed_volume[0];
  };
  const OuterFunction ours(objective_, volume, "m^3", 2.0, {});
  const OuterTerm theirs(puppy_objective("printed_volume"), "printed_volume", 2.0);
  EXPECT_EQ(at(ours, s_, m_).stationarity.norm(), 0.0);
  expect_same(ours, theirs);
}

TEST_F(OuterFunctions, SwingHasNoForcesToMove) {
  const MotionQuantity forces = [](const MotionArrays& at, MotionArrays* gradient) {
    if (gradient != nullptr) gradient->forces.setOnes();
    return at.forces.sum();
  };
  const Evaluation here = at(OuterFunction(objective_, forces, "N", 1.0, 1.0), s_, m_);
  int standing = 0;
  for (int knot = 0; knot <= objective_.layout().knot_count(); ++knot)
    for (int foot = 0; foot < 4; ++foot)
      standing += objective_.layout().force(knot, foot) >= 0 ? 1 : 0;
  EXPECT_DOUBLE_EQ(here.stationarity.sum(), 3.0 * standing);
  EXPECT_LT(standing, 4 * 13);
}

TEST_F(OuterFunctions, NeedsAPositiveReference) {
  const MotionQuantity negative = [](const MotionArrays&, MotionArrays*) { return -1.0; };
  EXPECT_THROW(OuterFunction(objective_, negative, "", 1.0, {}), std::invalid_argument);
  EXPECT_NO_THROW(OuterFunction(objective_, negative, "", 1.0, 2.0));
}

TEST_F(OuterFunctions, IsNotAskedOfWhatIsNotFinite) {
  int calls = 0;
  const MotionQuantity counted = [&](const MotionArrays&, MotionArrays*) {
    ++calls;
    return 1.0;
  };
  const OuterFunction outer(objective_, counted, "", 1.0, 1.0);
  const int before = calls;
  m_[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(at(outer, s_, m_).value));
  EXPECT_EQ(calls, before);
}

}  // namespace
}  // namespace legwright
