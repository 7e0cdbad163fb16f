// SPDX-License-Identifier: Apache-2.0
// F against an independent implementation with automatic derivatives, on stored samples
// (tests/oracle/README.md).
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "optimizer/objective/objective.hpp"
#include "tests/support/puppy.hpp"

namespace legwright {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using nlohmann::json;

constexpr int kLengths = 12, kAxes = 12;
constexpr double kValue = 1e-9, kDerivative = 1e-8;  // agreement, relative

VectorXd to_vector(const json& array) {
  VectorXd v(static_cast<int>(array.size()));
  for (int k = 0; k < v.size(); ++k) v[k] = array[k].get<double>();
  return v;
}

/// A gradient of which only the entries that are not zero are stored.
VectorXd to_dense(const json& sparse, Eigen::Index size) {
  VectorXd v = VectorXd::Zero(size);
  for (std::size_t k = 0; k < sparse["index"].size(); ++k)
    v[sparse["index"][k].get<int>()] = sparse["value"][k].get<double>();
  return v;
}

/// A stored sample as our s and m.
struct Point {
  VectorXd s, m;
  MatrixXd components;  // ∂(the oracle's s)/∂s: the oracle has axis components where we have angles
};

/// Angles from axis components: a = R_z(α) R_x(β) ŷ = (−sin α cos β, cos α cos β, sin β).
Point to_point(const json& sample) {
  const json& design = sample["design"];
  Point point{VectorXd(38), to_vector(sample["m"]), MatrixXd::Zero(50, 38)};
  for (int k = 0; k < kLengths; ++k) {
    point.s[k] = design["lengths"][k / 3][k % 3].get<double>();
    point.components(k, k) = 1.0;
  }
  for (int k = 0; k < kAxes; ++k) {
    const VectorXd axis = to_vector(design["axes"][k / 3][k % 3]).normalized();
    const double a = std::atan2(-axis[0], axis[1]), b = std::asin(axis[2]);
    const int angle = kLengths + 2 * k, row = kLengths + 3 * k;
    point.s.segment<2>(angle) << a, b;
    point.components.block<3, 1>(row, angle) =
        Vector3d(-std::cos(a) * std::cos(b), -std::sin(a) * std::cos(b), 0.0);
    point.components.block<3, 1>(row, angle + 1) =
        Vector3d(std::sin(a) * std::sin(b), -std::cos(a) * std::sin(b), std::cos(b));
  }
  point.s.tail<2>() << design["body_width"].get<double>(), design["body_length"].get<double>();
  point.components.bottomRightCorner<2, 2>().setIdentity();
  return point;
}

/// The part of F with the oracle's weights in which `keep` holds for a term. Terms that the oracle
/// does not know weigh nothing.
Objective part_of_objective(const json& file, const test::Puppy& puppy,
                            const std::function<bool(const std::string&)>& keep) {
  Task task = test::make_sideways_task(file["name"] == "puppy_trot");
  task.barrier_edge = file["settings"]["barrier_edge"].get<double>();
  const json& weights = file["settings"]["weights"];
  for (const std::string_view term :
       Objective(puppy.morphology, puppy.space, test::make_sideways_task(false)).term_names()) {
    const std::string name(term);
    task.weights[name] = weights.contains(name) && keep(name) ? weights[name].get<double>() : 0.0;
  }
  return Objective(puppy.morphology, puppy.space, task);
}

Objective whole_objective(const json& file) {
  return part_of_objective(file, test::make_puppy(false), [](const std::string&) { return true; });
}

Objective one_term(const json& file, const std::string& only,
                   const test::Puppy& puppy = test::make_puppy(false)) {
  return part_of_objective(file, puppy, [&](const std::string& term) { return term == only; });
}

double relative(double a, double b) { return std::abs(a - b) / std::max(1e-300, std::abs(b)); }
double relative(const VectorXd& a, const VectorXd& b) {
  return (a - b).norm() / std::max(1e-300, b.norm());
}

class Oracle : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const std::string name =
        std::string(LEGWRIGHT_SOURCE_DIR) + "/tests/oracle/data/" + GetParam() + ".json";
    std::ifstream stream(name);
    ASSERT_TRUE(stream) << name;
    file_ = json::parse(stream);
    ASSERT_EQ(file_["schema"], "legwright/oracle-samples");
    ASSERT_EQ(file_["version"], 2);
  }
  json file_;
};

TEST_P(Oracle, TermsAgree) {
  const Objective objective = whole_objective(file_);
  for (const json& sample : file_["samples"]) {
    const Point point = to_point(sample);
    std::map<std::string, double> ours;
    for (const TermValue& term : objective.terms(point.s, point.m))
      ours.emplace(term.name, term.value);
    EXPECT_EQ(sample["terms"].size(), file_["settings"]["weights"].size());
    for (const auto& [name, value] : sample["terms"].items())
      EXPECT_LT(relative(ours.at(name), value.get<double>()), kValue)
          << name << " at " << sample["label"];
    EXPECT_LT(relative(objective.evaluate(point.s, point.m, Order::value).value,
                       sample["F"].get<double>()),
              kValue);
  }
}

TEST_P(Oracle, GradientsAgreeTermByTerm) {
  int compared = 0;
  const auto agree = [&compared](const VectorXd& ours, const VectorXd& expected) {
    ++compared;
    return expected.norm() == 0.0 ? ours.norm() == 0.0 : relative(ours, expected) < kDerivative;
  };
  for (const auto& [name, weight] : file_["settings"]["weights"].items()) {
    const Objective objective = one_term(file_, name);
    for (const json& sample : file_["samples"]) {
      if (!sample.contains("term_gradients_m")) continue;
      const Point point = to_point(sample);
      const Evaluation at = objective.evaluate(point.s, point.m, Order::gradients);
      EXPECT_TRUE(
          agree(at.stationarity, to_dense(sample["term_gradients_m"][name], point.m.size())))
          << name << " by m at " << sample["label"];
      EXPECT_TRUE(agree(at.partial_s, point.components.transpose() *
                                          to_dense(sample["term_gradients_s"][name], 50)))
          << name << " by s at " << sample["label"];
    }
  }
  EXPECT_GE(compared, 4 * 20);
}

TEST_P(Oracle, HessianTimesDirectionAgrees) {
  const Objective objective = whole_objective(file_);
  int compared = 0;
  for (const json& sample : file_["samples"]) {
    const Point point = to_point(sample);
    const Evaluation at = objective.evaluate(point.s, point.m, Order::design);
    const MatrixXd by_angles = point.components.transpose();
    EXPECT_LT(relative(at.stationarity, to_vector(sample["gradient_m"])), kDerivative);
    EXPECT_LT(relative(at.partial_s, by_angles * to_vector(sample["gradient_s"])), kDerivative);
    if (!sample.contains("direction_m")) continue;
    ++compared;
    const VectorXd direction = to_vector(sample["direction_m"]);
    const VectorXd by_m = at.hessian_mm.selfadjointView<Eigen::Lower>() * direction;
    EXPECT_LT(relative(by_m, to_vector(sample["hessian_mm_direction"])), kDerivative);
    EXPECT_LT(relative(at.hessian_ms.transpose() * direction,
                       by_angles * to_vector(sample["hessian_sm_direction"])),
              kDerivative);
  }
  EXPECT_EQ(compared, 2);
}

TEST_P(Oracle, NoticesAChangedWeight) {  // negative control
  json changed = file_;
  changed["settings"]["weights"]["stance_foot"] =
      1.01 * file_["settings"]["weights"]["stance_foot"].get<double>();
  const Objective objective = whole_objective(changed);
  const json& sample = file_["samples"][0];
  const Point point = to_point(sample);
  const Evaluation at = objective.evaluate(point.s, point.m, Order::gradient);
  EXPECT_GT(relative(at.value, sample["F"].get<double>()), kValue);
  EXPECT_GT(relative(at.stationarity, to_vector(sample["gradient_m"])), kDerivative);
}

TEST_P(Oracle, NoticesForcesThatActElsewhere) {  // negative control: in the centres of the balls
  test::Puppy puppy = test::make_puppy(false);
  for (Foot& foot : puppy.morphology.feet) foot.radius = 0.0;
  const Objective objective = one_term(file_, "torque_balance", puppy);
  const json& sample = file_["samples"][0];
  const Point point = to_point(sample);
  const Evaluation at = objective.evaluate(point.s, point.m, Order::gradient);
  EXPECT_GT(relative(at.stationarity,
                     to_dense(sample["term_gradients_m"]["torque_balance"], point.m.size())),
            kDerivative);
}

INSTANTIATE_TEST_SUITE_P(Tasks, Oracle, testing::Values("puppy_walk", "puppy_trot"));

}  // namespace
}  // namespace legwright
