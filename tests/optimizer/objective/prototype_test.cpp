// SPDX-License-Identifier: Apache-2.0
// F against an independent implementation with automatic derivatives, on stored samples (tests/data/README.md).
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

using Eigen::VectorXd;
using nlohmann::json;

VectorXd to_vector(const json& array) {
  VectorXd v(static_cast<int>(array.size()));
  for (int k = 0; k < v.size(); ++k) v[k] = array[k].get<double>();
  return v;
}

/// A gradient of which only the entries that are not zero are stored.
VectorXd to_dense(const json& sparse, int size) {
  VectorXd v = VectorXd::Zero(size);
  for (std::size_t k = 0; k < sparse["index"].size(); ++k)
    v[sparse["index"][k].get<int>()] = sparse["value"][k].get<double>();
  return v;
}

/// The stored design as our s: angles from axis components, a = R_z(α) R_x(β) ŷ = (−sin α cos β, cos α cos β, sin β).
VectorXd to_design(const json& design) {
  VectorXd s(38);
  for (int leg = 0; leg < 4; ++leg)
    for (int k = 0; k < 3; ++k) {
      s[3 * leg + k] = design["lengths"][leg][k].get<double>();
      const VectorXd axis = to_vector(design["axes"][leg][k]).normalized();
      s[12 + 2 * (3 * leg + k)] = std::atan2(-axis[0], axis[1]);
      s[12 + 2 * (3 * leg + k) + 1] = std::asin(axis[2]);
    }
  s[36] = design["body_width"].get<double>();
  s[37] = design["body_length"].get<double>();
  return s;
}

/// Our terms that make up one term of the reference.
const std::map<std::string, std::vector<std::string>> kTerms{
    {"travel", {"travel"}},
    {"turn", {"turning"}},
    {"com_position", {"com_position"}},
    {"com", {"style_com"}},
    {"orientation", {"trunk_orientation"}},
    {"nominal_pose", {"nominal_pose"}},
    {"kinematics", {"foot_position"}},
    {"footprint", {"style_foot"}},
    {"dynamics", {"force_balance", "torque_balance"}},
    {"smooth", {"smoothness"}},
    {"ground", {"ground_height"}},
    {"slip", {"stance_foot"}},
    {"swing_height", {"swing_height"}},
    {"cone", {"friction_cone"}},
    {"min_normal", {"least_normal_force"}},
    {"force", {"force_size"}},
    {"force_rate", {"force_smoothness"}},
    {"periodic", {"periodicity"}},
    {"design", {"design_tether"}},
};

/// The part of F with the reference's weights in which `keep` holds for a reference term. The reference lets forces act
/// at the centres of the balls, which is where balls without radius touch: so are those of its dynamics here.
Objective part_of_objective(const json& file, const std::function<bool(const std::string&)>& keep,
                            bool dynamics) {
  test::Puppy puppy = test::make_puppy(false);
  if (dynamics)
    for (Foot& foot : puppy.morphology.feet) foot.radius = 0.0;
  Task task = test::make_sideways_task(file["name"] == "puppy_trot");
  for (const char* ours_alone : {"limb_clearance", "torque_limits"}) task.weights[ours_alone] = 0.0;
  task.barrier_edge = file["settings"]["barrier_edge"].get<double>();
  for (const auto& [reference, ours] : kTerms)
    for (const std::string& name : ours)
      task.weights[name] =
          keep(reference) ? file["settings"]["weights"][reference].get<double>() : 0.0;
  return Objective(puppy.morphology, puppy.space, task);
}

Objective make_objective(const json& file, const std::string& only) {
  return part_of_objective(
      file, [&](const std::string& term) { return term == only; }, only == "dynamics");
}

/// F of the reference: its dynamics and the rest.
struct ReferenceObjective {
  explicit ReferenceObjective(const json& file)
      : dynamics(make_objective(file, "dynamics")),
        rest(part_of_objective(
            file, [](const std::string& term) { return term != "dynamics"; }, false)) {}

  std::map<std::string, double> terms(const VectorXd& s, const VectorXd& m) const {
    std::map<std::string, double> out;
    for (const Objective* part : {&dynamics, &rest})
      for (const TermValue& term : part->terms(s, m)) out[std::string(term.name)] += term.value;
    return out;
  }
  double value(const VectorXd& s, const VectorXd& m) const {
    return dynamics.evaluate(s, m, Order::value).value + rest.evaluate(s, m, Order::value).value;
  }
  VectorXd gradient(const VectorXd& s, const VectorXd& m) const {
    return dynamics.evaluate(s, m, Order::gradient).stationarity +
           rest.evaluate(s, m, Order::gradient).stationarity;
  }
  VectorXd hessian_times(const VectorXd& s, const VectorXd& m, const VectorXd& v) const {
    VectorXd out = VectorXd::Zero(v.size());
    for (const Objective* part : {&dynamics, &rest}) {
      const Evaluation at = part->evaluate(s, m, Order::hessian);
      out += at.hessian_mm.selfadjointView<Eigen::Lower>() * v;
    }
    return out;
  }

  Objective dynamics, rest;
};

double relative(double a, double b) { return std::abs(a - b) / std::max(1e-300, std::abs(b)); }
double relative(const VectorXd& a, const VectorXd& b) {
  return (a - b).norm() / std::max(1e-300, b.norm());
}

class Prototype : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const std::string name =
        std::string(LEGWRIGHT_SOURCE_DIR) + "/tests/data/prototype/" + GetParam() + ".json";
    std::ifstream stream(name);
    ASSERT_TRUE(stream) << name;
    file_ = json::parse(stream);
  }
  json file_;
};

TEST_P(Prototype, TermsAgree) {
  const ReferenceObjective objective(file_);
  for (const json& sample : file_["samples"]) {
    const auto ours = objective.terms(to_design(sample["design"]), to_vector(sample["m"]));
    for (const auto& [reference, names] : kTerms) {
      double sum = 0.0;
      for (const std::string& name : names) sum += ours.at(name);
      EXPECT_LT(relative(sum, sample["terms"][reference].get<double>()), 1e-9) << reference;
    }
  }
}

TEST_P(Prototype, GradientsAgreeTermByTerm) {
  for (const auto& [reference, names] : kTerms) {
    const Objective objective = make_objective(file_, reference);
    for (const json& sample : file_["samples"]) {
      if (!sample.contains("term_gradients_m") || !sample["term_gradients_m"].contains(reference))
        continue;
      const VectorXd expected =
          to_dense(sample["term_gradients_m"][reference], static_cast<int>(sample["m"].size()));
      const Evaluation at =
          objective.evaluate(to_design(sample["design"]), to_vector(sample["m"]), Order::gradient);
      if (expected.norm() == 0.0)
        EXPECT_EQ(at.stationarity.norm(), 0.0) << reference;
      else
        EXPECT_LT(relative(at.stationarity, expected), 1e-8) << reference;
    }
  }
}

TEST_P(Prototype, HessianTimesDirectionAgrees) {
  const ReferenceObjective objective(file_);
  for (const json& sample : file_["samples"]) {
    const VectorXd s = to_design(sample["design"]), m = to_vector(sample["m"]);
    EXPECT_LT(relative(objective.gradient(s, m), to_vector(sample["gradient_m"])), 1e-8);
    if (!sample.contains("direction_m")) continue;
    const VectorXd product = objective.hessian_times(s, m, to_vector(sample["direction_m"]));
    EXPECT_LT(relative(product, to_vector(sample["hessian_mm_direction"])), 1e-8);
  }
}

TEST_P(Prototype, NoticesAChangedWeight) {  // negative control
  json changed = file_;
  changed["settings"]["weights"]["slip"] =
      1.01 * file_["settings"]["weights"]["slip"].get<double>();
  const ReferenceObjective objective(changed);
  const json& sample = file_["samples"][0];
  const VectorXd s = to_design(sample["design"]), m = to_vector(sample["m"]);
  EXPECT_GT(relative(objective.value(s, m), sample["F"].get<double>()), 1e-9);
  EXPECT_GT(relative(objective.gradient(s, m), to_vector(sample["gradient_m"])), 1e-8);
}

TEST_P(Prototype, NoticesForcesThatActElsewhere) {  // negative control
  const Objective whole = part_of_objective(
      file_, [](const std::string&) { return true; }, false);
  const json& sample = file_["samples"][0];
  const Evaluation at =
      whole.evaluate(to_design(sample["design"]), to_vector(sample["m"]), Order::gradient);
  EXPECT_GT(relative(at.stationarity, to_vector(sample["gradient_m"])), 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Tasks, Prototype, testing::Values("puppy_walk", "puppy_trot"));

}  // namespace
}  // namespace legwright
