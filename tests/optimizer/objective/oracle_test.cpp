// SPDX-License-Identifier: Apache-2.0
// F against an independent implementation with automatic derivatives, on stored samples
// (tests/oracle/README.md).
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "optimizer/objective/objective.hpp"
#include "optimizer/terms/registry.hpp"
#include "tests/support/paths.hpp"
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
struct OraclePoint {
  VectorXd s, m;
  MatrixXd components;  // ∂(the oracle's s)/∂s: the oracle has axis components where we have angles
};

/// Angles from axis components: a = R_z(α) R_x(β) ŷ = (−sin α cos β, cos α cos β, sin β).
OraclePoint to_oracle_point(const json& sample) {
  const json& design = sample["design"];
  const VectorXd piston =
      design.contains("piston_lower") ? to_vector(design["piston_lower"]) : VectorXd();
  const Eigen::Index last = 2 + piston.size();  // body and pistons are the same in both
  OraclePoint point{VectorXd(36 + last), to_vector(sample["m"]),
                    MatrixXd::Zero(48 + last, 36 + last)};
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
  point.s.tail(last) << design["body_width"].get<double>(), design["body_length"].get<double>(),
      piston;
  point.components.bottomRightCorner(last, last).setIdentity();
  return point;
}

Vector3d to_vector3(const json& array) { return to_vector(array); }

std::vector<Eigen::Vector2d> to_places(const json& array) {
  std::vector<Eigen::Vector2d> places;
  for (const json& place : array) places.emplace_back(to_vector(place));
  return places;
}

std::vector<CycleTarget> to_cycle_targets(const json& array) {
  std::vector<CycleTarget> targets(array.size());
  for (std::size_t k = 0; k < array.size(); ++k) {
    if (array[k].is_null()) continue;
    targets[k].weight = array[k]["weight"].get<double>();
    for (const json& pair : array[k]["over_cycle"]) {
      targets[k].phases.push_back(pair[0].get<double>());
      targets[k].values.push_back(pair[1].get<double>());
    }
  }
  return targets;
}

/// The robot of a document. What the equipped one has beyond the plain one is that of
/// tests/support/puppy.hpp; limits are the document's, null where there is none.
test::Puppy make_robot(const json& settings) {
  test::Puppy puppy = test::make_puppy(false);
  if (!settings.contains("equipment")) return puppy;
  test::print_bodies(puppy);
  test::add_pistons(puppy);
  test::add_capsules(puppy);
  test::add_soles(puppy);
  const json& equipment = settings["equipment"];
  for (std::size_t l = 1; l < puppy.morphology.links.size(); ++l) {
    Joint& joint = puppy.morphology.links[l].joint;
    const auto read = [&](const char* key, double& value) {
      const json& stored = equipment[key][(l - 1) % 3];
      if (!stored.is_null()) value = stored.get<double>();
    };
    read("joint_lower", joint.lower);
    read("joint_upper", joint.upper);
    read("torque_limit", joint.torque_limit);
    read("armature", joint.armature);
    read("damping", joint.damping);
    read("stiffness", joint.stiffness);
    read("slack_angle", joint.slack_angle);
    read("friction_loss", joint.friction_loss);
  }
  return puppy;
}

/// The task of a document, without weights.
Task make_task(const json& settings) {
  const auto number = [](const json& in, const char* key) { return in[key].get<double>(); };
  Task task;
  task.gait = Gait({"oracle", settings["phase"], number(settings, "duty")},
                   number(settings, "period"), settings["knots"], {0, 1, 2, 3});
  task.velocity = to_vector(settings["velocity"]);
  task.turn_rate = number(settings, "turn_rate");
  task.up = to_vector3(settings["up"]);
  task.com_height = number(settings, "com_height");
  task.footprint = to_places(settings["footprint"]);
  task.follow_hips = settings["follow_hips"].get<bool>();
  task.min_normal = number(settings, "min_normal");
  task.friction = number(settings, "friction");
  task.swing_height = number(settings, "swing_height");
  task.planted_margin = settings["planted_margin"];
  task.barrier_edge = number(settings, "barrier_edge");
  if (!settings.contains("equipment")) return task;
  const json& equipment = settings["equipment"];
  const json& payload = equipment["payload"];
  task.payload = Payload{number(payload, "mass"), to_vector3(payload["position"]),
                         to_vector3(payload["size"])};
  task.joint_margin = number(equipment, "joint_margin");
  task.torque_margin = number(equipment, "torque_margin");
  task.clearance = number(equipment, "clearance");
  task.com_heights = equipment["com_heights"].get<std::vector<double>>();
  task.com_path = to_places(equipment["com_path"]);
  for (const json& targets : equipment["foot_targets"])
    task.foot_targets.push_back(to_places(targets));
  task.foot_heights = to_cycle_targets(equipment["foot_heights"]);
  task.joint_angles = to_cycle_targets(equipment["joint_angles"]);
  if (equipment["constant_inertia"].get<bool>()) task.dynamics = Dynamics::constant_inertia;
  return task;
}

/// The part of F with the oracle's weights in which `keep` holds for a term. Terms that the
/// document does not name weigh nothing.
Objective part_of_objective(const json& file, const test::Puppy& puppy,
                            const std::function<bool(const std::string&)>& keep) {
  const json &settings = file["settings"], &weights = settings["weights"];
  Task task = make_task(settings);
  for (const TermEntry& entry : term_registry()) {
    const std::string name(entry.name);
    task.weights[name] = weights.contains(name) && keep(name) ? weights[name].get<double>() : 0.0;
  }
  return Objective(as_in_task(puppy.morphology, task), puppy.space, task);
}

Objective whole_objective(const json& file) {
  return part_of_objective(file, make_robot(file["settings"]),
                           [](const std::string&) { return true; });
}

Objective one_term(const json& file, const std::string& only, const test::Puppy& puppy) {
  return part_of_objective(file, puppy, [&](const std::string& term) { return term == only; });
}

double relative(double a, double b) { return std::abs(a - b) / std::max(1e-300, std::abs(b)); }
double relative(const VectorXd& a, const VectorXd& b) {
  return (a - b).norm() / std::max(1e-300, b.norm());
}

json read_document(const std::string& name) {
  const std::string path = test::source_dir() + "/tests/oracle/data/" + name + ".json";
  std::ifstream stream(path);
  if (!stream) throw std::runtime_error("cannot read " + path);
  return json::parse(stream);
}

class Oracle : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    file_ = read_document(GetParam());
    ASSERT_EQ(file_["schema"], "legwright/oracle-samples");
    ASSERT_EQ(file_["version"], 2);
  }
  /// Samples with second derivatives and gradients by term.
  int full_samples() const { return file_["settings"].contains("equipment") ? 1 : 2; }

  json file_;
};

TEST_P(Oracle, TermsAgree) {
  const Objective objective = whole_objective(file_);
  for (const json& sample : file_["samples"]) {
    const OraclePoint point = to_oracle_point(sample);
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
  double tolerance = kDerivative;
  const auto agree = [&](const VectorXd& ours, const VectorXd& expected) {
    ++compared;
    return expected.norm() == 0.0 ? ours.norm() == 0.0 : relative(ours, expected) < tolerance;
  };
  for (const auto& [name, weight] : file_["settings"]["weights"].items()) {
    const Objective objective = one_term(file_, name, make_robot(file_["settings"]));
    for (const json& sample : file_["samples"]) {
      if (!sample.contains("term_gradients_m")) continue;
      // Residuals of a plan are small differences of large numbers.
      tolerance = sample["label"] == "a plan" ? 10.0 * kDerivative : kDerivative;
      const OraclePoint point = to_oracle_point(sample);
      const Evaluation at = objective.evaluate(point.s, point.m, Order::gradients);
      EXPECT_TRUE(
          agree(at.stationarity, to_dense(sample["term_gradients_m"][name], point.m.size())))
          << name << " by m at " << sample["label"];
      EXPECT_TRUE(agree(at.partial_s,
                        point.components.transpose() *
                            to_dense(sample["term_gradients_s"][name], point.components.rows())))
          << name << " by s at " << sample["label"];
    }
  }
  EXPECT_EQ(compared, 2 * full_samples() * static_cast<int>(file_["settings"]["weights"].size()));
}

TEST_P(Oracle, HessianTimesDirectionAgrees) {
  const Objective objective = whole_objective(file_);
  int compared = 0;
  for (const json& sample : file_["samples"]) {
    const OraclePoint point = to_oracle_point(sample);
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
  EXPECT_EQ(compared, full_samples());
}

TEST_P(Oracle, NoticesAChangedWeight) {  // negative control
  json changed = file_;
  changed["settings"]["weights"]["stance_foot"] =
      1.01 * file_["settings"]["weights"]["stance_foot"].get<double>();
  const Objective objective = whole_objective(changed);
  const json& sample = file_["samples"][0];
  const OraclePoint point = to_oracle_point(sample);
  const Evaluation at = objective.evaluate(point.s, point.m, Order::gradient);
  EXPECT_GT(relative(at.value, sample["F"].get<double>()), kValue);
  EXPECT_GT(relative(at.stationarity, to_vector(sample["gradient_m"])), kDerivative);
}

TEST_P(Oracle, NoticesForcesThatActElsewhere) {  // negative control: in the centres of the balls
  test::Puppy puppy = make_robot(file_["settings"]);
  for (Foot& foot : puppy.morphology.feet) foot.radius = 0.0;
  const Objective objective = one_term(file_, "torque_balance", puppy);
  const json& sample = file_["samples"][0];
  const OraclePoint point = to_oracle_point(sample);
  const Evaluation at = objective.evaluate(point.s, point.m, Order::gradient);
  EXPECT_GT(relative(at.stationarity,
                     to_dense(sample["term_gradients_m"]["torque_balance"], point.m.size())),
            kDerivative);
}

INSTANTIATE_TEST_SUITE_P(Tasks, Oracle,
                         testing::Values("puppy_walk", "puppy_trot", "equipped_turn",
                                         "constant_turn"));

TEST(OracleDocuments, NoticeEachSettingOfTheEquippedRobot) {  // negative control
  const json file = read_document("equipped_turn");
  const json& sample = file["samples"][0];
  const OraclePoint point = to_oracle_point(sample);
  const auto worst = [&](const json& document) {
    double most = 0.0;
    for (const TermValue& term : whole_objective(document).terms(point.s, point.m))
      most = std::max(most, relative(term.value, sample["terms"][std::string(term.name)]));
    return most;
  };
  ASSERT_LT(worst(file), kValue);
  for (const char* path : {"/velocity/0",
                           "/turn_rate",
                           "/up/0",
                           "/swing_height",
                           "/friction",
                           "/min_normal",
                           "/barrier_edge",
                           "/footprint/0/0",
                           "/equipment/payload/mass",
                           "/equipment/payload/position/0",
                           "/equipment/payload/size/0",
                           "/equipment/joint_lower/0",
                           "/equipment/joint_upper/0",
                           "/equipment/torque_limit/0",
                           "/equipment/armature/0",
                           "/equipment/damping/0",
                           "/equipment/stiffness/0",
                           "/equipment/slack_angle/0",
                           "/equipment/friction_loss/0",
                           "/equipment/joint_margin",
                           "/equipment/torque_margin",
                           "/equipment/clearance",
                           "/equipment/com_heights/0",
                           "/equipment/com_path/0/0",
                           "/equipment/foot_targets/1/0/0",
                           "/equipment/foot_heights/2/weight",
                           "/equipment/foot_heights/2/over_cycle/1/0",
                           "/equipment/foot_heights/2/over_cycle/1/1",
                           "/equipment/joint_angles/11/weight",
                           "/equipment/joint_angles/11/over_cycle/2/1"}) {
    json changed = file;
    json& number = changed["settings"].at(json::json_pointer(path));
    number = 1.01 * number.get<double>();
    EXPECT_GT(worst(changed), kValue) << path;
  }
  json changed = file;
  changed["settings"]["follow_hips"] = false;
  EXPECT_GT(worst(changed), kValue);
}

TEST(OracleDocuments, NoticeWhichTorqueBalanceIsMeant) {  // negative control
  json changed = read_document("constant_turn");
  const json& sample = changed["samples"][0];
  const OraclePoint point = to_oracle_point(sample);
  const double stored = sample["F"].get<double>();
  const auto value = [&] {
    return whole_objective(changed).evaluate(point.s, point.m, Order::value).value;
  };
  EXPECT_LT(relative(value(), stored), kValue);
  changed["settings"]["equipment"]["constant_inertia"] = false;
  EXPECT_GT(relative(value(), stored), kValue);
}

TEST(OracleDocuments, NameEveryTerm) {
  std::set<std::string> named, ours;
  for (const char* name : {"puppy_walk", "puppy_trot", "equipped_turn"}) {
    const json document = read_document(name);
    for (const auto& [term, weight] : document["settings"]["weights"].items()) named.insert(term);
  }
  for (const TermEntry& entry : term_registry()) ours.emplace(entry.name);
  EXPECT_EQ(named, ours);
}

}  // namespace
}  // namespace legwright
