// SPDX-License-Identifier: Apache-2.0
// Why a body changed: shares of terms along a path of designs, and what of them is worth naming.
#include "optimizer/solve/attribution.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer/solve/hessian_factor.hpp"
#include "optimizer/solve/newton.hpp"
#include "tests/support/puppy.hpp"
#include "tests/support/standing.hpp"

namespace legwright {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The puppy with its hips turned outwards, so that it can step sideways, and its best motion.
class AttributionOfThePuppy : public testing::Test {
 protected:
  AttributionOfThePuppy()
      : objective_(puppy_.morphology, puppy_.space, test::make_sideways_task(false, 8)),
        s_(puppy_.space.initial()) {
    s_[6] = s_[12] = 0.5;
    m_ = solved(s_, test::standing_motion(objective_, s_));
  }
  VectorXd solved(const VectorXd& s, VectorXd m) const {
    EXPECT_EQ(newton(objective_, s, m, {.tolerance = 1e-9, .max_iterations = 400}).status,
              SolveStatus::converged);
    return m;
  }
  MatrixXd sensitivity(const VectorXd& s, const VectorXd& m) const {
    const Evaluation at = objective_.evaluate(s, m, Order::design);
    HessianFactor factor;
    EXPECT_TRUE(factor.factor(at.hessian_mm, {}));
    MatrixXd x;
    EXPECT_TRUE(factor.solve(at.hessian_ms, x));
    return -x;
  }
  double value(const VectorXd& s, const VectorXd& m) const {
    return objective_.evaluate(s, m, Order::value).value;
  }
  void add(AttributionAlongPath& path, const VectorXd& s, const VectorXd& m) const {
    path.add(objective_, s, m, sensitivity(s, m));
  }

  const test::Puppy puppy_ = test::make_puppy(true);
  const Objective objective_;
  VectorXd s_, m_;
};

TEST_F(AttributionOfThePuppy, SharesOfAllTermsMakeTheDecreaseOfF) {
  VectorXd s = s_;
  s[6] += 0.004;
  s[18] *= 1.004;
  const VectorXd m = solved(s, m_);
  AttributionAlongPath path;
  add(path, s_, m_);
  EXPECT_EQ(path.decrease().norm(), 0.0);
  add(path, s, m);
  const double fallen = value(s_, m_) - value(s, m);
  EXPECT_GT(std::abs(fallen), 1e-3);
  EXPECT_NEAR(path.decrease().sum(), fallen, 1e-9 * std::abs(fallen));
  EXPECT_LT(path.spread(), 1e-2 * std::abs(fallen)) << "derivatives along m*(s) explain nearly all";
  for (int k = 0; k < path.decrease().cols(); ++k) {
    if (k != 6 && k != 18) {
      EXPECT_EQ(path.decrease().col(k).norm(), 0.0) << "parameter " << k << " did not change";
    }
  }
  // Without dm/ds the shares are those at fixed m, and miss what the motion makes of them.
  AttributionAlongPath fixed;
  fixed.add(objective_, s_, m_, {});
  fixed.add(objective_, s, m, {});
  EXPECT_GT((fixed.decrease() - path.decrease()).norm(), 0.1 * path.decrease().norm());
}

TEST_F(AttributionOfThePuppy, PathsThatFollowEachOtherAddUp) {
  VectorXd half = s_, s = s_;
  half[6] += 0.002;
  s[6] += 0.004;
  const VectorXd m_half = solved(half, m_), m = solved(s, m_half);
  AttributionAlongPath whole, first, second;
  add(whole, s_, m_);
  add(whole, half, m_half);
  add(whole, s, m);
  add(first, s_, m_);
  add(first, half, m_half);
  add(second, half, m_half);
  add(second, s, m);
  second.follow(first);
  EXPECT_LT((second.decrease() - whole.decrease()).norm(), 1e-12 * whole.decrease().norm());
  EXPECT_NEAR(second.spread(), whole.spread(), 1e-12 * whole.spread());
  AttributionAlongPath late;  // knows nothing of its own
  late.follow(whole);
  EXPECT_EQ(late.decrease(), whole.decrease());
  EXPECT_EQ(late.by_parameter(puppy_.space, 1.0)[6].shares.size(),
            whole.by_parameter(puppy_.space, 1.0)[6].shares.size());
}

TEST_F(AttributionOfThePuppy, ByParameterTheLargestFirstAndNoTrifles) {
  VectorXd s = s_;
  s[6] += 0.004;
  AttributionAlongPath path;
  add(path, s_, m_);
  add(path, s, solved(s, m_));
  const std::vector<Attribution> by_parameter = path.by_parameter(puppy_.space, 0.5);
  ASSERT_EQ(by_parameter.size(), static_cast<std::size_t>(puppy_.space.size()));
  const double largest = 0.5 * path.decrease().cwiseAbs().maxCoeff();
  EXPECT_EQ(largest_share(by_parameter), largest);
  for (std::size_t k = 0; k < by_parameter.size(); ++k) {
    EXPECT_EQ(by_parameter[k].parameter, puppy_.space.parameters[k].name);
    EXPECT_EQ(by_parameter[k].shares.empty(), k != 6);
  }
  double last = largest;
  for (const AttributionShare& share : by_parameter[6].shares) {
    EXPECT_LE(std::abs(share.decrease), last);
    last = std::abs(share.decrease);
    EXPECT_GT(last, 0.01 * largest);
    EXPECT_EQ(share.task, "");
  }
  const auto kept = (path.decrease().col(6).cwiseAbs().array() > 0.02 * largest).count();
  EXPECT_EQ(by_parameter[6].shares.size(), static_cast<std::size_t>(kept));
}

Attribution make(std::string parameter, std::vector<AttributionShare> shares) {
  sort_by_size(shares);
  return {std::move(parameter), std::move(shares)};
}

std::vector<std::string> terms_of(const std::vector<AttributionShare>& shares) {
  std::vector<std::string> out;
  for (const AttributionShare& share : shares) out.push_back(share.term);
  return out;
}

using Names = std::vector<std::string>;

TEST(Attribution, MainSharesAreFewAndAboveTheThresholds) {
  const Attribution yaw =
      make("yaw", {{"", "a", -1.6}, {"", "b", 14.3}, {"", "c", -2.6}, {"", "d", 1.5}});
  EXPECT_EQ(terms_of(main_shares(yaw, 14.3)), (Names{"b", "c", "a"})) << "three at most";
  const Attribution small = make("roll", {{"", "a", 1.0}, {"", "b", 0.049}, {"", "c", -0.051}});
  EXPECT_EQ(terms_of(main_shares(small, 14.3)), (Names{"a", "c"})) << "5 % of the first";
  EXPECT_EQ(main_shares(small, 99.0).size(), 2U);
  EXPECT_TRUE(main_shares(small, 101.0).empty()) << "1 % of the scale";
  EXPECT_TRUE(main_shares(make("idle", {}), 1.0).empty());
}

TEST(Attribution, TasksKeepApartAndAddUp) {
  std::vector<Attribution> all{make("yaw", {{"pace", "travel", 2.0}})};
  merge_attributions(
      all, {make("yaw", {{"walk", "travel", -3.0}}), make("roll", {{"walk", "travel", 1.0}})});
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].total("pace"), 2.0);
  EXPECT_EQ(all[0].total("walk"), -3.0);
  EXPECT_EQ(all[0].total(), -1.0);
  EXPECT_EQ(all[0].shares[0].task, "walk") << "the largest first";
  EXPECT_EQ(all[1].parameter, "roll");
  EXPECT_EQ(largest_share(all), 3.0);
  EXPECT_EQ(largest_share({}), 0.0);
}

TEST(Attribution, SummarySaysWhatIsNotExplained) {
  const std::vector<Attribution> all{make("yaw", {{"", "a", 6.0}, {"", "b", -1.0}}),
                                     make("roll", {{"", "b", -2.0}, {"", "a", 1.0}}),
                                     make("pitch", {{"", "a", 2.0}, {"", "c", 0.4}}),
                                     make("length", {{"", "d", 3.0}})};
  const auto summary = summarise(all, 9.5);
  ASSERT_TRUE(summary);
  EXPECT_NEAR(summary->decrease, 9.4, 1e-12);
  EXPECT_FALSE(summary->partial);
  EXPECT_EQ(terms_of(summary->terms), (Names{"a", "b", "d"})) << "c is below 5 % of a";
  EXPECT_EQ(summary->terms[0].decrease, 9.0);
  EXPECT_EQ(summary->terms[1].decrease, -3.0);
  ASSERT_EQ(summary->parameters.size(), 2U);
  EXPECT_EQ(summary->parameters[0].first, "yaw");
  EXPECT_EQ(summary->parameters[0].second, 5.0);
  EXPECT_EQ(summary->parameters[1].first, "length");
  EXPECT_TRUE(summarise(all, 12.0)->partial);
  EXPECT_FALSE(summarise(all, 10.0)->partial);
  EXPECT_FALSE(summarise(all, std::nullopt)->partial);
  EXPECT_FALSE(summarise({}, 1.0));
  EXPECT_FALSE(summarise({make("idle", {})}, 1.0));
  EXPECT_TRUE(summarise({make("worse", {{"", "a", -1.0}})}, std::nullopt)->parameters.empty());
}

TEST(Attribution, EffectsGoByDecreaseThenByShareOfTheRange) {
  const std::vector<ParameterEffect> effects{{-0.5, 0.9}, {0.0, 0.1}, {2.0, 0.1}, {0.0, 0.5}};
  EXPECT_EQ(order_of_effects(effects), (std::vector<std::size_t>{2, 3, 1, 0}));
  EXPECT_TRUE(order_of_effects({}).empty());
}

TEST(Attribution, MainEffectsAreFewAndAboveTheThreshold) {
  EXPECT_EQ(count_main_effects({{2.0, 0.1}, {0.11, 0.1}, {0.09, 0.1}}, true), 2U);
  EXPECT_EQ(count_main_effects({{2.0, 0.1}, {1.0, 0.1}, {0.5, 0.1}, {0.4, 0.1}}, true), 3U);
  EXPECT_EQ(count_main_effects({{0.0, 0.9}, {0.0, 0.5}, {0.0, 0.1}, {0.0, 0.0}}, false), 3U);
  EXPECT_EQ(count_main_effects({{2.0, 0.1}}, true), 1U);
  EXPECT_EQ(count_main_effects({}, true), 0U);
}

}  // namespace
}  // namespace legwright
